"""A rotor on its sheet: view along and across, polygons, tables, report, what is due (ротор)."""
