"""Checks: a written sheet held to the analysis (самопроверка листа)."""
