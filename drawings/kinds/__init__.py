"""Kinds of figures that techniques share: graphs and rows of them, hodographs, polygons, vector plans, charts (виды)."""
