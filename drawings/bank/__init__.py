"""A bank of mechanisms on its sheet: star, shaft, polygons, compensators, report, what is due (блок механизмов)."""
