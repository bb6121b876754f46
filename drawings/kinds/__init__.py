"""Kinds of figures of all techniques: graphs, rows, hodographs, polygons, vector plans, charts, schemes (виды фигур)."""
