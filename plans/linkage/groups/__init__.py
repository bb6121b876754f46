"""The Assur groups of class II, one kind a file (структурные группы)."""
