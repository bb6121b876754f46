"""Files that are no sheets, and what they are, by how they begin (чужие файлы)."""

from __future__ import annotations

_BEGINNINGS = {
    b"%PDF": "pdf", b"PK\x03\x04": "zip", b"\x89PNG": "png", b"\xff\xd8": "jpeg", b"AC10": "dwg", b"%!PS": "postscript",
    b"\xd0\xcf\x11\xe0": "office", b"{\\rtf": "rtf", b"0SECTION": "dxf", b"999": "dxf",
}  # fmt: skip
_LOOKED_AT = 40  # bytes


def foreign(source: bytes) -> str | None:
    """Tell what a file is that is no sheet.

    >>> foreign(b"  0\\r\\nSECTION\\r\\n"), foreign(b"<svg/>")
    ('dxf', None)
    """
    begins = b"".join(source[:_LOOKED_AT].split())  # a DXF indents its numbers as it likes
    return next((what for beginning, what in _BEGINNINGS.items() if begins.startswith(beginning)), None)
