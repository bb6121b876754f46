"""Transfer functions on their sheet: turned plans, graphs, table, what is due (передаточные функции)."""
