"""A technique that needs no linkage, for tests: a wheel, told by its own table and a key of the sheet."""

from __future__ import annotations

from decimal import Decimal

from plans.scene import fields as f
from plans.scene.scene import Meaning, TechniqueForm
from plans.scene.tables import Missing, Table, key, table


class WheelTable(Table):
    """A wheel by its radius."""

    radius: Decimal = key(f.LENGTH, meaning="Radius, m.", missing=Missing("radius", "radius = 1"))


class SpokesTable(Table):
    """Of the sheet what shows a wheel."""

    spokes: bool = key(f.FLAG, True, meaning="Whether its spokes are drawn.")


class WheelForm(TechniqueForm):
    """What a scene says of a wheel."""

    wheel: WheelTable = key(table(WheelTable), meaning="A wheel.", missing=Missing("table", "[wheel] with radius = 1"))
    sheet: SpokesTable = key(table(SpokesTable), SpokesTable())


class Survey:
    """A wheel of seven metres is faulty."""

    def __init__(self, meaning: Meaning) -> None:
        scene = meaning.scene
        large = scene.of(WheelForm).wheel.radius == 7
        self.faults = [scene.fault(("wheel", "radius"), "fixed_output", name="W")] if large else []
