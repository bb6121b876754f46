"""A cam on its sheets: laws, sizes, profile, drawing to be made by, report, what is due (кулачок)."""
