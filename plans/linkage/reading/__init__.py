"""Reading a linkage: its tables in a scene, and the mechanism that they make (чтение механизма)."""
