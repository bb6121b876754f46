"""What is told of a linkage beside its sheets: data, structure, equations of plans, tables of motion (записка)."""
