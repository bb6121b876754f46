"""The guard before TOML is read: texts on which tomllib would spend minutes or gigabytes are refused at a glance."""

from __future__ import annotations

import re

from geometry.errors import LimitError
from plans.scene.places import line_column
from plans.words.words import Message, message, placed

# tomllib needs time and memory growing with the square of a dotted key's parts, and recurses into brackets.
PARTS_LIMIT = 16
NESTING_LIMIT = 32
MARKS_LIMIT = 150_000  # commas, equals signs and brackets: room for 100,000 positions; tomllib reads as many in 0.3 s

STRING = r"\"\"\"(?:[^\"\\]|\\.|\"(?!\"\"))*+(?:\"{3,5}|\\?\Z)|'''(?:[^']|'(?!''))*+(?:'{3,5}|\Z)"
STRING += r"|\"(?:[^\"\\\n]|\\[^\n])*+\"?|'[^'\n]*+'?"
_PART = r"(?:[A-Za-z0-9_-]++|\"(?:[^\"\\\n]|\\[^\n])*+\"|'[^'\n]*+')"
# What a pre-scan has to see: comments and strings to skip, too long dotted keys, brackets.
GUARD = re.compile(
    rf"(?P<comment>#[^\n]*)|(?P<dotted>(?<![A-Za-z0-9_-])(?:{_PART}[ \t]*+\.[ \t]*+){{{PARTS_LIMIT}}})"
    rf"|(?P<string>{STRING})|(?P<opens>[\[{{])|(?P<closes>[\]}}])",
    re.DOTALL,
)


def guard(text: str, file: str) -> None:
    """See that a text is within the limits of what tomllib reads at once."""
    marks = sum(text.count(mark) for mark in ",=[{")
    if marks > MARKS_LIMIT:
        raise LimitError(placed(file, message("limit.marks", count=marks, limit=MARKS_LIMIT)))
    depth = 0
    for token in GUARD.finditer(text):
        kind = token.lastgroup
        if kind == "dotted":
            _limit(text, file, token.start(), message("limit.parts", limit=PARTS_LIMIT))
        depth += {"opens": 1, "closes": -1}.get(kind or "", 0)
        if depth > NESTING_LIMIT:
            _limit(text, file, token.start(), message("limit.nesting", limit=NESTING_LIMIT))


def _limit(text: str, file: str, offset: int, what: Message) -> None:
    line, column = line_column(text, offset)
    raise LimitError(placed(f"{file}:{line}:{column}", what))
