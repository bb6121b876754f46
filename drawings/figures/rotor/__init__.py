"""Figures of a rotor: seen along and across its shaft, its polygons, its tables (фигуры ротора)."""
