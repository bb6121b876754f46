"""Pages: frame, borders, title block, standard scales (лист)."""
