"""The seal: the last element of a sheet, which tells a whole sheet from a torn one. A checksum, not an authority."""

from __future__ import annotations

import hashlib
import json
import re

_SEAL = re.compile(rb'<metadata id="seal">(\{[^<>]*\})</metadata>\n</svg>\n\Z')


def seal(body: bytes, elements: int) -> bytes:
    """Give the end of a sheet whose elements are all in `body`: its seal and the closing of the root."""
    content = json.dumps({"elements": elements, "sha256": digest(body)}, sort_keys=True)
    return f'<metadata id="seal">{content}</metadata>\n</svg>\n'.encode("ascii")


def digest(content: bytes) -> str:
    """Give the checksum of a file or of a part of it."""
    return hashlib.sha256(content).hexdigest()


def seal_of(source: bytes) -> str | None:
    """Give the checksum that a whole sheet states of itself; None of what is torn, or is no sheet.

    >>> seal_of(b"<svg>" + seal(b"<svg>", 1)) == digest(b"<svg>"), seal_of(b"# Report")
    (True, None)
    """
    found = _SEAL.search(source)
    return digest(source[: found.start()]) if found is not None and sealed(source) else None


def sealed(source: bytes) -> bool:
    """Tell whether a sheet is whole, as its pen wrote it.

    >>> sealed(b"<svg>" + seal(b"<svg>", 1)), sealed(b"<svg> " + seal(b"<svg>", 1)), sealed(b"<svg></svg>")
    (True, False, False)
    """
    found = _SEAL.search(source)
    if found is None:
        return False
    body = source[: found.start()]
    try:
        elements = json.loads(found[1]).get("elements")
    except ValueError:
        return False
    return isinstance(elements, int) and source[found.start() :] == seal(body, elements)
