"""The calculation part of a note: equations as figures letter them, with numbers (пояснительная записка)."""
