"""Figures of the cyclogram: the plan of characteristic positions, the bar chart, the circular chart (циклограмма)."""
