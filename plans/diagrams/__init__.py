"""Kinematic diagrams of the output (кинематические диаграммы)."""
