"""The study of a gear train: its plans of velocities, one for each gear, and its ratios (кинематика передач)."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import replace
from functools import cached_property

from plans.gears.form import GearsForm, WheelTable, geared
from plans.gears.kutzbach import ANGULAR, LINEAR, KutzbachPlan, TrainPoint, plans_of, spots_of
from plans.gears.reading import GearsSurvey
from plans.model.gears import BoxGear, Train, freed, joint_name
from plans.model.trains import determined, mobility
from plans.scene.faults import SceneError
from plans.study import Study

GEARS = "gears"  # the technique, and its sheet


class GearsStudy:
    """A gear train and its plans."""

    def __init__(self, study: Study) -> None:
        if faults := study.scene.meaning.faults:
            raise SceneError(faults)
        survey = study.scene.meaning.of(GearsSurvey)
        train, self.searched = survey.train, survey.searched
        assert train is not None  # it is without faults
        self.made, self._form = set[str](), study.scene.of(GearsForm).gears
        self.resisted = study.driving if geared(study.scene) else None  # N*m, by a machine whose crank it turns
        self.train = train if train.load is not None else replace(train, load=self.resisted)

    @property
    def lacking(self) -> tuple[str, ...]:
        """The wheels whose teeth coaxiality gives."""
        tables = ((name, one) for name, one in self._form.wheels.items() if isinstance(one, WheelTable))
        return tuple(name for name, wheel in tables if wheel.teeth is None and not wheel.rack)

    @property
    def force(self) -> tuple[str, float] | None:
        """The rack that a force N resists."""
        return None if self._form.force is None else (self._form.output, float(self._form.force))

    def engaged(self, gear: BoxGear) -> tuple[str, ...]:
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

    def released(self, plan: KutzbachPlan, train: Train) -> Iterator[tuple[str, tuple[str, ...], KutzbachPlan]]:
        """Give for each drive, held link and joint of shafts, by its name and links, the plan of what it alone moves.

        There the other driving links are held. Of the train itself, with one drive, its plan is there; with friction,
        whose moments are as the speeds of another train, not.
        """
        gear, drives, own = plan.gear, tuple(link for link, _ in train.drives), train.single and not train.factors
        if own:
            yield drives[0], drives, plan
        for link in (*(() if own else drives), *gear.held):
            held = (one for one in (*gear.held, *drives) if one != link)
            yield from self._moved(train, freed(gear, link, held), link, (link,))
        for pair in train.joints if self.closed(gear) else ():
            joined, name = tuple(one for one in train.joints if one != pair), joint_name(pair)
            yield from self._moved(replace(train, joined=joined), freed(gear, name, (*gear.held, *drives)), name, pair)

    def closed(self, gear: BoxGear) -> bool:
        """Whether a train is closed in a gear, so that power divides: its plan rests on an assumed speed."""
        return any(plan.assumed for plan in self.plans if plan.gear == gear)

    def _moved(
        self, train: Train, gear: BoxGear, name: str, links: tuple[str, ...]
    ) -> Iterator[tuple[str, tuple[str, ...], KutzbachPlan]]:
        for link in links:
            driven = replace(train, drives=((link, 1.0),), gears=(gear,))
            if mobility(driven, gear) == 1 and determined(driven, gear):
                yield name, links, plans_of(driven)[0]
                return

    @cached_property
    def spots(self) -> tuple[TrainPoint, ...]:
        """The points of the train."""
        return spots_of(self.train)

    @property
    def ratio_name(self) -> str:
        """The letter of the ratio: U_1H."""
        return f"U_{pair_of(self.train.drives[0][0], self.train.output)}"

    @property
    def efficiency_name(self) -> str:
        """The letter of the efficiency: η_1H; of a train with several drives η."""
        train = self.train
        return f"η_{pair_of(train.drives[0][0], train.driven or train.output)}" if train.single else "η"


def pair_of(one: str, other: str) -> str:
    """Write the links of a ratio beside each other, with a comma where numbers would run into one.

    >>> pair_of("1", "H2"), pair_of("1", "12")
    ('1H2', '1,12')
    """
    return f"{one},{other}" if len(one) + len(other) > 2 and (one + other).isdigit() else f"{one}{other}"


def of_gear(name: str, gear: BoxGear) -> str:
    """Name a quantity in a gear of a box.

    >>> of_gear("ω_H", BoxGear("II", (), ()))
    'ω_H,II'
    """
    return f"{name},{gear.name}" if gear.name else name
