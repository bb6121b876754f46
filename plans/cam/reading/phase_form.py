"""A phase of a cam as the scene gives it: kind, angle or travel, part of the way, law (данные фазы)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from decimal import Decimal
from typing import Any

from plans.cam.reading import fields as c
from plans.cam.reading.law_form import LawTable
from plans.model.cam import DWELL, RETURN, RISE
from plans.scene import fields as f
from plans.scene.faults import Wrong, wrong
from plans.scene.forms import Form
from plans.scene.readers import either
from plans.scene.tables import Missing, Table, key, table


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
