"""Figures of a cam's sheet (фигуры листа кулачка)."""
