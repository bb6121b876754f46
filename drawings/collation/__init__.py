"""Collation (сверка): a written sheet held line by line against the one that its scene gives."""
