"""Primary links: the constructions from which all plans of a mechanism start (начальные звенья)."""
