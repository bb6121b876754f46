"""The self-check of a cyclogram: charts, tables, notes, report (проверка циклограммы)."""
