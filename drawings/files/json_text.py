"""JSON as people read it: letters as they are, wherever the encoding has them."""

from __future__ import annotations

import json
import sys


def json_text(value: object, encoding: str = "utf-8", indent: int | None = None) -> str:
    """Give a value as JSON; letters that the encoding lacks are escaped as JSON does it, all of them together.

    >>> json_text(["ползун"]), json_text(["ползун é"], "latin-1")
    ('["ползун"]', '["\\\\u043f\\\\u043e\\\\u043b\\\\u0437\\\\u0443\\\\u043d \\\\u00e9"]')
    """
    text = json.dumps(value, ensure_ascii=False, allow_nan=False, indent=indent)
    try:
        text.encode(encoding)
    except UnicodeEncodeError:
        return json.dumps(value, allow_nan=False, indent=indent)
    return text


def print_json(value: object) -> None:
    """Print a value as JSON."""
    print(json_text(value, getattr(sys.stdout, "encoding", None) or "utf-8"))
