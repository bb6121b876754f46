"""Figures of a linkage: positions, velocity and acceleration plans (планы механизма)."""
