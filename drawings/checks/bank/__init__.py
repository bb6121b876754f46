"""The self-check of what a bank of mechanisms shows (проверка листов блока механизмов)."""
