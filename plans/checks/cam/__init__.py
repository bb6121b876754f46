"""Cams by both roads, compared (сравнение кулачков)."""
