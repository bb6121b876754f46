"""Scenes: a file is read, checked, and made a model of (сцена)."""
