"""The textbook's graphical methods, one technique a file; no drawing here."""
