"""The form of a force analysis: masses, loads, friction, and what drives the machine (исходные данные)."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from decimal import Decimal

from plans.forces.reading import fields as h
from plans.forces.reading.ends import Vector, point_of
from plans.forces.reading.loads import LoadsTable
from plans.linkage.reading import fields as g
from plans.linkage.reading.form import LinkageForm, check_capacity
from plans.model.machine import COUPLING, FORCE, MOMENT
from plans.model.mechanism import Link
from plans.scene import fields as f
from plans.scene.faults import wrong
from plans.scene.forms import Form
from plans.scene.readers import either, many, named
from plans.scene.scene import Scene, TechniqueForm
from plans.scene.tables import Missing, Table, key, table

FORCES = "forces"  # the sheet
# Links times positions of a run with forces: their numbers by both roads, and the text of them, take up to 3.8 kB each.
FORCE_POSITIONS_LIMIT = 500_000
BALANCINGS = (MOMENT, COUPLING, FORCE)
MIDDLE = "middle"  # of a link's first two points: where its mass centre is
COEFFICIENT = "reduced coefficient of friction"


class GearTable(Table):
    """The gear by which the machine is driven: pitch radius, place of the pinion, pressure angle."""

    radius: Decimal = key(
        f.LENGTH,
        meaning="Radius of the pitch circle of the crank's wheel.",
        missing=Missing("pitch radius", 'radius = "180 mm"'),
    )
    at: Decimal = key(
        f.ANGLE,
        meaning="Where the driving pinion meets the wheel, from +x.",
        missing=Missing("angle of the pinion", "at = 210"),
    )
    pressure_angle: Decimal = key(
        h.PRESSURE_ANGLE, Decimal(20), meaning="Pressure angle of the teeth (угол зацепления)."
    )


class TransmissionTable(Table):
    """Of the drive what forces need: what balances the crank, or the gear that turns it."""

    balancing: str = key(
        f.words(*BALANCINGS),
        MOMENT,
        meaning=(
            "What balances the crank: a moment; a coupling (муфта), a moment as well: neither loads the shaft; or a "
            "force at the crank's end, square to it."
        ),
    )
    gear: GearTable | None = key(
        table(GearTable), None, meaning="The gear that drives the machine; without it the drive is a pure moment."
    )

    def check(self) -> None:
        """See that the crank is driven in one way."""
        if self.gear is not None and "balancing" in self.given:
            raise wrong("one_of_two", first="balancing", second="gear", found="both", at=("balancing",))

    @classmethod
    def rules(cls) -> Form:
        """Say that the crank is driven in one way."""
        return {"not": {"required": ["balancing", "gear"]}}


class MassTable(Table):
    """Mass kg, moment of inertia about the mass centre kg*m2, and the centre in its frame, or by a point."""

    mass: Decimal = key(f.MASS, meaning="Mass.", missing=Missing("mass", 'mass = "3 kg"'))
    inertia: Decimal = key(f.INERTIA, Decimal(0), meaning="Moment of inertia about the mass centre, not about a hinge.")
    centre: str | Vector = key(
        either(list, f.PLACE, f.POINT),
        (Decimal(0), Decimal(0)),
        meaning='Mass centre in the link\'s own frame; "middle" of its first two points, or a point of the link.',
    )

    def place(self, link: Link) -> complex:
        """Give the mass centre in the frame of its link; the middle is that of the link's first two points."""
        if isinstance(self.centre, str) and self.centre != MIDDLE:
            return link.points[self.centre]
        if isinstance(self.centre, str):
            first, second = list(link.points.values())[:2]
            return (first + second) / 2
        return complex(float(self.centre[0]), float(self.centre[1]))


class PairTable(Table):
    """Friction of one pair, where it differs from that of all: coefficient, journal radius m, length of contact m."""

    coefficient: Decimal | None = key(h.FRICTION, None, meaning="Reduced coefficient of friction.")
    radius: Decimal | None = key(f.LENGTH, None, meaning="Journal radius of a hinge.")
    length: Decimal | None = key(f.LENGTH, None, meaning="Length of contact of a sliding pair.")


class FrictionTable(Table):
    """Friction of all pairs: reduced coefficient, journal radius m of hinges, length of contact m of slides."""

    coefficient: Decimal = key(
        h.FRICTION,
        meaning="Reduced coefficient of friction of all pairs (приведённый коэффициент трения).",
        missing=Missing(COEFFICIENT, "coefficient = 0.1"),
    )
    radius: Decimal = key(
        f.LENGTH,
        meaning="Journal radius of the hinges (радиус цапфы).",
        missing=Missing("journal radius of the hinges", 'radius = "20 mm"'),
    )
    length: Decimal | None = key(
        f.LENGTH,
        None,
        meaning=(
            "Length of contact of the slides: where the force passes beyond it, two edges press; without it none do."
        ),
    )
    pairs: Mapping[str, PairTable] = key(
        named(g.PAIR, table(PairTable), first=f.FEW),
        {},
        meaning='What differs in single pairs, by their links, the lower first: "0-1".',
    )


class ForceSheetTable(Table):
    """Of the sheet what shows forces: positions of the force sheets, the letter of reactions, hodographs."""

    forces: tuple[int, ...] = key(
        many(f.POSITION, f.NO_REPEATS, first=f.FEW),
        (),
        meaning="Positions of the force sheets, a sheet each; default: `position`, or where the scene names none, of "
        "those in which loads act the one of the largest balancing moment.",
    )
    reactions: str = key(f.words("R", "P", "F"), "R", meaning="The letter of reactions.")
    hodographs: tuple[str, ...] = key(
        many(g.PAIR, f.NO_REPEATS, first=f.FEW),
        (),
        meaning='Pairs whose reaction is drawn over the turn (годограф): "0-1".',
    )


class ForceForm(TechniqueForm):
    """What a scene says of the forces on a linkage; a scene that says nothing has none."""

    masses: Mapping[int, MassTable] = key(
        named(g.LINK_NUMBER, table(MassTable), first=g.FEW_LINKS), {}, meaning="Masses of links, by their numbers."
    )
    loads: LoadsTable | None = key(table(LoadsTable), None, meaning="Gravity, forces, moments and springs.")
    friction: FrictionTable | None = key(table(FrictionTable), None, meaning="Friction of the pairs (трение).")
    drive: TransmissionTable = key(table(TransmissionTable), TransmissionTable(), meaning="What drives the crank.")
    sheet: ForceSheetTable = key(table(ForceSheetTable), ForceSheetTable(), meaning="What of forces is shown.")

    def borrowed(self) -> Iterable[str]:
        """Give the points that springs and forces between links are hung on, and those that forces act along."""
        loads = self.loads or LoadsTable()
        hung = [*(spring.between for spring in loads.springs), *(force.between or () for force in loads.forces)]
        yield from (point_of(end) for ends in hung for end in ends)
        yield from (name for force in loads.forces if isinstance(force.direction, tuple) for name in force.direction)

    def fit(self, scene: Scene) -> None:
        """See that a run with forces has room for its positions."""
        if FORCES in scene.sheets:
            form = scene.of(LinkageForm)
            check_capacity(len(form.mechanism.links), form.drive.count, FORCE_POSITIONS_LIMIT, "FORCE_POSITIONS_LIMIT")
