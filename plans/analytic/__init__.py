"""The independent road: constraint equations of all joints at once, no groups and no constructions."""
