"""Linkages: positions, velocities, accelerations by construction, and how far they reach (рычажный механизм)."""
