"""Checks: both roads compared, what vectors must be, sums that must vanish (проверка планов)."""
