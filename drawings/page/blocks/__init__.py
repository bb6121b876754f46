"""Title blocks: one file for each standard form."""
