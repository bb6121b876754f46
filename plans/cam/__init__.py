"""Cams by construction: laws, main sizes by tangents, profile by inversion (кулачковые механизмы)."""
