"""Named limits of paper and of sheets read back, each with its reason; and the refusal of what exceeds them."""

from __future__ import annotations

import math

from geometry.errors import DraftError
from plans.words.words import message

# Four decimals of a millimetre: a vector of 2 mm is then read to 7e-5 of itself; an A1 sheet stays under a megabyte.
DECIMALS = 4
# The two ends of a vector are each rounded by half a last digit in x and in y: sqrt(2) digits together at the worst.
QUANTUM = math.sqrt(2) * 10.0**-DECIMALS
# A curve is measured between its points too: drawn at 1:10, it is rounded by a tenth of the usual tolerance of 1e-4 mm.
CURVE_DECIMALS = 6
CURVE_QUANTUM = math.sqrt(2) * 10.0**-CURVE_DECIMALS
# Significant digits of a stated value: its rounding is far under QUANTUM, and float arithmetic far under its rounding.
STATED_DIGITS = 12
# Two divisions of a ruler's half millimetre (mm); a shorter force has no direction to the eye.
SEEN = 1.0
# Of more positions a sheet draws at most so many with all their links, and the others by ticks: they would be one grey.
MANY = 12
# The version of a sheet's data: raised when an older reader would misread it. A reader refuses what is newer.
FORMAT = 1
# Ten times the largest plotter roll (mm): a number beyond it is a mistake, and would be printed as hundreds of digits.
REACH = 1e6

# An A0 sheet with a million digits has 3 MiB; more is an attack or an embedded photograph. Packed and unpacked alike.
SHEET_BYTES = 10 * 1024**2
# Ours have under 20,000; editors add a few each.
SHEET_ELEMENTS = 200_000
# Ours nest 6 deep, editors add layers; recursive readers die near 1,000.
SHEET_DEPTH = 256
# The richest editors write about 40.
ELEMENT_ATTRIBUTES = 256
# Of the marked elements of a sheet together; each command has a character at least.
PATH_COMMANDS = 1_000_000
# Editors flatten their transforms; hand-made lists have under ten.
ELEMENT_TRANSFORMS = 64
# A double needs 17 digits and an exponent; the rest is tolerance for leading and trailing zeros.
NUMERAL_LENGTH = 100
# A style sheet or a description longer than this was not written for a drawing.
TEXT_LENGTH = 64 * 1024
# The JSON description of a sheet with all values of 360 positions.
METADATA_LENGTH = 2 * 1024**2
# Illustrator declares about ten namespaces as entities, each under a hundred characters.
ENTITIES = 64
ENTITY_LENGTH = 200
# Seconds of work on one sheet; the byte limit alone keeps honest files under one second.
READING_SECONDS = 20.0

# A writing that lasts longer than this (seconds) was killed, and its temporary file is an orphan.
ORPHAN_AGE = 3600.0
# A folder with more entries is not only ours; listing it would cost more than an orphan does.
SWEEP_ENTRIES = 10_000


class SheetRefused(DraftError):  # noqa: N818  (the verdict's own word)
    """A sheet that cannot be measured, with the reason in words that its author can act on, by its key."""

    exit_code = 7  # it cannot be read

    def __init__(self, key: str, /, **parts: object) -> None:
        self.reason = message(f"unreadable.{key}", **parts)
        super().__init__(self.reason)


class OverLimit(SheetRefused):
    """A sheet that exceeds one of the limits above."""

    exit_code = 8
