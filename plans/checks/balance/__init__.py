"""Balancing by both roads beside each other (сравнение двух путей)."""
