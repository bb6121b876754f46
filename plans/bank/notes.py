"""Notes on a bank (замечания): what is allowed, but may well be a slip, such as members without places."""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal

from plans.bank.form import BankForm, BankTable, UnitTable
from plans.linkage.reading.form import LinkageForm
from plans.scene.faults import Fault, Path
from plans.scene.notes import odd_lengths
from plans.scene.scene import Scene

CLOSE = Decimal("1.5")  # rods to a crank: engines have three to five, and presses more


def notes_of(scene: Scene) -> Iterator[Fault]:
    """Give the notes on a scene's bank (row of the table of techniques)."""
    form = scene.of(BankForm).bank
    yield from odd_lengths(scene, dict(_lengths(form)))
    if form.unit is not None and form.unit.rod < CLOSE * form.unit.crank:
        yield scene.fault(("bank", "unit", "rod"), "near_rod", ratio=f"{form.unit.rod / form.unit.crank:.3g}")
    yield from _stacked(scene, form)
    yield from _speed(scene, form)


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


def _speed(scene: Scene, form: BankTable) -> Iterator[Fault]:
    """Find a speed other than that of the drive: forces and balancing of the linkage are told at that one."""
    drive = scene.of(LinkageForm).drive.speed if scene.has(("drive",)) and form.unit is None else None
    found, wanted = (f"{one:.5g}" if one else "" for one in (form.speed, drive))
    if found and wanted and found != wanted:
        yield scene.fault(("bank", "speed"), "bank_speed", found=found, drive=wanted)
