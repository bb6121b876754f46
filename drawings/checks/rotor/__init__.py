"""The self-check of a rotor's figures: views and polygons, stroke by stroke (проверка фигур ротора)."""
