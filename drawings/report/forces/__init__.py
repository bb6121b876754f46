"""What is told of the forces on a linkage beside its sheets: loads, equations, tables of reactions (записка)."""
