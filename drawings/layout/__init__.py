"""Layout: labels, ink, tables, and how figures share a sheet (компоновка)."""
