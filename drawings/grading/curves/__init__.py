"""Grading of figures that are curves and points: graphs over a turn, loops, laws, profiles, bars (графики и точки)."""
