"""The numbers of a cyclogram as plain data, for `solve`: radians of the main shaft, SI units (циклограмма в числах)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from plans.cyclogram.study import CYCLOGRAM
from plans.model.cyclogram import ANALYSIS, BEGIN, END, Cyclogram, Position

if TYPE_CHECKING:
    from plans.study import Study


@dataclass(frozen=True)
class CyclogramNumbers:
    """The characteristic positions of a scene's main mechanism by one road."""

    title: str
    found: Cyclogram

    @property
    def flawed(self) -> bool:
        """Whether something has no numbers: what has none is refused."""
        return False

    def plain(self) -> dict[str, Any]:
        """Give the numbers as plain data."""
        found, window = self.found, self.found.window
        told: dict[str, Any] = {"stroke": found.stroke, "overlap": found.overlap, "sense": found.sense}
        told["window"] = {"start": window.start, "end": window.end, "angle": window.angle, "rest": window.rest}
        told["positions"] = [_position(k, one) for k, one in enumerate(found.positions)]
        return {"scene": self.title, "by": found.by, "cyclogram": told}


def numbers(study: Study, by: str) -> CyclogramNumbers:
    """Find the characteristic positions of a scene by a road (row of the table of techniques)."""
    if by != ANALYSIS:
        return CyclogramNumbers(study.scene.heading(), study[CYCLOGRAM].cyclogram)
    return CyclogramNumbers(study.scene.heading(), study.comparison(CYCLOGRAM).analysis)


def _position(number: int, one: Position) -> dict[str, Any]:
    told = {"number": number, "role": one.role, "back": one.back, "turned": one.turned, "share": one.share}
    bounded = one.role not in (BEGIN, END)  # where the tool stands a turn of the shaft does not move it
    return told | {"place": one.place, "pressure": one.angle, "condition": one.condition if bounded else None}
