"""Given sizes that no cam has together: offset or roller beyond the least radius, a rocker too short (размеры)."""

from __future__ import annotations

from decimal import Decimal

from plans.cam.reading.entry import Entry, shown
from plans.words.words import message


def proportions(entry: Entry) -> None:
    """Put a fault at each of the given sizes that the others do not allow."""
    sizes, follower = entry.form.sizes, entry.form.follower
    if entry.rocks and entry.flat and sizes.centre is None and not entry.doubted("sizes"):
        stated = {"thing": "distance of the centres", "example": 'centre = "150 mm"'}
        entry.fault(("sizes", "centre"), "missing_for", **stated, why=message("why.flat_rocker"))
    if sizes.base is not None and sizes.offset is not None and abs(sizes.offset) >= sizes.base:
        entry.fault(("sizes", "offset"), "offset_beyond", base=_mm(sizes.base), offset=_mm(abs(sizes.offset)))
    if sizes.base is not None and sizes.roller is not None and sizes.roller >= sizes.base and not entry.translates:
        entry.fault(("sizes", "roller"), "roller_beyond", base=_mm(sizes.base), roller=_mm(sizes.roller))
    if entry.rocks and None not in (three := (sizes.base, sizes.centre, follower.length)):
        _reach(entry, *three)  # type: ignore[arg-type]


def _reach(entry: Entry, base: Decimal, centre: Decimal, length: Decimal) -> None:
    """See that R0, L and the rocker make a triangle."""
    least, most = abs(centre - length), centre + length
    if not least < base < most:
        entry.fault(("sizes", "base"), "rocker_reach", least=_mm(least), most=_mm(most))


def _mm(size: Decimal) -> str:
    return shown(1000 * size)
