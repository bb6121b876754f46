"""The bench: every technique's error against its run time, on one scene (испытание: погрешность и время)."""
