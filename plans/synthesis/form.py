"""The form of a task of synthesis: what a mechanism must do (задание на синтез)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from decimal import Decimal
from functools import partial
from typing import Any

from plans.scene import fields as f
from plans.scene import forms, units
from plans.scene.faults import Wrong, wrong
from plans.scene.forms import Form
from plans.scene.readers import FieldReader, one
from plans.scene.scene import TechniqueForm
from plans.scene.tables import Missing, Table, key, table

TURN, HALF, QUARTER = Decimal(360), Decimal(180), Decimal(90)  # degrees
MOST_RATIO = Decimal(1000)  # of lengths: a rod that never ends
MOST_TIMES = Decimal("2.999")  # K of an overlap near a right angle
EXAMPLE = '[synthesis.slider_crank] with stroke = "120 mm", time_ratio = 1.1, offset = "30 mm"'


def _inside(value: object, least: Decimal, most: Decimal, kind: units.UnitKind) -> Decimal:
    found = units.quantity(value, kind)
    if not least <= found < most:
        raise wrong("demand_range", least=f"{least}", most=f"{most}")
    return found


def _within(least: str, most: Decimal, kind: units.UnitKind = units.ANGLE) -> FieldReader:
    low = Decimal(least)
    bounds = {"minimum": float(low), "exclusiveMaximum": float(most)}
    return one(partial(_inside), lambda: forms.quantity(kind, **bounds), kind.si, least=low, most=most, kind=kind)


class DemandTable(Table):
    """What every mechanism may be asked: how much slower it works than it returns."""

    overlap: Decimal | None = key(
        _within("0", QUARTER), None, meaning="Overlap angle theta (угол перекрытия), degrees.", also=("theta", "θ")
    )
    time_ratio: Decimal | None = key(
        _within("1", MOST_TIMES, units.NUMBER),
        None,
        meaning="Coefficient of mean speeds K (коэффициент изменения средней скорости), instead of the overlap.",
        also=("K",),
    )

    @classmethod
    def misfits(cls, value: Mapping[str, Any]) -> Iterator[Wrong]:
        """See that the overlap is told once."""
        if "overlap" in value and "time_ratio" in value:
            yield wrong("one_of_two", first="overlap", second="time_ratio", found="both", at=("time_ratio",))

    @classmethod
    def rules(cls) -> Form:
        """Say that the overlap is told once."""
        return {"not": {"required": ["overlap", "time_ratio"]}}


class RockerTable(DemandTable):
    """A crank-rocker that is wanted: its rocker, swing and overlap, and what is chosen freely."""

    rocker: Decimal = key(
        f.LENGTH, meaning="Length of the rocker l3, m.", missing=Missing("rocker", 'rocker = "300 mm"', "300 mm")
    )
    swing: Decimal = key(
        _within("0.1", HALF),
        meaning="Swing of the rocker psi (угол размаха), degrees.",
        missing=Missing("swing", "swing = 40", 40),
        also=("psi", "ψ"),
    )
    frame: Decimal | None = key(
        f.LENGTH, None, meaning="Frame l4, m; default: that with the largest least transmission angle."
    )
    place: Decimal | None = key(
        _within("0", TURN),
        None,
        meaning="Where O is on the circle that sees the chord, degrees at M, instead of the frame; the rocker's middle "
        "position is at 90.",
    )
    beyond: bool = key(f.FLAG, False, meaning="Whether a place is told of the circle whose centre is beyond the chord.")

    @classmethod
    def misfits(cls, value: Mapping[str, Any]) -> Iterator[Wrong]:
        """See that no more than one parameter is told, and the overlap."""
        yield from super().misfits(value)
        if "frame" in value and "place" in value:
            yield wrong("one_of_two", first="frame", second="place", found="both", at=("place",))
        if "overlap" not in value and "time_ratio" not in value:
            yield wrong("missing", at=("overlap",))

    @classmethod
    def rules(cls) -> Form:
        """Say that no more than one parameter is told, and the overlap once."""
        return {
            "not": {"required": ["frame", "place"]},
            "oneOf": [{"required": ["overlap"]}, {"required": ["time_ratio"]}],
        }


class SliderTable(DemandTable):
    """A slider-crank that is wanted: its stroke, and two of offset, overlap, ratio of lengths, pressure angle."""

    stroke: Decimal = key(
        f.LENGTH, meaning="Stroke H (ход), m.", missing=Missing("stroke", 'stroke = "120 mm"', "120 mm"), also=("H",)
    )
    offset: Decimal | None = key(
        f.not_negative(units.LENGTH), None, meaning="Offset e of the guide (дезаксиал), m.", also=("e",)
    )
    ratio: Decimal | None = key(
        _within("1.001", MOST_RATIO, units.NUMBER), None, meaning="Ratio l2/l1 of the rod to the crank."
    )
    pressure: Decimal | None = key(
        _within("0.1", QUARTER), None, meaning="Largest pressure angle (угол давления), degrees.", also=("alpha", "α")
    )


class SynthesisTable(Table):
    """A task of synthesis: what mechanism is wanted, and what it must do."""

    crank_rocker: RockerTable | None = key(
        table(RockerTable), None, meaning="A crank-rocker (кривошипно-коромысловый механизм)."
    )
    slider_crank: SliderTable | None = key(
        table(SliderTable), None, meaning="A slider-crank (кривошипно-ползунный механизм)."
    )

    @classmethod
    def misfits(cls, value: Mapping[str, Any]) -> Iterator[Wrong]:
        """See that one mechanism is asked for."""
        if len(value.keys() & {"crank_rocker", "slider_crank"}) != 1:
            found = "both" if "crank_rocker" in value else "neither"
            yield wrong("one_of_two", first="crank_rocker", second="slider_crank", found=found)

    @classmethod
    def rules(cls) -> Form:
        """Say that one mechanism is asked for."""
        return {"oneOf": [{"required": ["crank_rocker"]}, {"required": ["slider_crank"]}]}


class SynthesisForm(TechniqueForm):
    """What a scene says of a task of synthesis."""

    synthesis: SynthesisTable = key(
        table(SynthesisTable),
        meaning="A task of synthesis (кинематический синтез): what a mechanism must do; its lengths are found.",
        missing=Missing("table", EXAMPLE, {}),
    )
