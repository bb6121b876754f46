"""Lettering read at once: letters that stand on one line as plain pens set them (строка букв)."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import TypeAlias

from drawings.eye.alike import picked
from drawings.eye.lettered import ALONG, EVEN, Part, Set, looked_up, spaces_of
from drawings.eye.letters import Stance
from drawings.paper.strokes import LEAN, LOWERED, RAISED, LineStyle, Text

_Cell: TypeAlias = tuple[str, complex, float]  # of a reading: its letter, corner and width
_Spot: TypeAlias = tuple[complex, float, Sequence[_Cell]]  # of a letter: its place, its pen, what it may be


def at_once(parts: Sequence[Part], said: str, ink: LineStyle) -> Text | None:
    """Read letters as plain pens write them on one line along or up a sheet; None of all that takes a closer look."""
    (p, q, t), found = parts[0].place, list[tuple[complex, float, Mapping[Stance, tuple[_Cell, ...]]]]()
    for own, place, style in parts:
        if not own or place != parts[0].place:
            return None
        unit = style.width
        found += [(complex(float(x), float(y)), unit, _cells(rest, p, q, unit)) for x, y, rest in own]
    stance = next((one for one in found[0][2] if all(one in cells for _, _, cells in found)), None)
    if stance is None:
        return None
    back = stance.turn.conjugate()
    p, q, t = p * back, q * back, t * back
    pen = max(part.style.width for part in parts)
    row = _even([(p * at + q * at.conjugate() + t, unit, cells[stance]) for at, unit, cells in found], pen, stance)
    spaces = [-1] if row is None else [*spaces_of(row, 10 * pen)]
    if row is None or -1 in spaces:
        return None
    low = next(one[2] for one in row if one[5] == 0)
    runs = picked([(one[0], one[5]) for one in row], [0, *spaces], said)
    return Text(
        stance.turn * complex(row[0][1], low), runs, round(10 * pen, 6), "start", stance.slanted, stance.rotation, ink
    )


def _even(letters: Sequence[_Spot], pen: float, stance: Stance) -> list[Set] | None:
    """Set letters on the line of writing of the first of the largest that can be but one; None where one is not."""
    sure = (spot + own[0][1] for spot, unit, own in letters if unit == pen and len(own) == 1)
    low, row = next(sure, complex(0, math.nan)).imag, []
    for spot, unit, own in letters:
        for name, corner, width in own:
            at = spot + corner
            rise = at.imag - low
            if unit == pen and abs(rise) <= EVEN:
                row.append(Set(name, at.real, at.imag, width, unit))
                break
            level = 1 if rise > 0 else -1
            share = RAISED if rise > 0 else -LOWERED
            if abs(rise - share * 10 * pen) <= EVEN:
                lean = LEAN * share * 10 * pen if stance.slanted else 0.0
                row.append(Set(name, at.real - lean, at.imag, width, unit, level))
                break
        else:
            return None
    return row if len({one.unit for one in row}) == 1 else sorted(row, key=ALONG)


@lru_cache(maxsize=16384)
def _cells(steps: str, p: complex, q: complex, unit: float) -> Mapping[Stance, tuple[_Cell, ...]]:
    """Give what letter some steps may be in each stance."""
    found: dict[Stance, tuple[_Cell, ...]] = {}
    for name, stance, corner, width in looked_up(steps, p, q, unit)[1]:
        found[stance] = (*found.get(stance, ()), (name, corner, width))
    return found
