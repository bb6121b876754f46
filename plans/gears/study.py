"""The study of a gear train: its plans of velocities, one for each gear, and its ratios (кинематика передач)."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from fractions import Fraction
from functools import cached_property

from plans.analytic.gears import ratio_with, shares, speeds
from plans.gears.form import GearsForm, WheelTable
from plans.gears.kutzbach import ANGULAR, LINEAR, KutzbachPlan, Spot, plans_of, spots_of
from plans.gears.reading import GearsSurvey
from plans.model.gears import Gear
from plans.study import Study

GEARS = "gears"  # the technique, and its sheet


class GearsStudy:
    """A gear train and its plans."""

    def __init__(self, study: Study) -> None:
        train = study.scene.meaning.of(GearsSurvey).train
        assert train is not None  # a scene with faults is not studied
        self.train, self.made, self._form = train, set[str](), study.scene.of(GearsForm).gears

    @property
    def lacking(self) -> tuple[str, ...]:
        """The wheels whose teeth coaxiality gives."""
        wheels = self._form.wheels.items()
        return tuple(name for name, wheel in wheels if isinstance(wheel, WheelTable) and wheel.teeth is None)

    def engaged(self, gear: Gear) -> tuple[str, ...]:
        """Name the brakes and clutches of a gear."""
        return self._form.engaged.get(gear.name, ())

    def construct(self, plans: Collection[str]) -> None:
        """Draw the plans, if they are asked for."""
        if {LINEAR, ANGULAR} & {*plans}:
            _ = self.plans

    @cached_property
    def plans(self) -> tuple[KutzbachPlan, ...]:
        """The plan of each gear."""
        self.made |= {LINEAR, ANGULAR}
        return plans_of(self.train)

    @cached_property
    def spots(self) -> tuple[Spot, ...]:
        """The points of the train."""
        return spots_of(self.train)

    def shares(self, gear: Gear) -> Mapping[str, tuple[Fraction, ...]]:
        """Give the speed of each link as shares of those of the drives, by the analysis."""
        found = shares(self.train, gear)
        assert found is not None  # its reading has seen to that
        return found

    def exact(self, gear: Gear) -> Mapping[str, Fraction]:
        """Give the speeds rad/s of all links in a gear, by the analysis."""
        return speeds(self.train, gear)

    def true(self, gear: Gear) -> Mapping[str, float]:
        """Give the speeds rad/s of all links in a gear, by the analysis, each rounded once."""
        return {link: float(speed) for link, speed in self.exact(gear).items()}

    def stopped(self, first: str, other: str, carrier: str) -> Fraction:
        """Give the ratio of two links with a carrier stopped, by the equations of the meshes alone."""
        found = ratio_with(self.train, first, other, carrier)
        assert found is not None  # the wheels mesh with planets of the carrier
        return found

    @property
    def single(self) -> bool:
        """Whether one link drives, so that there is a ratio."""
        return len(self.train.drives) == 1

    def ratio(self, gear: Gear) -> Fraction | None:
        """Give the ratio U of the driving link to the driven one; nothing of a differential, or where that rests."""
        share = self.shares(gear)[self.train.output][0]
        return 1 / share if self.single and share else None

    @property
    def ratio_name(self) -> str:
        """The letter of the ratio: U_1H."""
        return f"U_{pair_of(self.train.drives[0][0], self.train.output)}"


def pair_of(one: str, other: str) -> str:
    """Write the links of a ratio beside each other, with a comma where numbers would run into one.

    >>> pair_of("1", "H2"), pair_of("1", "12")
    ('1H2', '1,12')
    """
    return f"{one},{other}" if len(one) + len(other) > 2 and (one + other).isdigit() else f"{one}{other}"


def of_gear(name: str, gear: Gear) -> str:
    """Name a quantity in a gear of a box.

    >>> of_gear("ω_H", Gear("II", (), ()))
    'ω_H,II'
    """
    return f"{name},{gear.name}" if gear.name else name
