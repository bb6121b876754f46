"""A structure on its sheet: scheme, groups drawn apart, the mechanism freed, tables, what is due (структура)."""
