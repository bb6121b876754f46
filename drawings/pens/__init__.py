"""Pens: one file a format."""
