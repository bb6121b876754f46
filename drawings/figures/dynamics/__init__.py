"""Figures of the motion of a machine: loads, graphs, the loop, the flywheel (динамика машины)."""
