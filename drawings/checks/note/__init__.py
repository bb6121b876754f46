"""The self-check of a note: its equations and tables are held against the analysis (проверка записки)."""
