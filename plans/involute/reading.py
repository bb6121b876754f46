"""The form of an involute pair, and the pair made from the scene with its faults and its notes (исходные данные)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from decimal import Decimal
from typing import Any, NamedTuple

from plans.involute.limits import PairLimit, limits, shifts_within
from plans.involute.shift import AIMS, NO_UNDERCUT, NoShift, aimed
from plans.model.involute import MODULES, SECOND, InvolutePair, Rack
from plans.scene import fields as f
from plans.scene import forms, units
from plans.scene.faults import Fault, SceneError, Wrong, wrong
from plans.scene.forms import Form
from plans.scene.readers import one
from plans.scene.scene import Meaning, Scene, TechniqueForm
from plans.scene.tables import Missing, Table, key, table

INVOLUTE = "involute"
LEAST_TEETH, MOST_TEETH = 5, 500  # by which a wheel is drawn with a few teeth
ANGLES = Decimal(10), Decimal(35)  # degrees, of racks
HEADS, CLEARANCES = (Decimal("0.5"), Decimal("1.5")), (Decimal("0.1"), Decimal("0.4"))  # modules
MILLIMETRE = Decimal(1000)
MOST_SHIFT = Decimal(5)  # modules: far beyond any tooth


def _bounded(value: object, least: Decimal, most: Decimal, kind: units.UnitKind = units.NUMBER) -> Decimal:
    found = units.quantity(value, kind)
    if not least <= found <= most:
        raise wrong("gear_range", least=f"{least}", most=f"{most}")
    return found


def _between(least: Decimal, most: Decimal, kind: units.UnitKind = units.NUMBER) -> Any:
    bounds = {"minimum": float(least), "maximum": float(most)}
    return one(_bounded, lambda: forms.quantity(kind, **bounds), kind.si, least=least, most=most, kind=kind)


def _teeth(value: object) -> int:
    found = f.whole(value, LEAST_TEETH)
    if found > MOST_TEETH:
        raise wrong("gear_range", least=LEAST_TEETH, most=MOST_TEETH)
    return found


TEETH = one(_teeth, lambda: {"type": "integer", "minimum": LEAST_TEETH, "maximum": MOST_TEETH}, "number")


def _two(entry: Any, what: str) -> Any:
    return f.pair(entry, what)._replace(shown=what)


class InvoluteTable(Table):
    """An involute pair: module, teeth, how the wheels are shifted, the rack."""

    module: Decimal = key(
        f.MILLIMETRES, meaning='Module m, mm, or text as "5 mm".', missing=Missing("module", "module = 5", 5)
    )
    teeth: tuple[int, int] = key(
        _two(TEETH, "[z1, z2]"),
        meaning="Teeth of wheel 1, which drives, and of wheel 2.",
        missing=Missing("teeth of both wheels", "teeth = [12, 28]", [20, 40]),
    )
    internal: bool = key(f.FLAG, False, meaning="Whether wheel 2 is a ring with teeth inside (внутреннее зацепление).")
    shift: tuple[Decimal, Decimal] | None = key(
        _two(_between(-MOST_SHIFT, MOST_SHIFT), "[x1, x2]"),
        None,
        meaning="Shifts (коэффициенты смещения) of both wheels; default: none, or as aim and centre ask.",
    )
    aim: str | None = key(
        f.words(*AIMS), None, meaning="What the shifts are to bring: no undercut, or equal sliding at both feet."
    )
    centre: Decimal | None = key(f.MILLIMETRES, None, meaning="Centre distance a_w that is to be kept, mm.")
    angle: Decimal = key(
        _between(*ANGLES, units.ANGLE), Decimal(20), meaning="Profile angle of the rack, degrees; default 20."
    )
    head: Decimal = key(_between(*HEADS), Decimal(1), meaning="Height of the rack's head, modules; default 1.")
    clearance: Decimal = key(_between(*CLEARANCES), Decimal("0.25"), meaning="Clearance, modules; default 0.25.")

    @classmethod
    def misfits(cls, value: Mapping[str, Any]) -> Iterator[Wrong]:
        """See that shifts are given or asked for, not both."""
        for name in ("aim", "centre"):
            if "shift" in value and name in value:
                yield wrong("one_of_two", first="shift", second=name, found="both", at=(name,))

    @classmethod
    def rules(cls) -> Form:
        """Say that shifts are given or asked for, not both."""
        return {"not": {"required": ["shift"], "anyOf": [{"required": ["aim"]}, {"required": ["centre"]}]}}


class InvoluteForm(TechniqueForm):
    """What a scene says of an involute pair."""

    involute: InvoluteTable = key(
        table(InvoluteTable),
        meaning="A pair of involute wheels (эвольвентная передача): module, teeth, shifts.",
        missing=Missing("table", "[involute] with module = 5, teeth = [12, 28]", {}),
    )


class InvoluteSurvey(NamedTuple):
    """What the examination of a scene's pair found: the pair, its faults, and limits that it nears."""

    pair: InvolutePair | None
    faults: list[Fault]
    near: Sequence[Fault] = ()


def survey_of(meaning: Meaning) -> InvoluteSurvey:
    """Make the pair of a scene and hold it to all that a pair must keep; each breach is a fault."""
    scene, form = meaning.scene, meaning.scene.of(InvoluteForm).involute
    rack = Rack(float(form.module), math.radians(form.angle), float(form.head), float(form.clearance))
    plain = InvolutePair(rack, form.teeth, (0.0, 0.0), form.internal)
    if early := [*shifts_within(plain)]:
        return InvoluteSurvey(None, [_fault(scene, limit) for limit in early])
    try:
        pair = _shifted(plain, form)
    except NoShift as none:
        return InvoluteSurvey(None, [_fault(scene, none)])
    found = [*limits(pair)]
    broken, near = ([_fault(scene, limit) for limit in found if limit.broken is kind] for kind in (True, False))
    return InvoluteSurvey(None if broken else pair, broken, near)


def _shifted(plain: InvolutePair, form: InvoluteTable) -> InvolutePair:
    if form.aim is not None or form.centre is not None:
        centre = None if form.centre is None else float(form.centre)
        return aimed(plain, form.aim or NO_UNDERCUT, centre)
    first, second = form.shift or (Decimal(0), Decimal(0))
    return InvolutePair(plain.rack, plain.teeth, (float(first), float(second)), plain.internal)


def _fault(scene: Scene, limit: PairLimit | NoShift) -> Fault:
    """Tell a breach at the key that would mend it, or at the table where the scene has none."""
    paths = ((INVOLUTE, name) for name in limit.at if scene.has((INVOLUTE, name)))
    return scene.fault(next(paths, (INVOLUTE,)), limit.kind, **limit.details)


def notes_of(scene: Scene) -> Iterator[Fault]:
    """Tell a module of no series, and limits that a pair nears."""
    form, survey = scene.of(InvoluteForm).involute, scene.meaning.of(InvoluteSurvey)
    size = float(form.module * MILLIMETRE)
    if size not in MODULES and size not in SECOND:
        near = min((*MODULES, *SECOND), key=lambda known: abs(known - size))
        yield scene.fault((INVOLUTE, "module"), "odd_module", module=f"{size:g}", near=f"{near:g}")
    yield from survey.near


def pair_of(scene: Scene) -> InvolutePair:
    """Give the pair of a scene; its faults are told before any is studied."""
    survey = scene.meaning.of(InvoluteSurvey)
    if survey.pair is None:
        raise SceneError(survey.faults)
    return survey.pair
