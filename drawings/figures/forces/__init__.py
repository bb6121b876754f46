"""Figures of forces: loading schemes, force plans, the lever (силовые планы)."""
