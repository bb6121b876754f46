"""Balancing of mechanisms by main points and counterweights (уравновешивание механизмов; book 8.2.2)."""
