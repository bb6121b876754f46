"""A balanced linkage on its sheet: schemes, polygon, hodograph, costs, report, what is due (уравновешивание)."""
