"""A law of motion as the scene gives it in a table: by its name with more to say, by points, by a shape (закон)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from decimal import Decimal
from typing import Any

from plans.cam.reading import fields as c
from plans.cam.reading.fields import Measure
from plans.model.cam import CUBICS, LAWS, LINES, SHAPE, TABLE
from plans.scene import fields as f
from plans.scene.faults import Wrong, wrong
from plans.scene.forms import Form
from plans.scene.readers import many
from plans.scene.tables import Missing, Table, key

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
