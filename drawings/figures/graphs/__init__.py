"""Graphs: curves over the turn, hodographs (графики)."""
