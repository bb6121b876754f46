"""Grading: sheets that students hand in, held against the analysis vector by vector (проверка работ)."""
