"""Measuring: a written sheet is read back as one would read a stranger's (измерение листа)."""
