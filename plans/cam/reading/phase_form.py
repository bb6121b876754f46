"""A phase of a cam as the scene gives it: kind, angle or travel, part of the way, law (данные фазы)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from decimal import Decimal
from typing import Any

from plans.cam.reading import fields as c
from plans.cam.reading.fields import Measure
from plans.model.cam import CUBICS, DWELL, LAWS, LINES, RETURN, RISE, SHAPE, TABLE
from plans.scene import fields as f
from plans.scene.faults import Wrong, wrong
from plans.scene.forms import Form
from plans.scene.readers import either, many
from plans.scene.tables import Missing, Table, key, table

POINTS = 'points = [[0, 0], [60, "15 mm"], [120, "30 mm"]]'


class LawTable(Table):
    """A law of motion with what it needs beside its name."""

    name: str = key(
        f.words(*LAWS, TABLE, SHAPE, likely=c.likely_law),
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
        by_points = {"properties": {"name": {"enum": [TABLE, SHAPE]}}, "required": ["name"]}
        return {"if": by_points, "then": {"required": ["points"]}}


class PhaseTable(Table):
    """A phase of the cam: its kind, its angle, or its travel of a cam that translates, and its law."""

    kind: str = key(
        f.words(RISE, DWELL, RETURN, likely=c.likely_kind),
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
        moves = {"properties": {"kind": {"enum": [RISE, RETURN]}}, "required": ["kind"]}
        one = [{"required": ["angle"]}, {"required": ["travel"]}]
        return {"oneOf": one, "if": moves, "then": {"required": ["law"]}}
