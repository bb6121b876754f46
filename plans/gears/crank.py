"""The gear train before a crank (машинный агрегат): its turns for one of the crank, and its inertia there."""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal
from fractions import Fraction
from typing import NamedTuple

from plans.forces.reading.form import ForceForm
from plans.linkage.reading.form import LinkageForm
from plans.model.gears import FRAME, Train
from plans.model.trains import inertia, shares
from plans.scene.faults import Fault, Path
from plans.scene.scene import Scene
from plans.scene.units import WORKING

SAME = Decimal("1e-9")  # of a speed or a radius: what the digits of a written one leave out


class CrankTrain(NamedTuple):
    """A train whose driven link is on the crank's shaft, and the speed rad/s of its driving link as it is written."""

    train: Train
    driving: Decimal

    @property
    def links(self) -> tuple[str, ...]:
        """Its links on fixed axes."""
        return tuple(link for link in self.train.links if link not in self.train.carrier_of)

    @property
    def fits(self) -> bool:
        """Whether the crank has one speed for one of the drive."""
        train = self.train
        return (
            len(train.gears) == 1
            and train.single
            and not train.driven
            and shares(train, train.gears[0])[train.output][0] != 0
        )

    def turns(self, link: str) -> Decimal:
        """Give the turns of a link for one of the crank."""
        return self._decimal(self._turns(link))

    @property
    def ratio(self) -> Fraction:
        """The turns of the driving link for one of the crank: U."""
        return self._turns(self.train.drives[0][0])

    def _turns(self, link: str) -> Fraction:
        found = shares(self.train, self.train.gears[0])
        return found[link][0] / found[self.train.output][0]

    @property
    def speed(self) -> Decimal:
        """The speed of the crank, rad/s."""
        return self._decimal(Fraction(self.driving) / self.ratio)

    @staticmethod
    def _decimal(value: Fraction) -> Decimal:
        return WORKING.divide(Decimal(value.numerator), Decimal(value.denominator))

    @property
    def inertia(self) -> float:
        """Its inertia reduced to the crank, kg*m2."""
        return inertia(self.train, self.train.gears[0], self.train.output) or 0.0

    def faults(self, scene: Scene) -> Iterator[Fault]:
        """Give what of the crank is another one's: its ratio, its speed, its wheel."""
        output, forces = self.train.output, scene.part("forces")
        if not self.fits:
            yield scene.fault(("drive", "train"), "no_one_ratio", link=self.train.driven or output)
            return
        yield from self.unlike(scene, ("drive", "speed"), scene.of(LinkageForm).drive.speed)
        gear = forces.drive.gear if isinstance(forces, ForceForm) else None
        some = self.train.meshes_of(output)
        radii = [float(one.radius) for one, other in some if self.train.carrier_between(one, other) == FRAME]
        if gear and not any(abs(float(gear.radius) - one) <= float(SAME) * one for one in radii):
            known = ", ".join(f"{1000 * one:.6g} mm" for one in radii) or "-"
            yield scene.fault(("drive", "gear", "radius"), "wheel_of_train", link=output, known=known)

    def unlike(self, scene: Scene, path: Path, speed: Decimal | None) -> Iterator[Fault]:
        """Tell a speed of the crank that the train does not give it."""
        if speed is not None and abs(speed - self.speed) > SAME * abs(self.speed):
            numbers = {"found": speed, "wanted": self.speed, "driving": self.driving}
            told = {name: f"{float(value):.7g}" for name, value in numbers.items()}
            yield scene.fault(path, "speed_of_train", link=self.train.output, ratio=str(self.ratio), **told)
