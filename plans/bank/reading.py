"""The bank made from the scene, its faults and its notes (блок механизмов по исходным данным)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from decimal import Decimal
from fractions import Fraction
from typing import NamedTuple

from plans.balance.reading import check_moving
from plans.bank.form import UNIT, BankForm, BankTable, CompensatorTable, UnitTable
from plans.linkage.reading.form import LinkageForm
from plans.linkage.reading.survey import Survey
from plans.model.balance.bank import Asked, BankTask, Member, Unit
from plans.scene.faults import Fault, Path
from plans.scene.notes import odd_lengths
from plans.scene.scene import Meaning, Scene

CLOSE = Decimal("1.5")  # rods to a crank: engines have three to five, and presses more


def notes_of(scene: Scene) -> Iterator[Fault]:
    """Give the notes on a scene's bank (row of the table of techniques)."""
    form = scene.of(BankForm).bank
    yield from odd_lengths(scene, dict(_lengths(form)))
    if form.unit is not None and form.unit.rod < CLOSE * form.unit.crank:
        yield scene.fault(("bank", "unit", "rod"), "near_rod", ratio=f"{form.unit.rod / form.unit.crank:.3g}")
    yield from _stacked(scene, form)
    yield from _speed_notes(scene, form)


def _lengths(form: BankTable) -> Iterator[tuple[Path, Decimal]]:
    """Give the lengths m that a scene states; a zero is one in any unit."""
    stated: dict[Path, Decimal | None] = {}
    if form.unit is not None:
        stated |= _of_unit(form.unit)
    stated |= {("bank", "members", number, "place"): one.place for number, one in enumerate(form.members)}
    for number, one in enumerate(form.compensators):
        path: Path = ("bank", "compensators", number)
        stated |= {(*path, "offset"): one.offset, (*path, "shafts"): one.shafts}
    return ((path, abs(size)) for path, size in stated.items() if size)


def _of_unit(unit: UnitTable) -> dict[Path, Decimal | None]:
    return {("bank", "unit", "crank"): unit.crank, ("bank", "unit", "rod"): unit.rod}


def _stacked(scene: Scene, form: BankTable) -> Iterator[Fault]:
    """Find members that would stand in each other's way: in one place, with guides alike."""
    stands = [one.stand[1:] for one in form.members]
    for number, stand in enumerate(stands):
        if stand in stands[:number]:
            yield scene.fault(("bank", "members", number), "stacked", other=stands.index(stand) + 1)
            return


def _speed_notes(scene: Scene, form: BankTable) -> Iterator[Fault]:
    """Find a speed other than that of the drive: forces and balancing of the linkage are told at that one."""
    drive = scene.of(LinkageForm).drive.speed if scene.has(("drive",)) and form.unit is None else None
    found, wanted = (f"{one:.5g}" if one else "" for one in (form.speed, drive))
    if found and wanted and found != wanted:
        yield scene.fault(("bank", "speed"), "bank_speed", found=found, drive=wanted)


LINKAGE, BALANCE = "mechanism", "balance"  # the tables of what a bank may be of


class BankSurvey(NamedTuple):
    """What the examination of a scene's bank found: what is asked, and the faults."""

    task: BankTask
    faults: list[Fault]


def task_of(scene: Scene) -> BankTask:
    """Make the task; without a speed of its own it is the drive's, in the drive's sense."""
    form = scene.of(BankForm).bank
    return BankTask(
        _unit(form.unit) if form.unit else None,
        tuple(_members(form)),
        float(_speed(scene, form)),
        tuple(sorted(form.orders)),
        tuple(map(_asked, form.compensators)),
        math.radians(float(form.axis)) if form.unit else 0.0,
    )


def _speed(scene: Scene, form: BankTable) -> Decimal:
    """Give the speed; of a bank that is at fault it is no matter."""
    if form.speed is not None:
        return form.speed
    return scene.of(LinkageForm).drive.omega if scene.has((LINKAGE,)) else Decimal(0)


def _unit(one: UnitTable) -> Unit:
    return Unit(float(one.crank), float(one.rod), float(one.rotating), float(one.reciprocating))


def _members(form: BankTable) -> Iterator[Member]:
    for number, one in enumerate(form.members, 1):
        yield Member(str(number), Fraction(one.crank), Fraction(one.place), Fraction(one.axis))


def _asked(one: CompensatorTable) -> Asked:
    return Asked(one.order, _float(one.mass), float(one.offset), _float(one.shafts))


def _float(value: Decimal | None) -> float | None:
    return None if value is None else float(value)


def survey_of(meaning: Meaning) -> BankSurvey:
    """Examine a scene's bank (row of the table of techniques)."""
    return BankSurvey(task_of(meaning.scene), list(_faults(meaning)))


def _faults(meaning: Meaning) -> Iterator[Fault]:
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
    linkage: Survey = meaning["linkage"]
    survey = replace(linkage, faults=[])
    if survey.form.drive.acceleration:
        survey.report(("drive", "acceleration"), "uneven_bank")
    if not meaning.scene.has((BALANCE,)):  # else that has told it
        check_moving(survey, ("bank",))
    yield from survey.faults


def asked_of(scene: Scene) -> tuple[str, ...]:
    """Name the techniques that a bank without a mechanism of its own is of (row of the table)."""
    return () if scene.of(BankForm).bank.unit is not None else ("linkage", "forces", "balance")
