"""Forces on their sheet: loading schemes, polygons, lever, report, what is due (силовой расчёт)."""
