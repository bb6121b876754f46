"""Balancing by direct sums, least squares and harmonic analysis (аналитический путь)."""
