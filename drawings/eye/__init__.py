"""The eye: a written sheet read back from what is drawn on it, as a stranger sees it (чтение начерченного)."""
