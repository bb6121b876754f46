"""What must stand on the sheets of each kind, by the analysis alone (что должно быть на листах)."""
