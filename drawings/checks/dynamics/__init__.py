"""The self-check of the figures of a machine's motion, stroke by stroke (проверка фигур динамики)."""
