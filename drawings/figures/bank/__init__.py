"""Figures of a bank of equal mechanisms: its shaft, star of cranks, polygons, graphs, compensators (фигуры блока)."""
