"""A gear train on its sheet: scheme, triangles of velocities, plan of angular ones, tables (зубчатый механизм)."""
