"""Kinematic diagrams: rows over the turn, their table, report, what is due (кинематические диаграммы)."""
