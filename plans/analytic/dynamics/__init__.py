"""The other road of machine dynamics: quadrature, roots, differential equations (динамика машины аналитически)."""
