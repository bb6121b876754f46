"""Kinds of figures that techniques share: axes, graphs over a turn, hodographs, rows of graphs (виды фигур)."""
