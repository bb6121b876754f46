"""A linkage on its sheets: positions, velocity and acceleration plans, report, what is due (рычажный механизм)."""
