"""Transfer functions on their sheet: schemes with the turned plan, graphs, table, what is due (передаточные функции)."""
