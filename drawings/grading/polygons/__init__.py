"""Polygons of free vectors and arrows of forces on a sheet: found, and held to be drawn well (многоугольники)."""
