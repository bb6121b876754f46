"""The records of techniques whose figures are vectors: of each sheet what must stand on it (записи)."""
