"""Measuring: the vectors and points of a written sheet in true units, and how far they are from what they state.

The sheet is a stranger's until shown otherwise: it may have been moved, scaled, regrouped and rewritten by an editor.
"""

import cmath
import math
import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Any, NamedTuple, TypeAlias

from drawings.paper.limits import CURVE_QUANTUM, FORMAT, QUANTUM, SHEET_BYTES, STATED_DIGITS, SheetRefused
from drawings.reading.marks import MarkKey, MeasuredMark, MeasuredPoint, MeasuredVector, SheetMark, Witness
from drawings.reading.pathdata import number, pair, pieces
from drawings.reading.reader import read
from drawings.reading.transform import STAY, Affine, placing
from geometry.curve import Piece, gaps
from geometry.errors import regular_bytes
from plans.words.words import Message

PARTS = 8  # of a piece, at which it is looked at


@dataclass(frozen=True, eq=False, repr=False)
class MeasuredProfile(MeasuredMark):
    """A profile: its pieces m in the cam as it stands at its start; its value is the place where it begins.

    The pieces lie as the stated value of their beginning says: the cam's centre on paper is rounded more than they are.
    `deviation` is how far the sheet says its cubics are from the exact profile, m; `quantum` how far rounding on paper
    may have moved its points, m.
    """

    at: complex  # where it begins on paper, mm
    pieces: tuple[Piece, ...]
    deviation: float
    quantum: float

    @property
    def reach(self) -> float:
        """How far from the sheet's corner it begins (mm), which its rounding is a share of."""
        return abs(self.at)

    @property
    def places(self) -> tuple[complex, ...]:
        """Places along its pieces, m."""
        inner = [piece.at(k / PARTS) for piece in self.pieces for k in range(PARTS)]
        return *inner, self.pieces[-1].end

    @property
    def gap(self) -> float:
        """The widest gap between its pieces, m, as it goes on and comes back."""
        return gaps(self.pieces, closed=True)


def profile(mark: SheetMark, pole: complex, scale: float, stated: complex, resolution: float) -> MeasuredProfile:
    """Give a profile from its mark, whose centre is at a place on paper, where points are rounded so much, mm."""
    turn = scale * cmath.exp(-1j * math.radians(_number(mark, "turned", 0.0)))
    start = mark.points[0]
    deviation = _number(mark, "deviation")
    if not deviation >= 0:
        raise SheetRefused("deviation", who=mark.who, size=deviation)
    plan, quantity, name, unit = (mark.data.get(key, "") for key in ("plan", "quantity", "name", "unit"))
    placed = tuple(piece.placed(turn, stated - start * turn) for piece in pieces(_parts(mark)))
    values = (start - pole) * turn, stated, unit, scale, start, placed, deviation, resolution * scale
    return MeasuredProfile(plan, quantity, name, None, *values)


def _parts(mark: SheetMark) -> Iterator[tuple[complex, ...]]:
    place = 0
    for count in mark.parts:
        yield mark.points[place : place + count]
        place += count


def _number(mark: SheetMark, name: str, default: float | None = None) -> float:
    try:
        return default if default is not None and name not in mark.data else number(mark.data.get(name, ""))
    except SheetRefused as refused:
        raise SheetRefused("data", who=mark.who, name=name, why=refused.reason) from refused


CORNERS = 3
_SAID = 20  # letters of a strange value that are told

_POSITION = re.compile(r"-?[0-9]{1,9}")
# The stated value and the scale are each rounded to this share of themselves at the most; arithmetic to far less.
_STATED = 10.0 ** (1 - STATED_DIGITS)


class Measured(NamedTuple):
    """All that a sheet shows; `quantum` is its resolution (mm), `notes` names what was left aside."""

    vectors: tuple[MeasuredVector, ...]
    points: tuple[MeasuredPoint, ...]
    metadata: Mapping[str, Any] = MappingProxyType({})
    quantum: float = QUANTUM
    notes: tuple[Message, ...] = ()
    profiles: tuple[MeasuredProfile, ...] = ()
    moved: Affine = STAY  # how the whole sheet was moved, by its corner marks

    @property
    def marks(self) -> tuple[MeasuredVector | MeasuredPoint, ...]:
        """The vectors, then the points."""
        return (*self.vectors, *self.points)


class Mismatch(NamedTuple):
    """A vector or point that is not what it states; `measured` is None if it is not on the sheet at all."""

    key: MarkKey
    measured: complex | None
    stated: complex | None
    allowed: float


_Pole: TypeAlias = tuple[complex, complex]  # its place on the sheet, and the true coordinates there


def measure_file(path: Path) -> Measured:
    """Measure a sheet in a file; an OSError where the system does not give the file."""
    return measure(regular_bytes(path, SHEET_BYTES + 1))


def measure(source: bytes, witness: Witness | None = None) -> Measured:
    """Measure a sheet; one that cannot be trusted to be read right is refused with the reason."""
    sheet = read(source, witness)
    version = sheet.metadata.get("format", FORMAT)
    if not isinstance(version, int) or version > FORMAT:
        raise SheetRefused("format", format=repr(version)[:_SAID], known=FORMAT)
    _once(sheet.marks)
    moved = _moved([mark for mark in sheet.marks if mark.kind == "corner"])
    marks = [_moved_back(mark, moved) for mark in sheet.marks]
    poles = {_place(mark): (mark.points[0], _stated(mark)) for mark in marks if mark.kind == "pole"}
    return Measured(
        vectors=tuple(_vector(mark) for mark in marks if mark.kind == "vector"),
        points=tuple(_point(mark, poles) for mark in marks if mark.kind == "point"),
        metadata=sheet.metadata,
        quantum=_resolution(moved),
        notes=tuple(sheet.notes),
        profiles=tuple(_profile(mark, poles, moved) for mark in marks if mark.kind == "profile"),
        moved=moved,
    )


def check(measured: Measured, tolerance: float | None = None, expected: Iterable[MarkKey] = ()) -> list[Mismatch]:
    """List what differs from what it states by more than `tolerance` (mm, else the sheet's own), or is missing.

    To the tolerance come the roundings of the stated value and of our own arithmetic; comparisons fail closed.
    """
    paper = measured.quantum if tolerance is None else tolerance
    wrong: list[Mismatch] = []
    for mark in (*measured.marks, *measured.profiles):
        allowed = (paper + _STATED * mark.reach) * mark.scale + _STATED * abs(mark.stated)
        if not abs(mark.value - mark.stated) <= allowed:
            wrong.append(Mismatch(mark.key, mark.value, mark.stated, allowed))
    known = {mark.key for mark in (*measured.marks, *measured.profiles)}
    return wrong + [Mismatch(key, None, None, 0.0) for key in expected if key not in known]


def _once(marks: Iterable[SheetMark]) -> None:
    """One mark for each name: a fan of arrows must not pass because one of them is right."""
    met: set[tuple[str | int | None, ...]] = set()
    for mark in marks:
        names = ("value",) if mark.kind == "corner" else ("plan", "quantity", "name")
        key = (mark.kind, _position(mark), *(mark.data.get(name, "") for name in names))
        if key in met:
            raise SheetRefused("twice", who=mark.who)
        met.add(key)


def _moved(corners: list[SheetMark]) -> Affine:
    """Find how the whole sheet was moved; one without any corner marks is taken as it lies."""
    if not corners:
        return STAY
    if len(corners) != CORNERS:
        raise SheetRefused("corners", left=len(corners), all=CORNERS)
    stated, found = [_stated(corner) for corner in corners], [corner.points[0] for corner in corners]
    # Marks that lie where they say, within their own rounding, tell of no move.
    if all(abs(place - mark) <= QUANTUM for place, mark in zip(found, stated, strict=True)):
        return STAY
    return placing(stated, found)


def _resolution(moved: Affine) -> float:
    """The rounding of a vector's ends; in a moved sheet they and the corner marks were rounded twice, and scaled."""
    return QUANTUM if moved == STAY else 4 * QUANTUM * max(1.0, 1 / abs(moved.p))


def _moved_back(mark: SheetMark, moved: Affine) -> SheetMark:
    if moved == STAY:
        return mark
    return mark._replace(points=tuple((point - moved.t) / moved.p for point in mark.points))


def _vector(mark: SheetMark) -> MeasuredVector:
    scale = _scale(mark)
    start, end = mark.points
    key = (_text(mark, "plan"), _text(mark, "quantity"), _text(mark, "name"), _position(mark))
    return MeasuredVector(*key, (end - start) * scale, _stated(mark), mark.data.get("unit", ""), scale, start, end)


def _profile(mark: SheetMark, poles: Mapping[tuple[str, int | None], _Pole], moved: Affine) -> MeasuredProfile:
    """Give a profile; its pole is the cam's centre. An editor that moves a curve rounds it."""
    resolution = CURVE_QUANTUM if moved == STAY else _resolution(moved)
    return profile(mark, _pole(mark, poles)[0], _scale(mark), _stated(mark), resolution)


def _point(mark: SheetMark, poles: Mapping[tuple[str, int | None], _Pole]) -> MeasuredPoint:
    plan, position = _place(mark)
    pole = _pole(mark, poles)
    (at,), scale = mark.points, _scale(mark)
    key = (plan, _text(mark, "quantity"), _text(mark, "name"), position)
    value = (at - pole[0]) * scale + pole[1]
    return MeasuredPoint(*key, value, _stated(mark), mark.data.get("unit", ""), scale, at)


def _pole(mark: SheetMark, poles: Mapping[tuple[str, int | None], _Pole]) -> _Pole:
    plan, position = _place(mark)
    pole = poles.get((plan, position)) or poles.get((plan, None))
    if pole is None:
        raise SheetRefused("poleless", who=mark.who)
    return pole


def _place(mark: SheetMark) -> tuple[str, int | None]:
    return _text(mark, "plan"), _position(mark)


def _text(mark: SheetMark, name: str) -> str:
    text = mark.data.get(name, "")
    if not text:
        raise SheetRefused("no_data", who=mark.who, name=name)
    return text


def _position(mark: SheetMark) -> int | None:
    text = mark.data.get("position", "")
    if text and not _POSITION.fullmatch(text):
        raise SheetRefused("position", who=mark.who, text=repr(text[:_SAID]))
    return int(text) if text else None


def _stated(mark: SheetMark) -> complex:
    try:
        return pair(_text(mark, "value"))
    except SheetRefused as refused:
        raise SheetRefused("data", who=mark.who, name="value", why=refused.reason) from refused


def _scale(mark: SheetMark) -> float:
    try:
        scale = number(_text(mark, "scale"))
    except SheetRefused as refused:
        raise SheetRefused("data", who=mark.who, name="scale", why=refused.reason) from refused
    if not scale > 0:
        raise SheetRefused("scale", who=mark.who, size=scale)
    return scale
