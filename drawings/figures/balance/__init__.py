"""Figures of balancing: schemes, static moments, hodographs, main moment, share, tables (фигуры уравновешивания)."""
