"""The textbook's graphical methods, one technique a folder; no drawing here."""
