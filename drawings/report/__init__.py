"""Reports: what was found, in numbers and words (отчёт)."""
