"""The self-check of the sheets of a balanced mechanism (проверка листов уравновешивания)."""
