"""How sheets of other hands are seen: units of a page, arrowheads and texts of editors, spellings (чужой лист)."""
