"""Paper: figures, sheets, pens, and the command."""
