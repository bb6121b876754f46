"""The profile of a cam by construction: inversion, roller, curvature, contact, extremes, flaws (профиль кулачка)."""
