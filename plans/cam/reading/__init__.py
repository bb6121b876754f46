"""Cams read from the scene: forms, angles, ways, laws, and all that is wrong with them (чтение данных кулачков)."""
