"""Instant centres on their sheet: schemes, polygon of links, tables, what is due (мгновенные центры)."""
