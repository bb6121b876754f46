"""Paper: strokes in millimetres, widths and sizes of a hand, formats, limits (бумага)."""
