"""The cyclogram: the plan of characteristic positions, phase and setting angles (циклограмма; book 5.9.2)."""
