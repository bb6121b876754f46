"""The self-check of kinematic diagrams: rows, poles, table and notes against the analysis (проверка диаграмм)."""
