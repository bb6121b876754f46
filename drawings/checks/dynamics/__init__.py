"""The self-check of the sheets of a machine's motion and their report (проверка листов динамики)."""
