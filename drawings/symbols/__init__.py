"""Symbols: pairs, arrows, couples, dashes, in millimetres (условные обозначения)."""
