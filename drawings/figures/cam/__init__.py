"""Figures of a cam: its laws, sizes, profile, tables (фигуры кулачка)."""
