"""Paper: figures, sheets, pens, and the command."""

VERSION = "0.2.0"
