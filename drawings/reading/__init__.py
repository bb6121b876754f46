"""Reading: a written sheet read back as one would read a stranger's: seen, and measured (чтение начерченного)."""
