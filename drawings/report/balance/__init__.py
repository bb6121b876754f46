"""What is told of balancing on sheets and in the report: of a mechanism, and of a bank of them (уравновешивание)."""
