"""A cyclogram on its sheet: bars, rings, characteristic positions, report, what is due (циклограмма)."""
