"""The self-checks of the sheets of balancing: of a mechanism, and of a bank of them (проверка листов)."""
