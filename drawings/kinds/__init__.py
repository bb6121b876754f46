"""Kinds of figures of all techniques: graphs, their rows, hodographs, polygons, vector plans, charts (виды фигур)."""
