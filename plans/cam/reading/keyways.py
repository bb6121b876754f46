"""Keyways in hubs by the diameter of the bore: GOST 23360-78, ISO 773 (шпоночные пазы)."""

from __future__ import annotations

from decimal import Decimal
from typing import Final, NamedTuple


class Keyway(NamedTuple):
    """A keyway for bores above some diameter up to another, mm: its width b, its depth t_2 in the hub."""

    above: int
    most: int
    width: Decimal
    depth: Decimal


# The smallest key is for shafts from 6 mm, that one included.
KEYWAYS: Final = tuple(
    Keyway(above, most, Decimal(width), Decimal(depth))
    for above, most, width, depth in (
        (6, 8, 2, "1.0"), (8, 10, 3, "1.4"), (10, 12, 4, "1.8"), (12, 17, 5, "2.3"), (17, 22, 6, "2.8"),
        (22, 30, 8, "3.3"), (30, 38, 10, "3.3"), (38, 44, 12, "3.3"), (44, 50, 14, "3.8"), (50, 58, 16, "4.3"),
        (58, 65, 18, "4.4"), (65, 75, 20, "4.9"), (75, 85, 22, "5.4"), (85, 95, 25, "5.4"), (95, 110, 28, "6.4"),
        (110, 130, 32, "7.4"), (130, 150, 36, "8.4"), (150, 170, 40, "9.4"), (170, 200, 45, "10.4"),
        (200, 230, 50, "11.4"),
    )
)  # fmt: skip
LEAST, MOST = KEYWAYS[0].above, KEYWAYS[-1].most


def keyway(bore: Decimal) -> Keyway:
    """Give the keyway for a bore, mm; of one that the standard does not reach that of the nearest."""
    return next((row for row in KEYWAYS if bore <= row.most), KEYWAYS[-1])


def standard(bore: Decimal) -> bool:
    """Tell whether the standard has a keyway for a bore, mm."""
    return LEAST <= bore <= MOST
