"""The form of a bank, and the bank made from the scene with its faults and its notes (блок по исходным данным)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import replace
from decimal import Decimal
from fractions import Fraction
from typing import Any, NamedTuple

from plans.balance.reading import check_moving
from plans.linkage.reading.form import LinkageForm
from plans.linkage.reading.survey import LinkageSurvey
from plans.model.balance.bank import ORDERS, Asked, BankTask, Member, Unit
from plans.scene import fields as f
from plans.scene import forms, units
from plans.scene.faults import Fault, Path, SceneError, Wrong, wrong
from plans.scene.forms import Form
from plans.scene.notes import odd_lengths
from plans.scene.readers import Check, many
from plans.scene.readers import one as single
from plans.scene.scene import Meaning, Scene, TechniqueForm
from plans.scene.tables import Missing, Table, key, table
from plans.scene.units import EXACT
from plans.words.words import message

ORDER_LIMIT = 100  # of a harmonic: what an engine's frame feels ends below the tenth
# Lines that would do.
UNIT = '[bank.unit] with crank = "40 mm", rod = "140 mm" and reciprocating = "0.5 kg"'
MEMBER = '[[bank.members]] with crank = 0 and place = "0 mm"'
EXAMPLE = "[[bank.members]] with crank = 0"


def order(value: object) -> int:
    """Read the order of a harmonic."""
    found = f.whole(value, 1)
    if found > ORDER_LIMIT:
        raise wrong("order_limit", most=ORDER_LIMIT)
    return found


ORDER = single(order, lambda: forms.whole(1) | {"maximum": ORDER_LIMIT}, "number")
MASS = f.positive(units.MASS)


class UnitTable(Table):
    """A slider-crank of the bank by its sizes m, kg, its mass put together at the crank pin and at the slider."""

    crank: Decimal = key(
        f.LENGTH,
        meaning="Radius of the crank.",
        missing=Missing("radius", 'crank = "40 mm"'),
        also=("radius", "r", "oa"),
    )
    rod: Decimal = key(
        f.LENGTH,
        meaning="Length of the connecting rod (шатун), more than the crank's.",
        missing=Missing("length", 'rod = "140 mm"'),
        also=("l", "length", "ab"),
    )
    rotating: Decimal = key(
        f.MASS, Decimal(0), meaning="Unbalanced mass that turns at the crank pin, with its part of the rod's."
    )
    reciprocating: Decimal = key(
        f.MASS,
        meaning="Mass that moves along the guide: piston, with its part of the rod's.",
        missing=Missing("mass", 'reciprocating = "0.5 kg"'),
        also=("piston", "mass"),
    )

    def check(self) -> None:
        """See that the crank can turn fully and smoothly, and that something moves."""
        if self.rod == self.crank:
            raise wrong("equal_rod", at=("rod",))
        if self.rod < self.crank:
            raise wrong("short_rod", at=("rod",))
        if not self.rotating and not self.reciprocating:
            raise wrong("massless_unit", at=("reciprocating",))


class MemberTable(Table):
    """A mechanism of the bank: crank and guide in degrees from the reference ones, and its place along the shaft m."""

    crank: Decimal = key(
        f.ANGLE,
        meaning="Where its crank stands, degrees counter-clockwise from the reference crank.",
        missing=Missing("angle of the crank", "crank = 180"),
        also=("phase", "angle", "phi", "φ"),
    )
    place: Decimal = key(f.COORDINATE, Decimal(0), meaning="Place along the shaft.", also=("h", "z"))
    axis: Decimal = key(
        f.ANGLE, Decimal(0), meaning="Direction of its guide from the reference guide: banks of a V, boxer engines."
    )

    @property
    def stand(self) -> tuple[Decimal, Decimal, Decimal]:
        """How it stands, whole turns left aside."""
        return _turned(self.crank), self.place, _turned(self.axis)


def _turned(angle: Decimal) -> Decimal:
    left = EXACT.remainder(angle, Decimal(360))
    return EXACT.add(left, Decimal(360)) if left < 0 else left


def _check_apart(entries: tuple[MemberTable, ...]) -> None:
    """See that no two members are in one place with crank and guide alike."""
    stands = [member.stand for member in entries]
    for number, stand in enumerate(stands):
        if stand in stands[:number]:
            raise wrong("member_twice", other=stands.index(stand) + 1, at=(number,))


class CompensatorTable(Table):
    """Compensators of one order: mass of each kg, offset of their line m, shafts of the compensator of the couple m."""

    order: int = key(
        ORDER, meaning="The order: they turn so many times as fast as the crank.", missing=Missing("order", "order = 1")
    )
    mass: Decimal | None = key(MASS, None, meaning="Mass of each; its radius is found.")
    offset: Decimal = key(
        f.COORDINATE,
        Decimal(0),
        meaning="Distance of their line from the guide: it leaves a couple.",
        missing=Missing("offset", 'offset = "60 mm"'),
    )
    shafts: Decimal | None = key(
        f.LENGTH, None, meaning="Distance of the two shafts of a compensator of that couple; without it there is none."
    )

    @classmethod
    def misfits(cls, value: Mapping[str, Any]) -> Iterator[Wrong]:
        """See that there is a couple to compensate."""
        if "shafts" in value and "offset" not in value:
            yield wrong("missing", at=("offset",), why=message("why.shafts"))

    @classmethod
    def rules(cls) -> Form:
        """Say that there is a couple to compensate."""
        return {"dependentRequired": {"shafts": ["offset"]}}


def _check_orders(entries: tuple[CompensatorTable, ...]) -> None:
    """See that an order has one line of compensators."""
    orders = [compensator.order for compensator in entries]
    for number, found in enumerate(orders):
        if found in orders[:number]:
            raise wrong("compensators_twice", order=found, at=(number, "order"))


class BankTable(Table):
    """A bank of equal mechanisms on one shaft: sizes of one, members, speed, orders of harmonics, compensators."""

    speed: Decimal | None = key(
        f.ANGULAR_SPEED,
        None,
        meaning='Angular speed of the shaft, "3000 rpm"; default: that of the drive.',
        missing=Missing("angular speed", 'speed = "3000 rpm"', 1),
        also=("rpm", "n", "omega", "ω"),
    )
    orders: tuple[int, ...] = key(
        many(ORDER, f.NOT_EMPTY, f.NO_REPEATS, first=f.FEW),
        ORDERS,
        meaning="Orders of the harmonics (порядки гармоник) that are told.",
    )
    axis: Decimal = key(
        f.ANGLE, Decimal(90), meaning="Direction of the reference guide of [bank.unit] on the sheet, from +x."
    )
    unit: UnitTable | None = key(
        table(UnitTable),
        None,
        meaning="One mechanism, a slider-crank, by its sizes; without it the mechanism is the scene's linkage.",
    )
    members: tuple[MemberTable, ...] = key(
        many(table(MemberTable), f.NOT_EMPTY, Check(_check_apart), first=f.FEW),
        meaning="The mechanisms of the bank.",
        missing=Missing("list of members", MEMBER, [{"crank": 0}]),
        also=("member", "cylinders", "cylinder", "mechanisms"),
    )
    compensators: tuple[CompensatorTable, ...] = key(
        many(table(CompensatorTable), Check(_check_orders), first=f.FEW),
        (),
        meaning="Compensators (компенсаторы): pairs of masses that turn against each other, an order each.",
    )

    def check(self) -> None:
        """See that the shaft turns, and that compensators are of orders that are told."""
        if self.speed == 0:
            raise wrong("zero", kind="angular speed", at=("speed",))
        strange = next((k for k, single in enumerate(self.compensators) if single.order not in self.orders), None)
        if strange is not None:
            found = self.compensators[strange].order
            wanted = ", ".join(map(str, sorted((*self.orders, found))))
            raise wrong("order_not_asked", orders=wanted, at=("compensators", strange, "order"))

    @classmethod
    def misfits(cls, value: Mapping[str, Any]) -> Iterator[Wrong]:
        """See that a bank by sizes has a speed of its own, and no other bank a direction."""
        if "unit" in value and "speed" not in value:
            yield wrong("missing", at=("speed",), why=message("why.unit"))
        if "axis" in value and "unit" not in value:
            yield wrong("spare_axis", at=("axis",))

    @classmethod
    def rules(cls) -> Form:
        """Say that the shaft turns, that a bank by sizes has a speed of its own, and no other bank a direction."""
        return {
            "dependentRequired": {"unit": ["speed"], "axis": ["unit"]},
            "not": {"properties": {"speed": {"const": 0}}, "required": ["speed"]},
        }


class BankForm(TechniqueForm):
    """What a scene says of a bank of equal mechanisms."""

    bank: BankTable = key(
        table(BankTable),
        meaning="A bank of equal mechanisms on one shaft (блок механизмов): harmonics of its forces, compensators.",
        missing=Missing("table", EXAMPLE, {"members": [{"crank": 0}]}),
    )

    def fit(self, scene: Scene) -> None:
        """See that its mechanism is known: nothing else of a bank is worth its while otherwise."""
        if scene.meaning.of(BankSurvey).faults:
            raise SceneError(scene.meaning.faults)

    @property
    def needs_turn(self) -> bool:
        """Whether it is told over a turn of the drive: that of a bank of the scene's linkage is."""
        return self.bank.unit is None


CLOSE = Decimal("1.5")  # rods to a crank: engines have three to five, and presses more


def notes_of(scene: Scene) -> Iterator[Fault]:
    """Give the notes on a scene's bank."""
    form = scene.of(BankForm).bank
    yield from odd_lengths(scene, dict(_lengths(form)))
    if form.unit is not None and form.unit.rod < CLOSE * form.unit.crank:
        yield scene.fault(("bank", "unit", "rod"), "near_rod", ratio=f"{form.unit.rod / form.unit.crank:.3g}")
    yield from _stacked(scene, form)
    drive = scene.of(LinkageForm).drive.speed if scene.has(("drive",)) and form.unit is None else None
    found, wanted = (f"{speed:.5g}" if speed else "" for speed in (form.speed, drive))
    if found and wanted and found != wanted:
        yield scene.fault(("bank", "speed"), "bank_speed", found=found, drive=wanted)


def _lengths(form: BankTable) -> Iterator[tuple[Path, Decimal]]:
    """Give the lengths m that a scene states; a zero is one in any unit."""
    stated: dict[Path, Decimal | None] = {}
    if form.unit is not None:
        stated |= {("bank", "unit", "crank"): form.unit.crank, ("bank", "unit", "rod"): form.unit.rod}
    stated |= {("bank", "members", number, "place"): member.place for number, member in enumerate(form.members)}
    for number, compensator in enumerate(form.compensators):
        path: Path = ("bank", "compensators", number)
        stated |= {(*path, "offset"): compensator.offset, (*path, "shafts"): compensator.shafts}
    return ((path, abs(size)) for path, size in stated.items() if size)


def _stacked(scene: Scene, form: BankTable) -> Iterator[Fault]:
    """Find members that would stand in each other's way: in one place, with guides alike."""
    stands = [member.stand[1:] for member in form.members]
    for number, stand in enumerate(stands):
        if stand in stands[:number]:
            yield scene.fault(("bank", "members", number), "stacked", other=stands.index(stand) + 1)
            return


LINKAGE, BALANCE = "mechanism", "balance"  # the tables of what a bank may be of


class BankSurvey(NamedTuple):
    """What the examination of a scene's bank found: what is asked, and the faults."""

    task: BankTask
    faults: list[Fault]


def task_of(scene: Scene) -> BankTask:
    """Make the task; without a speed of its own it is the drive's, in the drive's sense."""
    form = scene.of(BankForm).bank
    speed = form.speed
    if speed is None:  # of a bank that is at fault it is no matter
        speed = scene.of(LinkageForm).drive.omega if scene.has((LINKAGE,)) else Decimal(0)
    members = enumerate(form.members, 1)
    return BankTask(
        _unit(form.unit) if form.unit else None,
        tuple(Member(str(k), Fraction(one.crank), Fraction(one.place), Fraction(one.axis)) for k, one in members),
        float(speed),
        tuple(sorted(form.orders)),
        tuple(map(_asked, form.compensators)),
        math.radians(float(form.axis)) if form.unit else 0.0,
    )


def _unit(unit: UnitTable) -> Unit:
    return Unit(float(unit.crank), float(unit.rod), float(unit.rotating), float(unit.reciprocating))


def _asked(compensator: CompensatorTable) -> Asked:
    return Asked(compensator.order, _float(compensator.mass), float(compensator.offset), _float(compensator.shafts))


def _float(value: Decimal | None) -> float | None:
    return None if value is None else float(value)


def faults_of(meaning: Meaning) -> Iterator[Fault]:
    """See that a bank is of one mechanism: its own by sizes, or the scene's linkage."""
    scene = meaning.scene
    form, linked = scene.of(BankForm).bank, scene.has((LINKAGE,))
    if form.unit is not None and linked:
        yield scene.fault(("bank", "unit"), "two_units")
    elif form.unit is None and linked:
        yield from _of_linkage(meaning)
    elif form.unit is None and not any(path[:2] in (("bank",), ("bank", "unit")) for path in meaning.doubts):
        yield scene.fault(("bank",), "no_unit", example=UNIT)


def _of_linkage(meaning: Meaning) -> Iterator[Fault]:
    """See that the crank of a bank's linkage turns evenly, and that something moves."""
    linkage = meaning.of(LinkageSurvey)
    survey = replace(linkage, faults=[])
    if survey.form.drive.acceleration:
        survey.report(("drive", "acceleration"), "uneven_bank")
    if not meaning.scene.has((BALANCE,)):  # else that has told it
        check_moving(survey, ("bank",))
    yield from survey.faults


def asked_of(scene: Scene) -> tuple[str, ...]:
    """Name the techniques that a bank without a mechanism of its own is of (row of the table)."""
    return () if scene.of(BankForm).bank.unit is not None else ("linkage", "forces", "balance")
