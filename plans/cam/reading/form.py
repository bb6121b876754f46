"""The cams as the scene gives them (данные кулачков): follower, phases with their laws, limits, sizes, loads."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from decimal import Decimal
from typing import Any

from plans.cam.reading import fields as c
from plans.cam.reading.fields import Measure
from plans.cam.reading.phase_form import PhaseTable
from plans.model.cam import DWELL, FLAT, FORCE, GROOVE, POINTED, ROCKING, ROLLER, TRANSLATING
from plans.scene import fields as f
from plans.scene import forms, units
from plans.scene.faults import SceneError, Wrong, wrong
from plans.scene.forms import Form
from plans.scene.readers import many
from plans.scene.scene import Scene, TechniqueForm
from plans.scene.tables import Missing, Table, key, table

WITH, AGAINST = "with", "against"
# A line that would do for a phase, and one for a cam.
PHASE = '[[cam.phases]] with kind = "rise", angle = 120 and law = "sine"'
FOLLOWER = 'follower = { motion = "translating", end = "roller", lift = "30 mm" }'
EXAMPLE = '[[cam]] with follower = { motion = "translating", end = "roller", lift = "30 mm" }'
SPARE_FOLLOWER = {"motion": TRANSLATING, "end": POINTED, "lift": 0}
SPARE_PHASE = {"kind": DWELL, "angle": 360}


class FollowerTable(Table):
    """The follower: how it moves, what touches the cam, how far it goes."""

    motion: str = key(
        f.words(TRANSLATING, ROCKING),
        meaning="Translating (поступательный толкатель) or rocking (коромысло).",
        missing=Missing("motion of the follower", 'motion = "translating"', TRANSLATING),
    )
    end: str = key(
        f.words(POINTED, ROLLER, FLAT),
        meaning="Pointed (остриё), with a roller (ролик) or flat-faced (тарелка).",
        missing=Missing("end of the follower", 'end = "roller"', POINTED),
    )
    lift: Decimal | None = key(
        c.SIZE,
        None,
        meaning="Of one that translates: lift (ход), m.",
        missing=Missing("lift", 'lift = "30 mm"', 0),
        also=("h", "stroke", "hub"),
    )
    swing: Decimal | None = key(
        c.SWING,
        None,
        meaning="Of one that rocks: swing (угол размаха), degrees.",
        missing=Missing("swing", "swing = 25", 0),
        also=("psi", "ψ", "angle"),
    )
    length: Decimal | None = key(
        f.LENGTH,
        None,
        meaning="Of one that rocks: from its pivot to its tip or its roller's centre, m; a flat one has none.",
        missing=Missing("length of the rocker", 'length = "120 mm"', 1),
        also=("l", "arm"),
    )
    turns: str = key(
        f.words(WITH, AGAINST), WITH, meaning="Of one that rocks: whether it rises with the turn of the cam or against."
    )
    face: Decimal = key(
        f.COORDINATE,
        Decimal(0),
        meaning="Of a flat one that rocks: how far its face stands off its pivot, m, above 0 away from the cam.",
    )
    reach: Decimal | None = key(
        f.LENGTH,
        None,
        meaning="Of a flat one: reach of its face, m, to either side of its axis, or along the rocker from its pivot.",
        also=("width", "b"),
    )

    @classmethod
    def misfits(cls, value: Mapping[str, Any]) -> Iterator[Wrong]:
        """See that what its motion needs is given."""
        yield from (wrong("missing", at=(name,)) for name in _wanted(value) if name not in value)

    @classmethod
    def rules(cls) -> Form:
        """Say that what its motion needs is given."""
        rocking = {"properties": {"motion": forms.choice((ROCKING,))}, "required": ["motion"]}
        flat = {"properties": {"end": forms.choice((FLAT,))}, "required": ["end"]}
        translating = {"properties": {"motion": forms.choice((TRANSLATING,))}, "required": ["motion"]}
        return {
            "allOf": [
                {"if": translating, "then": {"required": ["lift"]}},
                {"if": rocking, "then": {"required": ["swing"]}},
                {"if": {**rocking, "not": flat}, "then": {"required": ["length"]}},
            ]
        }


def _wanted(value: Mapping[str, Any]) -> Iterator[str]:
    """Give what a follower needs."""
    if value.get("motion") == TRANSLATING:
        yield "lift"
    if value.get("motion") == ROCKING:
        yield "swing"
        if value.get("end") != FLAT:
            yield "length"


class LimitsTable(Table):
    """What the main sizes must keep to."""

    rise: Decimal | None = key(
        c.LIMIT,
        None,
        meaning="Largest pressure angle (угол давления), degrees: on the rise, in a groove on the return too; the book "
        "has 30, of a rocker 45.",
    )
    return_: Decimal | None = key(
        c.LIMIT,
        None,
        meaning="Largest size of the pressure angle below 0, degrees: on the return, in a groove on the rise too; with "
        "closure by force none is kept to.",
    )
    curvature: Decimal = key(
        c.SIZE, Decimal(0), meaning="Least radius of curvature of the profile under a flat face, m."
    )


class SizesTable(Table):
    """Main sizes that are given; what is missing is found."""

    base: Decimal | None = key(
        f.LENGTH, None, meaning="Least radius R0 of the pitch profile (минимальный радиус), m.", also=("r0", "r_0")
    )
    offset: Decimal | None = key(
        f.COORDINATE,
        None,
        meaning="Eccentricity e (эксцентриситет), m, above 0 where it lowers the pressure angle on the rise.",
        also=("e", "eccentricity"),
    )
    centre: Decimal | None = key(
        f.LENGTH,
        None,
        meaning="Of a rocking follower: distance L of the centres (межцентровое расстояние), m.",
        missing=Missing("distance of the centres", 'centre = "150 mm"'),
        also=("l", "center", "distance"),
    )
    roller: Decimal | None = key(
        c.SIZE,
        None,
        meaning="Radius of the roller (радиус ролика), m; default: the least of 0.7 of the radius of curvature, in a "
        "groove of the hollow too, and of 0.4 R0.",
        also=("r", "r_r", "radius"),
    )


class LoadTable(Table):
    """What the follower bears, against its rise."""

    mass: Decimal | None = key(f.MASS, None, meaning="Of one that translates: mass, kg.", also=("m",))
    force: Decimal | None = key(f.number(units.FORCE), None, meaning="Of one that translates: force on it, N.")
    inertia: Decimal | None = key(f.INERTIA, None, meaning="Of one that rocks: moment of inertia about its pivot.")
    moment: Decimal | None = key(f.number(units.MOMENT), None, meaning="Of one that rocks: moment on it, N*m.")
    preload: Measure | None = key(c.PRELOAD, None, meaning="Spring (пружина) at the start: N, or N*m of a rocker.")
    stiffness: Measure | None = key(
        c.STIFFNESS, None, meaning="Stiffness (жёсткость) of the spring: N/m, or N*m/rad of a rocker.", also=("c", "k")
    )


class HubTable(Table):
    """How a cam that turns sits on its shaft."""

    bore: Decimal = key(
        f.LENGTH,
        meaning="Diameter of the bore (отверстие), m.",
        missing=Missing("diameter of the bore", 'bore = "30 mm"', 1),
        also=("d", "diameter", "shaft"),
    )
    width: Decimal | None = key(
        c.SIZE,
        None,
        meaning="Width b of the keyway (шпоночный паз), m; default: by GOST 23360 and ISO 773 for the bore; 0: none.",
        also=("b", "key", "keyway"),
    )
    depth: Decimal | None = key(
        f.LENGTH,
        None,
        meaning="Depth t2 of the keyway in the hub, m; default: by the standard.",
        also=("t", "t2", "t_2"),
    )
    angle: Decimal = key(
        f.ANGLE,
        Decimal(0),
        meaning="Of the keyway's axis from the zero ray of the profile, degrees against the rotation.",
    )
    length: Decimal | None = key(f.LENGTH, None, meaning="Of the hub along the shaft (длина ступицы), m.")


class CamTable(Table):
    """A cam: its follower, phases, limits, sizes, load, and how it stands on the shaft."""

    name: str = key(c.CAM_NAME, "", meaning="Its name on the sheet; default: its number.")
    speed: Measure | None = key(
        c.SPEED,
        None,
        meaning='Speed, rad/s or "300 rpm", of a cam that translates m/s; negative is clockwise, or to the right; '
        "default: the drive's, where there is one.",
        also=("rpm", "n", "omega", "ω"),
        missing=Missing("angular speed", 'speed = "300 rpm"'),
    )
    closure: str = key(
        f.words(FORCE, GROOVE),
        FORCE,
        meaning="What holds the follower: force (силовое замыкание) or groove (пазовое).",
        missing=Missing("closure", 'closure = "groove"'),
        also=("closing", "closed", "lock"),
    )
    setting: Decimal | str = key(
        c.SETTING,
        Decimal(0),
        meaning="Turn of the main shaft at which its first phase begins (установочный угол), degrees in the sense of "
        'rotation; "cyclogram": with the window of the cyclogram.',
    )
    divisions: int = key(c.DIVISIONS, 8, meaning="Parts of each phase that moves the follower: numbered positions.")
    coordinates: int = key(
        c.COORDINATES,
        360,
        meaning="Parts of the turn at which the file beside the sheet profile tells the profile's coordinates.",
    )
    follower: FollowerTable = key(
        table(FollowerTable), meaning="The follower (толкатель).", missing=Missing("follower", FOLLOWER, SPARE_FOLLOWER)
    )
    limits: LimitsTable = key(table(LimitsTable), LimitsTable(), meaning="What the main sizes must keep to.")
    sizes: SizesTable = key(table(SizesTable), SizesTable(), meaning="Main sizes that are given; the others are found.")
    phases: tuple[PhaseTable, ...] = key(
        many(table(PhaseTable), f.NOT_EMPTY, first=f.FEW),
        meaning="Phases (фазы) in their order over the turn; their angles make 360 degrees.",
        missing=Missing("list of phases", PHASE, [SPARE_PHASE]),
    )
    load: LoadTable | None = key(table(LoadTable), None, meaning="What the follower bears; its mass needs a speed.")

    hub: HubTable | None = key(
        table(HubTable),
        None,
        meaning="Bore and keyway (ступица) of a cam that turns, on the sheet profile; default: none is drawn.",
    )


class CamForm(TechniqueForm):
    """What a scene says of its cams."""

    cam: tuple[CamTable, ...] = key(
        many(table(CamTable), f.NOT_EMPTY, first=f.FEW),
        meaning="A cam (кулачок), one or several on one shaft: follower, phases with their laws, limits or sizes.",
        missing=Missing("table", EXAMPLE, [{"follower": SPARE_FOLLOWER, "phases": [SPARE_PHASE]}]),
    )

    def fit(self, scene: Scene) -> None:
        """See that its cams can be made: nothing else of a scene is worth its while otherwise."""
        if scene.meaning["cam"].faults:
            raise SceneError(scene.meaning.faults)

    @property
    def needs_turn(self) -> bool:
        """Whether it is told over a turn of the drive: that of a cam on the drive's shaft is."""
        return any(cam.speed is None for cam in self.cam)
