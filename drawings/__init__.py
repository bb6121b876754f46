"""Paper: figures, sheets, pens, and the command."""

VERSION = "0.1.0"
