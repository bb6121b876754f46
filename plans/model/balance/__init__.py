"""What balancing asks and finds, whichever road found it (уравновешивание)."""
