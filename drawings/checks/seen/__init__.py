"""What is seen of a written sheet held against what was laid out (сверка с компоновкой)."""
