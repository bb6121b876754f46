"""Kinds of figures of all techniques: graphs, hodographs, polygons, vector plans, charts, schemes (виды фигур)."""
