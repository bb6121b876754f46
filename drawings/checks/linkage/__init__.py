"""The self-check of what a plan of positions and the plans of velocities and accelerations bear (проверка планов)."""
