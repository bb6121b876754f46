"""Mutual balancing of equal mechanisms on one shaft (взаимоуравновешивание; book 8.2.3)."""
