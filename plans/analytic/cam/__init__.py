"""Cams by closed forms and roots, apart from the constructions (кулачковые механизмы, аналитически)."""
