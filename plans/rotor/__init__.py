"""Balancing of rotors by vector polygons: moments first, then forces (уравновешивание роторов)."""
