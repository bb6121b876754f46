"""The scene (исходные данные): one TOML file as a frozen value; every fault names file, line, key and advice."""

from __future__ import annotations

from collections.abc import Mapping
from decimal import Decimal
from functools import partial
from pathlib import Path as FilePath

from geometry.errors import LimitError
from plans.model.machine import COUPLING, FORCE, MOMENT
from plans.model.mechanism import THROUGH
from plans.scene import fields as f
from plans.scene.capacity import check_capacity
from plans.scene.faults import Fault, Path, SceneError, wrong
from plans.scene.loads import (
    MASSES,
    DiagramTable,
    EndTable,
    ForceTable,
    FrictionTable,
    GearTable,
    LoadsTable,
    MassTable,
    MomentTable,
    PairTable,
    SpringTable,
)
from plans.scene.refusal import REFUSALS_LIMIT, doubts_of, refusals, spare
from plans.scene.source import Source, parse_source, read_source
from plans.scene.tables import Refused, Table, either, key, many, named, one, read, table
from plans.words.words import ENGLISH, languages, placed

KINEMATICS, FORCES = "kinematics", "forces"
SHEETS = (KINEMATICS, FORCES)  # what this version draws
BALANCINGS = (MOMENT, COUPLING, FORCE)
Place = tuple[Decimal, Decimal]


class FrameLine(Table):
    """A line of the frame by a point and its angle from +x, degrees."""

    through: Place = key(f.PLACE)
    angle: Decimal = key(f.ANGLE, Decimal(0))


class SlideTable(Table):
    """A sliding pair (поступательная пара): a link and the line it slides along."""

    link: int = key(f.MOVING_LINK)
    along: tuple[str, ...] | FrameLine = key(either(dict, table(FrameLine), f.LINE))
    point: str | None = key(f.POINT, None)  # default: the link's first point
    offset: Decimal = key(f.COORDINATE, Decimal(0))  # m, of the point to the left of the line
    angle: Decimal = key(f.ANGLE, Decimal(0))  # of the link's +x axis to the line


class PointTable(Table):
    """A point of a link by its place in the link's own frame."""

    on: int = key(f.ANY_LINK)
    at: Place = key(f.PLACE)


class MechanismTable(Table):
    """Frame, links, lengths, points, slides and sketch, as the scene gives them."""

    frame: Mapping[str, Place] = key(named(f.POINT, f.PLACE, f.not_empty, first=f.FEW))
    links: Mapping[int, tuple[str, ...]] = key(named(f.LINK_NUMBER, f.LETTERS, f.not_empty, first=f.FEW_LINKS))
    lengths: Mapping[str, Decimal] = key(named(f.ANY, f.LENGTH, first=f.FEW), {})
    points: Mapping[str, PointTable] = key(named(f.POINT, table(PointTable), first=f.FEW), {})
    slides: tuple[SlideTable, ...] = key(many(table(SlideTable), first=f.FEW), ())
    sketch: Mapping[str, Place] = key(named(f.POINT, f.PLACE, first=f.FEW), {})
    through: str | None = key(one(f.choice, choices=THROUGH), None)  # what carries it through change points


class DriveTable(Table):
    """The drive (начальное звено): crank, angular velocity and acceleration, and its positions."""

    link: int = key(f.MOVING_LINK)
    speed: Decimal = key(f.ANGULAR_SPEED)
    acceleration: Decimal = key(f.ANGULAR_ACCELERATION, Decimal(0))
    start: Decimal | str = key(f.START, Decimal(0))
    positions: int | tuple[Decimal, ...] = key(f.POSITIONS, 12)
    # What balances the crank: a moment, a coupling, or a force at its end; a gear is a kind of its own.
    balancing: str = key(one(f.choice, choices=BALANCINGS), MOMENT)
    gear: GearTable | None = key(table(GearTable), None)

    @property
    def count(self) -> int:
        """Number of positions."""
        return self.positions if isinstance(self.positions, int) else len(self.positions)

    @property
    def first(self) -> Decimal | None:
        """First crank angle in degrees, or nothing where it is an extreme position yet to be found."""
        if isinstance(self.positions, tuple):
            return self.positions[0]
        return self.start if isinstance(self.start, Decimal) else None

    def check(self) -> None:
        """See that a list of positions stands alone, and that the crank is driven in one way."""
        if isinstance(self.positions, tuple) and "start" in self.given:
            raise wrong("start_with_list", at=("start",))
        if self.gear is not None and "balancing" in self.given:
            raise wrong("one_of_two", first="balancing", second="gear", found="both", at=("balancing",))


class OutputTable(Table):
    """The output link (выходное звено), by its number or by a point of it."""

    link: int | None = key(f.MOVING_LINK, None)
    point: str | None = key(f.POINT, None)

    def check(self) -> None:
        """See that the output is named once."""
        if (self.link is None) == (self.point is None):
            found = "none" if self.link is None else "both"
            raise wrong("one_of_two", first="link", second="point", found=found)


LANGUAGES, STANDARDS = languages(), ("GOST", "ISO")
FORMATS, ORIENTATIONS = ("A1", "A2", "A3", "A4"), ("landscape", "portrait")
LETTERINGS, NOTATIONS, REACTIONS = ("strokes", "text"), ("mu", "K"), ("R", "P", "F")


class SheetTable(Table):
    """What stands on the sheet: language, standard, format, the positions drawn in full, and the title block."""

    language: str = key(one(f.choice, choices=LANGUAGES), ENGLISH)
    standard: str = key(one(f.choice, choices=STANDARDS), "GOST")
    format: str = key(one(f.choice, choices=FORMATS), "A1")
    # Default: landscape, and portrait for A4.
    orientation: str | None = key(one(f.choice, choices=ORIENTATIONS), None)
    lettering: str = key(one(f.choice, choices=LETTERINGS), "strokes")
    # Scale factors mu in true units a millimetre, or K = 1/mu in millimetres a true unit.
    notation: str = key(one(f.choice, choices=NOTATIONS), "mu")
    # Positions whose velocity and acceleration plans are drawn.
    plans: tuple[int, ...] = key(many(f.POSITION_NUMBER, f.no_repeats, first=f.FEW), ())
    position: int | None = key(f.POSITION_NUMBER, None)  # the position drawn in full lines
    # Positions of the force sheets, one sheet each; none given: that in full lines.
    forces: tuple[int, ...] = key(many(f.POSITION_NUMBER, f.no_repeats, first=f.FEW), ())
    reactions: str = key(one(f.choice, choices=REACTIONS), "R")  # the letter of reactions
    hodographs: tuple[str, ...] = key(many(f.PAIR, f.no_repeats, first=f.FEW), ())  # pairs whose hodograph is drawn
    designation: str = key(f.TEXT, "")
    drawn: str = key(f.TEXT, "")
    checked: str = key(f.TEXT, "")
    approved: str = key(f.TEXT, "")
    date: str = key(f.TEXT, "")
    group: str = key(f.TEXT, "")
    organisation: str = key(f.TEXT, "")


class Scene(Table):
    """What the user asked for: a mechanism, its drive, its loads and friction, and the sheets wanted."""

    title: str = key(f.TEXT, "Mechanism")
    sheets: tuple[str, ...] = key(
        many(one(f.choice, choices=SHEETS, kind="sheet_name"), f.not_empty, f.no_repeats, first=f.FEW), (KINEMATICS,)
    )
    mechanism: MechanismTable = key(table(MechanismTable))
    drive: DriveTable = key(table(DriveTable))
    output: OutputTable | None = key(table(OutputTable), None)
    masses: Mapping[int, MassTable] = key(MASSES, {})
    loads: LoadsTable | None = key(table(LoadsTable), None)
    friction: FrictionTable | None = key(table(FrictionTable), None)
    sheet: SheetTable = key(table(SheetTable), SheetTable())
    _source: Source

    @property
    def file(self) -> str:
        """The name of the file."""
        return self._source.file

    @property
    def content(self) -> bytes:
        """The bytes of the file."""
        return self._source.content

    @property
    def marked(self) -> bool:
        """Whether the file began with a byte order mark, which was left aside."""
        return self._source.marked

    def place(self, path: Path) -> tuple[int, int]:
        """Give line and column of a key."""
        return self._source.place(path)

    def fault(self, path: Path, kind: str, /, **details: object) -> Fault:
        """Make a fault at a key of this scene."""
        return self._source.fault(path, kind, **details)


# The tables of the form, "*" standing for any key or number in a list; the commonest first.
TABLES: Mapping[Path, type[Table]] = {
    (): Scene,
    ("mechanism",): MechanismTable,
    ("drive",): DriveTable,
    ("mechanism", "slides", "*"): SlideTable,
    ("mechanism", "slides", "*", "along"): FrameLine,
    ("mechanism", "points", "*"): PointTable,
    ("output",): OutputTable,
    ("sheet",): SheetTable,
    ("masses", "*"): MassTable,
    ("loads",): LoadsTable,
    ("loads", "forces", "*"): ForceTable,
    ("loads", "forces", "*", "diagram"): DiagramTable,
    ("loads", "moments", "*"): MomentTable,
    ("loads", "springs", "*"): SpringTable,
    ("loads", "springs", "*", "between", "*"): EndTable,
    ("friction",): FrictionTable,
    ("friction", "pairs", "*"): PairTable,
    ("drive", "gear"): GearTable,
}


def read_scene(path: FilePath) -> Scene:
    """Read a scene file; all its faults together are one SceneError."""
    return _scene(read_source(path))


def parse_scene(text: str, file: str = "scene.toml") -> Scene:
    """Read a scene from its text; `file` is the name that faults give."""
    return _scene(parse_source(text, file))


def _scene(source: Source) -> Scene:
    try:
        return _bounded(_with_source(read(Scene, source.tables), source))
    except Refused as error:
        faults = refusals(error, source, TABLES)
        unlisted = max(0, len(error.refusals) - REFUSALS_LIMIT)
        meaning = [] if unlisted else _further_faults(source, faults)
        raise SceneError([*faults, *meaning], unlisted) from None
    except LimitError as error:
        raise LimitError(placed(source.file, error.args[0])) from None


def _bounded(scene: Scene) -> Scene:
    check_capacity(len(scene.mechanism.links), scene.drive.count, FORCES in scene.sheets)
    return scene


def _with_source(scene: Scene, source: Source) -> Scene:
    vars(scene)["_source"] = source
    return scene


def _further_faults(source: Source, faults: list[Fault]) -> list[Fault]:
    """Examine the meaning of what the form does take, so that one reading tells all."""
    from plans.scene.linkage import faults_of  # noqa: PLC0415  (the linkage is made from scenes; only here the other way)

    rest = spare(source, partial(read, Scene))
    return faults_of(_with_source(rest, source), doubts_of(faults)) if rest else []
