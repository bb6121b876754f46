"""Grading of tables: cells found by their ruling, numbers read as students write them (таблицы)."""
