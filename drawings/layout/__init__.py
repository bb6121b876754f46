"""Layout: labels, obstacles, tables, and how figures share a sheet (компоновка)."""
