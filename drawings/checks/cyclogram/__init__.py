"""The self-check of the charts of a cyclogram, stroke by stroke (проверка циклограммы)."""
