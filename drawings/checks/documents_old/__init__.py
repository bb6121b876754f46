"""The self-check of the sheets of a set together: their numbers and their scales (комплект документов)."""
