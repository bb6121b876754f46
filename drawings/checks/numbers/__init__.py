"""The self-check of the numbers of positions: which stand where, and which are owed (номера положений)."""
