"""Kinematic diagrams on paper (кинематические диаграммы)."""
