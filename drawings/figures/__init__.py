"""Figures: what a sheet shows, one figure a file (фигуры листа)."""
