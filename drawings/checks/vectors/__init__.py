"""Self-checks of plans of velocities and accelerations on their sheets (планы скоростей и ускорений)."""
