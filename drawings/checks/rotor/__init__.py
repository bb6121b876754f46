"""The self-check of the sheet of a rotor: views, polygons, tables, notes (проверка листа ротора)."""
