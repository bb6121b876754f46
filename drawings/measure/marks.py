"""Marks: the elements of a sheet that can be measured, and where each of them is drawn."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from drawings.measure.curvedata import Spots, curve
from drawings.measure.pathdata import centre, number, numbers, trace
from drawings.paper.limits import SheetRefused

KINDS = ("vector", "point", "pole", "corner", "profile")
LINES = ("vector", "profile")  # kinds that are seen by their lines alone
_PREFIX = "data-"


class SheetMark(NamedTuple):
    """A marked element: its data without "data-", and its two ends or its centre on paper (mm, y up).

    Of a profile its points are those of its pieces one after another; `parts` says how many each has.
    """

    kind: str
    data: Mapping[str, str]
    points: tuple[complex, ...]
    parts: tuple[int, ...] = ()

    @property
    def who(self) -> str:
        """What to call it in a message."""
        return called(self.data)


def called(data: Mapping[str, str]) -> str:
    """Name a mark by its data, for a message.

    >>> called({"kind": "vector", "plan": "velocities", "name": "v_B", "position": "3", "unit": "m/s"})
    'vector velocities v_B 3'
    """
    words = (data.get(name, "")[:60] for name in ("kind", "plan", "quantity", "name", "position"))
    return " ".join(word for word in words if word)


def marked(attributes: Mapping[str, str]) -> dict[str, str]:
    """Give the data of an element, {} if it is no mark."""
    if attributes.get("data-kind") not in KINDS:
        return {}
    return {name.removeprefix(_PREFIX): text for name, text in attributes.items() if name.startswith(_PREFIX)}


def drawn(kind: str, tag: str, attributes: Mapping[str, str]) -> list[Spots]:
    """Give the ends of a vector, the centre of a round mark, or the pieces of a profile, in the element's own place."""
    if kind == "profile":
        return curve(attributes.get("d", ""))
    return [_ends(tag, attributes) if kind == "vector" else (_middle(tag, attributes),)]


def _ends(tag: str, attributes: Mapping[str, str]) -> tuple[complex, ...]:
    points: tuple[complex, ...] = ()
    if tag == "line":
        return _at(attributes, "x1", "y1"), _at(attributes, "x2", "y2")
    if tag in ("polyline", "polygon"):
        flat = numbers(attributes.get("points", ""))
        points = tuple(map(complex, flat[::2], flat[1::2])) if len(flat) % 2 == 0 else ()
    elif tag == "path":
        followed = trace(attributes.get("d", ""))
        points = followed.points if followed.straight else ()
    if len(points) != 2:
        raise SheetRefused(f"its <{tag[:40]}> is not one straight line")
    return points


def _middle(tag: str, attributes: Mapping[str, str]) -> complex:
    if tag in ("circle", "ellipse"):
        return _at(attributes, "cx", "cy")
    middle = centre(trace(attributes.get("d", ""))) if tag == "path" else None
    if middle is None:
        raise SheetRefused(f"its <{tag[:40]}> is not a circle")
    return middle


def _at(attributes: Mapping[str, str], across: str, down: str) -> complex:
    return complex(number(attributes.get(across, "0")), number(attributes.get(down, "0")))
