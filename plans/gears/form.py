"""The form of a gear train: its keys and what they mean (зубчатый механизм: исходные данные)."""

from __future__ import annotations

import re
from collections.abc import Mapping
from decimal import Decimal

from plans.gears.wanted import EFFICIENCY, WantedTable, teeth
from plans.scene import fields as f
from plans.scene import forms, units
from plans.scene.faults import wrong
from plans.scene.readers import either, many, named, one
from plans.scene.scene import Scene, TechniqueForm
from plans.scene.tables import Missing, Table, key, table

WHEEL = re.compile(r"(?!0['′]*$)[0-9A-ZА-ЯЁ][0-9A-Za-zА-Яа-яЁё]*['′]*")  # 0 is the frame
PAIR = re.compile(r"([^\s-]+)\s*-\s*([^\s-]+)")
MOST_TEETH, LEAST_TEETH = 100_000, 3
EXAMPLE = '[gears.wheels] with 1 = 20, 2 = 50 and 3 = { teeth = 120, internal = true }; meshes = ["1-2", "2-3"]'


def check_part(value: object) -> str:
    """Read the name of a wheel, a link, a brake or a clutch: 1, 2', H1, T1."""
    if not isinstance(value, str) or not WHEEL.fullmatch(value) or len(value) > 8:
        raise wrong("part_name")
    return value.replace("′", "'")


def check_mesh(value: object) -> tuple[str, str]:
    """Read two wheels that mesh: "1-2"."""
    found = PAIR.fullmatch(value) if isinstance(value, str) else None
    if not found or found[1] == found[2]:
        raise wrong("mesh_name")
    return check_part(found[1]), check_part(found[2])


PART = one(check_part, lambda: forms.text(f"^{WHEEL.pattern}$", 8), "name")
TEETH = teeth(LEAST_TEETH, MOST_TEETH)
MESH = one(check_mesh, lambda: forms.text(r"^[^\s-]+\s*-\s*[^\s-]+$"), '"1-2"')
SIDES = ("left", "right", "up", "down")
SIDE = one(lambda value: f.choice(value, SIDES), lambda: forms.choice(SIDES), "name")
NAMES = many(PART, f.NO_REPEATS, first=f.FEW)
TWO = f.pair(PART, '["1", "H"]')


class WheelTable(Table):
    """A wheel: its teeth, whether it is a ring or a rack, a module of its own."""

    teeth: int | None = key(TEETH, None, meaning="Number of teeth; default: found from coaxiality.")
    internal: bool = key(f.FLAG, False, meaning="Whether the teeth are inside, as of a ring (внутренние зубья).")
    rack: bool = key(f.FLAG, False, meaning="Whether it is a rack (рейка), a wheel without end, which slides.")
    bevel: str | None = key(
        SIDE,
        None,
        meaning="Of a bevel wheel (коническое колесо) its side of the apex: left or right, or up or down across these.",
    )
    module: Decimal | None = key(f.MILLIMETRES, None, meaning="Module of its own, mm.")

    def check(self) -> None:
        """See that a rack, which has no circle, is told no teeth."""
        for name in ("internal", "teeth", "bevel"):
            if self.rack and getattr(self, name):
                raise wrong("toothed_rack", at=(name,))
        if self.internal and self.bevel:
            raise wrong("bevel_ring", at=("internal",))


class DrivingLinkTable(Table):
    """A driving link and its speed."""

    link: str = key(PART, meaning="The driving link.", missing=Missing("driving link", 'link = "1"'))
    speed: Decimal = key(
        f.ANGULAR_SPEED,
        meaning='Angular speed, rad/s or "1000 rpm"; negative is clockwise.',
        missing=Missing("angular speed", 'speed = "1000 rpm"'),
        also=("n", "rpm", "omega", "ω"),
    )


class GearsTable(Table):
    """A gear train: its wheels, what turns on carriers, what meshes, what holds it, what drives it."""

    wheels: Mapping[str, int | WheelTable] = key(
        named(PART, either(dict, table(WheelTable), TEETH), f.NOT_EMPTY, first=f.FEW),
        meaning="Wheels by their names: teeth, or a table; wheels whose names differ by primes are of one link: 2, 2'.",
        missing=Missing("table of wheels", EXAMPLE, {}),
    )
    meshes: tuple[tuple[str, str], ...] = key(
        many(MESH, f.NOT_EMPTY, f.NO_REPEATS, first=f.FEW),
        meaning='Wheels that mesh (зацепления): ["1-2", "2\'-3"].',
        missing=Missing("list of meshes", 'meshes = ["1-2"]'),
    )
    module: Decimal = key(
        f.MILLIMETRES, Decimal("0.001"), meaning="Module, mm, of all wheels without one of their own."
    )
    carriers: Mapping[str, tuple[str, ...]] = key(
        named(PART, NAMES, first=f.FEW),
        {},
        meaning="Carriers (водила), each with the links that turn on it (сателлиты).",
    )
    joined: tuple[tuple[str, ...], ...] = key(
        many(many(PART, f.NOT_EMPTY, f.NO_REPEATS, first=f.FEW), first=f.FEW),
        (),
        meaning='Shafts that are one: [["H1", "4"]].',
    )
    fixed: tuple[str, ...] = key(NAMES, (), meaning="Links that are held in all gears.")
    brakes: Mapping[str, str] = key(
        named(PART, PART, first=f.FEW), {}, meaning="Brakes (тормоза), each with the link that it holds."
    )
    clutches: Mapping[str, tuple[str, str]] = key(
        named(PART, TWO, first=f.FEW), {}, meaning="Clutches (муфты), each with the two links that it joins."
    )
    engaged: Mapping[str, tuple[str, ...]] = key(
        named(PART, NAMES, first=f.FEW),
        {},
        meaning="Gears of a box (передачи), each with its brakes and clutches; default: one with all of them.",
    )
    drive: tuple[DrivingLinkTable, ...] = key(
        either(list, many(table(DrivingLinkTable), f.NOT_EMPTY, first=f.FEW), table(DrivingLinkTable)),
        meaning="The driving link and its speed; of a differential a list of them.",
        missing=Missing("drive", 'drive = { link = "1", speed = "1000 rpm" }', {"link": "1", "speed": 1}),
    )
    inertia: Mapping[str, Decimal] = key(
        named(PART, f.INERTIA, first=f.FEW),
        {},
        meaning="Moments of inertia of links about their own axes, kg*m2, of one planet; that of all is reduced.",
    )
    masses: Mapping[str, Decimal] = key(
        named(PART, f.MASS, first=f.FEW), {}, meaning="Masses of planets, kg, each of one, for the reduced inertia."
    )
    load: Decimal | None = key(
        f.not_negative(units.MOMENT),
        None,
        meaning="Moment that resists the driven link, N*m: those that balance it are found.",
    )
    efficiency: Decimal | None = key(
        EFFICIENCY,
        None,
        meaning='Efficiency of each mesh, its carrier stopped: a part, or "98 %"; that of the train is found.',
        also=("eta", "η", "кпд"),
    )
    efficiencies: Mapping[tuple[str, str], Decimal] = key(
        named(MESH, EFFICIENCY, first=f.FEW), {}, meaning='Efficiencies of their own, by meshes: "2\'-3" = 0.99.'
    )
    force: Decimal | None = key(
        f.not_negative(units.FORCE), None, meaning="Force that resists the driven rack, N, in place of a moment."
    )
    output: str = key(PART, meaning="The driven link, or a rack.", missing=Missing("driven link", 'output = "H"', "1"))
    planets: int | None = key(
        one(f.whole, lambda: forms.whole(1), "number", least=1),
        None,
        meaning="Number of planets of each carrier: seen is then whether they stand clear and can be put in.",
    )

    wanted: WantedTable | None = key(
        table(WantedTable),
        None,
        meaning="Wanted ratio of a planetary train: all teeth that give it are found, and the smallest train is drawn.",
    )

    def check(self) -> None:
        """See that something turns."""
        if not any(drive.speed for drive in self.drives):
            raise wrong("zero", kind="angular speed", at=("drive",))

    @property
    def drives(self) -> tuple[DrivingLinkTable, ...]:
        """The drives."""
        return (self.drive,) if isinstance(self.drive, DrivingLinkTable) else self.drive


class CrankTable(Table):
    """Of the drive what the train needs: whether its driven link is on the crank's shaft."""

    train: bool = key(
        f.FLAG,
        False,
        meaning="Whether the driven link of [gears] is on the crank's shaft: it gives the crank its speed, and the "
        "machine its ratio and its inertia.",
    )


class GearsForm(TechniqueForm):
    """What a scene says of a gear train."""

    gears: GearsTable = key(
        table(GearsTable),
        meaning="A gear train (зубчатый механизм): ordinary, planetary, differential, a box.",
        missing=Missing("table", EXAMPLE, {}),
    )
    drive: CrankTable = key(table(CrankTable), CrankTable(), meaning="Whether the train is before the crank.")


def geared(scene: Scene) -> bool:
    """Tell whether a train is before the crank of a scene."""
    form = scene.part("gears")
    return isinstance(form, GearsForm) and form.drive.train
