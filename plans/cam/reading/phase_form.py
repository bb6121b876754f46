"""A phase of a cam as the scene gives it: kind, angle or travel, part of the way, law (данные фазы)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from decimal import Decimal
from fractions import Fraction
from itertools import pairwise
from typing import Any, NamedTuple

from plans.cam.reading import fields as c
from plans.cam.reading.fields import Measure
from plans.model.cam import CUBICS, DWELL, LAWS, LINES, RETURN, RISE, SHAPE, TABLE
from plans.scene import fields as f
from plans.scene import forms
from plans.scene.faults import Wrong, wrong
from plans.scene.forms import Form
from plans.scene.readers import either, many
from plans.scene.tables import Missing, Table, key, table

Plotted = tuple[tuple[Fraction, Fraction], ...]
NEARLY = Fraction(1, 10**6)  # of either area: written shares are rounded, and areas so near each other are meant alike


class AccelerationShape(NamedTuple):
    """Shares of a phase from 0 to 1 with the acceleration in any scale; two points at one share are a jump."""

    points: Plotted

    @property
    def above(self) -> Fraction:
        """The area above 0.

        >>> str(AccelerationShape(((Fraction(0), Fraction(1)), (Fraction(1), Fraction(-1)))).above)
        '1/4'
        """
        return sum(self._areas(1), Fraction(0))

    @property
    def below(self) -> Fraction:
        """The area below 0, as a size."""
        return sum(self._areas(-1), Fraction(0))

    def _areas(self, sense: int) -> Iterator[Fraction]:
        for (x0, y0), (x1, y1) in pairwise(self.points):
            a, b = sense * y0, sense * y1
            if a > 0 and b > 0:
                yield (x1 - x0) * (a + b) / 2
            elif max(a, b) > 0:
                yield (x1 - x0) * max(a, b) ** 2 / abs(b - a) / 2

    @property
    def cancels(self) -> bool:
        """Whether the areas above and below are alike, but for the rounding of what is written."""
        return self.above > 0 and abs(self.above - self.below) <= NEARLY * self.above

    @property
    def factor(self) -> Fraction:
        """How many times as large the ordinates below 0 should be; 0 where nothing would do.

        The whole area is a sum over the ordinates, each with half of what lies to both sides of it.
        """
        parts = [(y, (after - before) / 2) for (_, y), (before, after) in zip(self.points, self._sides(), strict=True)]
        up = sum((y * width for y, width in parts if y > 0), Fraction(0))
        down = -sum((y * width for y, width in parts if y < 0), Fraction(0))
        return up / down if up and down else Fraction(0)

    def _sides(self) -> Iterator[tuple[Fraction, Fraction]]:
        """Give the shares before and after each point."""
        shares = [self.points[0][0], *(x for x, _ in self.points), self.points[-1][0]]
        return zip(shares, shares[2:], strict=False)

    @property
    def lift(self) -> Fraction:
        """What two integrations of it from rest give."""
        level = slope = Fraction(0)
        for (x0, y0), (x1, y1) in pairwise(self.points):
            level += slope * (x1 - x0) + (x1 - x0) ** 2 * (2 * y0 + y1) / 6
            slope += (x1 - x0) * (y0 + y1) / 2
        return level


def cancelled(shape: AccelerationShape) -> AccelerationShape:
    """Give a shape whose areas cancel exactly: what is below 0 takes what is over."""
    factor = shape.factor
    return AccelerationShape(tuple((x, y * factor if y < 0 else y) for x, y in shape.points))


POINTS = 'points = [[0, 0], [60, "15 mm"], [120, "30 mm"]]'


class LawTable(Table):
    """A law of motion with what it needs beside its name."""

    name: str = key(
        f.words(*LAWS, TABLE, SHAPE),
        meaning='Name of the law; "table": by points, "shape": by the shape of its acceleration.',
        missing=Missing("name of the law", 'name = "constant acceleration"', LAWS[0]),
    )
    first: Decimal | None = key(
        c.FIRST, None, meaning="Of constant acceleration: share of the phase that accelerates; default: 0.5."
    )
    points: tuple[tuple[Measure, Measure], ...] = key(
        many(c.POINT, f.NOT_EMPTY, first=f.FEW),
        (),
        meaning="Of a table: turn of the cam from the start of the phase, degrees (m of a cam that translates), and S "
        "there, m (degrees of a rocker); of a shape: share of the phase and acceleration in any scale, two points at "
        "one share being a jump.",
        missing=Missing("points of the law", POINTS),
    )
    through: str | None = key(
        f.words(LINES, CUBICS), None, meaning="What joins the points of a table; default: cubics (кубический сплайн)."
    )
    tolerance: Measure | None = key(
        c.TOLERANCE,
        None,
        meaning="How far smoothing cubics may leave the points of a table, m (degrees of a rocker); default: 0.",
    )

    @classmethod
    def misfits(cls, value: Mapping[str, Any]) -> Iterator[Wrong]:
        """See that a law by points has them."""
        if value.get("name") in (TABLE, SHAPE) and "points" not in value:
            yield wrong("missing", at=("points",))

    @classmethod
    def rules(cls) -> Form:
        """Say that a law by points has them."""
        by_points = {"properties": {"name": forms.choice((TABLE, SHAPE))}, "required": ["name"]}
        return {"if": by_points, "then": {"required": ["points"]}}


class PhaseTable(Table):
    """A phase of the cam: its kind, its angle, or its travel of a cam that translates, and its law."""

    kind: str = key(
        f.words(RISE, DWELL, RETURN),
        meaning="Rise (удаление), dwell (выстой) or return (возвращение).",
        missing=Missing("kind of the phase", 'kind = "rise"', DWELL),
    )
    angle: Decimal | str | None = key(
        c.PHASE_ANGLE,
        None,
        meaning='Phase angle (фазовый угол), degrees; "rest" is what the others leave of the turn, '
        '"cyclogram" what the cyclogram of the machine gives.',
        missing=Missing("angle of the phase", "angle = 120"),
        also=("phi", "φ"),
    )
    travel: Decimal | None = key(f.LENGTH, None, meaning="Of a cam that translates: its travel over the phase, m.")
    lift: Decimal | None = key(
        c.SIZE, None, meaning="Part of the lift that this phase takes, m; default: all that is left of the way."
    )
    swing: Decimal | None = key(
        c.SWING, None, meaning="Part of the swing, degrees; default: all that is left of the way."
    )
    law: str | LawTable | None = key(
        either(dict, table(LawTable), c.LAW),
        None,
        meaning="Law of motion (закон движения), by its name or as a table; not of a dwell.",
        missing=Missing("law of motion", 'law = "sine"', "sine"),
    )

    @classmethod
    def misfits(cls, value: Mapping[str, Any]) -> Iterator[Wrong]:
        """See that its angle or its travel is given, and the law of what moves."""
        if "angle" not in value and "travel" not in value:
            yield wrong("missing", at=("angle",))
        if {"angle", "travel"} <= value.keys():
            yield wrong("one_of_two", first="angle", second="travel", found="both", at=("travel",))
        if value.get("kind") in (RISE, RETURN) and "law" not in value:
            yield wrong("missing", at=("law",))

    @classmethod
    def rules(cls) -> Form:
        """Say that its angle or its travel is given, and the law of what moves."""
        moves = {"properties": {"kind": forms.choice((RISE, RETURN))}, "required": ["kind"]}
        ways = [{"required": ["angle"]}, {"required": ["travel"]}]
        return {"oneOf": ways, "if": moves, "then": {"required": ["law"]}}
