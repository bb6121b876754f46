"""The form of a force analysis: masses, loads, friction, and what drives the machine (исходные данные)."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from decimal import Decimal

from plans.forces.reading import fields as h
from plans.forces.reading.fields import Ends, LinkLoadTable, Vector
from plans.forces.reading.pressed import PressedTable, with_piston
from plans.linkage.reading import fields as g
from plans.linkage.reading.form import LinkageForm, check_capacity
from plans.model.machine import ALWAYS, COUPLING, FORCE, MOMENT, WORKING
from plans.model.mechanism import Link
from plans.scene import fields as f
from plans.scene.faults import wrong
from plans.scene.forms import Form
from plans.scene.readers import either, many, named
from plans.scene.scene import Scene, TechniqueForm
from plans.scene.tables import Missing, Table, key, table
from plans.words.words import message

# What editors are told of keys that fit each other or do not.
_LIST = {"required": ["value"], "properties": {"value": {"type": "array"}}}
_ASIDE: list[Form] = [{"required": ["against"]}, {"required": ["direction"]}]
_ON: list[Form] = [{"required": ["on"]}, {"required": ["point"]}]
_SIZES = ("value", "diagram", "pressure")
_BACK = {"diagram": {"required": ["back"]}}


class ForceTable(PressedTable):
    """A force on a point of a link: a vector N; or a size or a diagram of sizes, against the motion or at an angle."""

    on: int | None = key(h.LOADED_LINK, None, meaning="The link.", missing=h.ON_LINK)
    point: str | None = key(f.POINT, None, meaning="Point of the link.", missing=h.POINT_OF_LINK)
    between: Ends | None = key(
        h.ENDS,
        None,
        meaning='Instead of on and point: points of two links, ["B", "C"], that the force acts on, equal and opposite: '
        'it pushes them apart, a negative one draws them together; with direction = "AB" that way on the first.',
    )
    value: Decimal | Vector | None = key(
        either(list, f.pair(h.FORCE, "[Fx, Fy]"), h.FORCE),
        None,
        meaning="The force; or its size, against the motion or in a direction.",
    )
    against: str | None = key(
        f.words("motion"),
        None,
        meaning="The force acts against the motion of its point; between two links, against their parting or nearing.",
    )
    direction: Decimal | tuple[str, ...] | None = key(
        h.DIRECTION,
        None,
        meaning='The direction of the force: its angle from +x, or "AB", from point A to point B, turning with them.',
    )

    @property
    def phase(self) -> str:
        """The part of the turn in which the force acts: of a diagram against the motion, the stroke that it is of."""
        whole = self.diagram is None or self.against is None or bool(self.diagram.back)
        return self.during or (ALWAYS if whole else WORKING)

    @property
    def changes(self) -> bool:
        """Whether the force needs to know the stroke."""
        return self.diagram is not None or super().changes

    @property
    def owns_stroke(self) -> bool:
        """Whether the stroke that counts is another than the output's."""
        return super().owns_stroke or self.between is not None

    def check(self) -> None:
        """See that the force has one place and one form."""
        self._check_place()
        self._check_alone("value", "pressure")
        self._check_alone("pressure", "diagram")
        self._check_alone("value", "diagram")
        if self.given.isdisjoint(_SIZES):
            raise wrong("one_of_two", first="value", second="diagram", found="none")
        if self.between is None:
            self._check_alone("against", "direction")
        elif isinstance(self.direction, Decimal):
            raise wrong("fixed_direction", at=("direction",))
        self._check_direction()
        if self.diagram is not None and self.diagram.back and self.phase != ALWAYS:
            raise wrong("one_stroke", at=("during",))
        super().check()

    @classmethod
    def rules(cls) -> Form:
        """Say which form a force has one of, and that only one which changes over a stroke names one."""
        sized = {"if": _LIST, "then": {"not": {"anyOf": _ASIDE}}, "else": {"oneOf": _ASIDE}}
        return {
            "oneOf": [{"required": [name]} for name in _SIZES],
            "allOf": [with_piston()],
            "if": {"required": ["between"]},
            "then": {"not": {"anyOf": [*_ON, _LIST]}, "properties": {"direction": g.LINE.form()}},
            "else": {"required": ["on", "point"], **sized},
            "not": {"required": ["diagram", *h.PART["required"]], "properties": h.PART["properties"] | _BACK},
            **h.only_with_stroke({"required": ["diagram"]}, owned=("stroke", "between")),
        }

    def _check_alone(self, first: str, second: str) -> None:
        if self.given >= {first, second}:
            raise wrong("one_of_two", first=first, second=second, found="both")

    def _check_place(self) -> None:
        """See that the force is on a point of a link, or between two links."""
        for name in ("on", "point"):
            self._check_alone(name, "between")
        if self.between is None and self.given.isdisjoint(("on", "point")):
            raise wrong("acts_nowhere")
        lacking = [name for name in ("on", "point") if name not in self.given]
        if self.between is None and lacking:
            raise wrong("missing", at=(lacking[0],))

    def _check_direction(self) -> None:
        vector = isinstance(self.value, tuple)
        aside = self.against is not None or self.direction is not None or self.between is not None
        if not aside and not vector:
            wanted, advice = "a vector [Fx, Fy] in N", message("advice.vector")
            if self.value is None:
                wanted, advice = "a direction of the force", message("advice.direction")
            sized = next(name for name in _SIZES if name in self.given)
            raise wrong("force_value", wanted=wanted, advice=advice, at=(sized,))
        if vector and aside:
            raise wrong("force_value", wanted=self._wanted, advice=message("advice.size"), at=("value",))

    @property
    def _wanted(self) -> str:
        if self.between is not None:
            return "the size of the force, because it acts between two points"
        if self.direction is not None:
            return "the size of the force, because its direction is given"
        return "the size of the force, because its direction is against the motion"


class MomentTable(LinkLoadTable):
    """A moment on a link, N*m, positive counter-clockwise; or its size, against the link's rotation."""

    value: Decimal = key(
        h.MOMENT,
        meaning="Moment, positive counter-clockwise; or its size, against the rotation.",
        missing=Missing("moment", "value = 12"),
    )
    against: str | None = key(f.words("motion"), None, meaning="The moment acts against the rotation of its link.")
    on: int = key(h.LOADED_LINK, meaning="The link.", missing=h.ON_LINK)

    @classmethod
    def rules(cls) -> Form:
        """Say that only a moment which changes over a stroke names one."""
        return h.only_with_stroke()


class SpringTable(Table):
    """A spring between points of two links: its ends, stiffness N/m and free length m."""

    between: Ends = key(
        h.ENDS,
        meaning='Its two ends: points of two links, ["B", "O"].',
        missing=Missing("pair of ends", 'between = ["B", "O"]'),
    )
    stiffness: Decimal = key(h.STIFFNESS, meaning="Stiffness.", missing=Missing("stiffness", 'stiffness = "20 N/mm"'))
    free: Decimal = key(h.FREE_LENGTH, meaning="Free length.", missing=Missing("free length", 'free = "80 mm"'))
    name: str | None = h.symbol()


class LoadsTable(Table):
    """Gravity, forces, moments and springs; gravity as a number is downward, and none where it is not given."""

    gravity: Decimal | Vector | None = key(
        either(list, f.pair(h.GRAVITY, "[gx, gy]"), h.GRAVITY),
        None,
        meaning="Gravity, downward or as a vector; without it links have no weight.",
    )
    forces: tuple[ForceTable, ...] = key(many(table(ForceTable), first=f.FEW), (), meaning="Forces on points of links.")
    moments: tuple[MomentTable, ...] = key(many(table(MomentTable), first=f.FEW), (), meaning="Moments on links.")
    springs: tuple[SpringTable, ...] = key(
        many(table(SpringTable), first=f.FEW), (), meaning="Springs between points of two links (пружины)."
    )

    def check(self) -> None:
        """See that no two loads bear the same letters."""
        names = set()
        for kind in ("forces", "moments", "springs"):
            for index, load in enumerate(getattr(self, kind)):
                if load.name in names:
                    raise wrong("repeated", entry=load.name, at=(kind, index, "name"))
                names |= {load.name} - {None}


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
        meaning="What balances the crank: a moment; a coupling (муфта), a moment as well: neither loads the shaft; or "
        "a force at the crank's end, square to it.",
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
        meaning="Length of contact of the slides: where the force passes beyond it, two edges press; without it none "
        "do.",
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
        meaning="Positions of the force sheets, a sheet each; default: `position`, or where the scene names none, one "
        "in which the loads do work and the plans are open figures.",
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
        yield from (h.point_of(end) for ends in hung for end in ends)
        yield from (name for force in loads.forces if isinstance(force.direction, tuple) for name in force.direction)

    def fit(self, scene: Scene) -> None:
        """See that a run with forces has room for its positions."""
        if FORCES in scene.sheets:
            form = scene.of(LinkageForm)
            check_capacity(len(form.mechanism.links), form.drive.count, FORCE_POSITIONS_LIMIT, "FORCE_POSITIONS_LIMIT")
