"""The scene (исходные данные): one TOML file as a frozen value; every fault names file, line, key and advice."""

from __future__ import annotations

from collections.abc import Mapping
from decimal import Decimal
from pathlib import Path as FilePath
from typing import Annotated, Literal

from pydantic import (
    AfterValidator,
    BaseModel,
    BeforeValidator,
    ConfigDict,
    Field,
    PrivateAttr,
    ValidationError,
    model_validator,
)

from geometry.errors import LimitError
from plans import fields as f
from plans.faults import Fault, Path, SceneError, wrong
from plans.refusal import REFUSALS_LIMIT, doubts_of, refusals, spare
from plans.source import Source, parse_source, read_source

SHEETS = ("kinematics",)  # what this version draws
DURING = ("always", "working stroke", "idle stroke")


class Table(BaseModel):
    """A table of the scene: frozen, and closed against unknown keys."""

    model_config = ConfigDict(extra="forbid", frozen=True, hide_input_in_errors=True)


class FrameLine(Table):
    """A line of the frame by a point and its angle from +x, degrees."""

    through: f.Place
    angle: f.Angle = Decimal(0)


class SlideTable(Table):
    """A sliding pair (поступательная пара): a link and the line it slides along."""

    link: f.MovingLink
    along: Annotated[
        Annotated[tuple[str, ...], f.one_fault(f.check_line), f.ONE] | Annotated[FrameLine, f.TABLE], f.BY_TABLE
    ]
    point: f.Name | None = None  # default: the link's first point
    offset: f.Coordinate = Decimal(0)  # m, of the point to the left of the line
    angle: f.Angle = Decimal(0)  # of the link's +x axis to the line


class PointTable(Table):
    """A point of a link by its place in the link's own frame."""

    on: f.AnyLink
    at: f.Place


class MechanismTable(Table):
    """Frame, links, lengths, points, slides and sketch, as the scene gives them."""

    frame: Annotated[Mapping[f.Name, f.Place], AfterValidator(f.not_empty), f.FEW]
    links: Annotated[Mapping[f.LinkNumber, f.Letters], AfterValidator(f.not_empty), f.FEW_LINKS]
    lengths: Annotated[Mapping[str, f.Length], f.FEW] = Field(default_factory=dict)
    points: Annotated[Mapping[f.Name, PointTable], f.FEW] = Field(default_factory=dict)
    slides: Annotated[tuple[SlideTable, ...], f.FEW] = ()
    sketch: Annotated[Mapping[f.Name, f.Place], f.FEW] = Field(default_factory=dict)


class GearTable(Table):
    """The gear by which the machine is driven: pitch radius, place of the pinion, pressure angle."""

    radius: f.Length
    at: f.Angle
    pressure_angle: f.Angle = Decimal(20)


class DriveTable(Table):
    """The drive (начальное звено): crank, angular velocity and acceleration, and its positions."""

    link: f.MovingLink
    speed: f.AngularSpeed
    acceleration: f.AngularAcceleration = Decimal(0)
    start: f.Start = Decimal(0)
    positions: Annotated[
        Annotated[int, f.one_fault(f.count_positions), f.ONE]
        | Annotated[tuple[f.Angle, ...], AfterValidator(f.position_list), f.LIST],
        f.BY_LIST,
    ] = 12
    gear: GearTable | None = None

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

    @model_validator(mode="after")
    def _one_start(self) -> DriveTable:
        if isinstance(self.positions, tuple) and "start" in self.model_fields_set:
            raise wrong("start_with_list", at=("start",))
        return self


class OutputTable(Table):
    """The output link (выходное звено), by its number or by a point of it."""

    link: f.MovingLink | None = None
    point: f.Name | None = None

    @model_validator(mode="after")
    def _one(self) -> OutputTable:
        if (self.link is None) == (self.point is None):
            found = "none" if self.link is None else "both"
            raise wrong("one_of_two", first="link", second="point", found=found)
        return self


class MassTable(Table):
    """Mass kg, moment of inertia about the mass centre kg*m2, and the centre in the link's own frame."""

    mass: f.Mass
    inertia: f.Inertia = Decimal(0)
    centre: Annotated[
        Annotated[Literal["middle"], f.one_fault(f.choice, choices=("middle",)), f.ONE] | Annotated[f.Place, f.LIST],
        f.BY_LIST,
    ] = Field(default=(Decimal(0), Decimal(0)))


class DiagramTable(Table):
    """A load over the working stroke: shares of the stroke, and the force N at each."""

    travel: Annotated[tuple[f.Number, ...], f.FEW]
    force: Annotated[tuple[f.Force, ...], f.FEW]

    @model_validator(mode="after")
    def _fits(self) -> DiagramTable:
        rises = all(low <= high for low, high in zip(self.travel, self.travel[1:], strict=False))
        whole = len(self.travel) > 1 and self.travel[0] == 0 and self.travel[-1] == 1
        if not (rises and whole and len(self.travel) == len(self.force)):
            raise wrong("diagram")
        return self


class ForceTable(Table):
    """A force on a point of a link: a vector N, or a size against the motion, or a diagram of sizes."""

    on: f.MovingLink
    point: f.Name
    value: (
        Annotated[
            Annotated[f.Force, f.ONE] | Annotated[tuple[f.Force, f.Force], BeforeValidator(f.check_pair), f.LIST],
            f.BY_LIST,
        ]
        | None
    ) = None
    against: Annotated[Literal["motion"], f.one_fault(f.choice, choices=("motion",))] | None = None
    during: Annotated[str, f.one_fault(f.choice, choices=DURING)] = "always"
    diagram: DiagramTable | None = None

    @model_validator(mode="after")
    def _one_form(self) -> ForceTable:
        if (self.value is None) == (self.diagram is None):
            found = "none" if self.value is None else "both"
            raise wrong("one_of_two", first="value", second="diagram", found=found)
        if self.against is None and not isinstance(self.value, tuple):
            wanted, advice = "a vector [Fx, Fy] in N", 'write value = [Fx, Fy], or add against = "motion"'
            raise wrong("force_value", wanted=wanted, advice=advice, at=("diagram" if self.diagram else "value",))
        if self.against is not None and isinstance(self.value, tuple):
            wanted = "the size of the force, because its direction is against the motion"
            raise wrong("force_value", wanted=wanted, advice="write value = 1500, for example", at=("value",))
        return self


class MomentTable(Table):
    """A moment on a link, N*m, positive counter-clockwise."""

    on: f.MovingLink
    value: f.Moment
    during: Annotated[str, f.one_fault(f.choice, choices=DURING)] = "always"


class LoadsTable(Table):
    """Gravity, forces and moments; gravity as a number is downward."""

    gravity: (
        Annotated[
            Annotated[f.Gravity, f.ONE] | Annotated[tuple[f.Gravity, f.Gravity], BeforeValidator(f.check_pair), f.LIST],
            f.BY_LIST,
        ]
        | None
    ) = None
    forces: Annotated[tuple[ForceTable, ...], f.FEW] = ()
    moments: Annotated[tuple[MomentTable, ...], f.FEW] = ()


LANGUAGES, STANDARDS = ("en", "ru"), ("GOST", "ISO")
FORMATS, ORIENTATIONS = ("A1", "A2", "A3", "A4"), ("landscape", "portrait")
LETTERINGS, NOTATIONS = ("strokes", "text"), ("mu", "K")


class SheetTable(Table):
    """What stands on the sheet: language, standard, format, the positions drawn in full, and the title block."""

    language: Annotated[Literal["en", "ru"], f.one_fault(f.choice, choices=LANGUAGES)] = "en"
    standard: Annotated[Literal["GOST", "ISO"], f.one_fault(f.choice, choices=STANDARDS)] = "GOST"
    format: Annotated[Literal["A1", "A2", "A3", "A4"], f.one_fault(f.choice, choices=FORMATS)] = "A1"
    # Default: landscape, and portrait for A4.
    orientation: Annotated[Literal["landscape", "portrait"], f.one_fault(f.choice, choices=ORIENTATIONS)] | None = None
    lettering: Annotated[Literal["strokes", "text"], f.one_fault(f.choice, choices=LETTERINGS)] = "strokes"
    # Scale factors mu in true units a millimetre, or K = 1/mu in millimetres a true unit.
    notation: Annotated[Literal["mu", "K"], f.one_fault(f.choice, choices=NOTATIONS)] = "mu"
    # Positions whose velocity and acceleration plans are drawn.
    plans: Annotated[tuple[f.PositionNumber, ...], AfterValidator(f.no_repeats), f.FEW] = ()
    position: f.PositionNumber | None = None  # the position drawn in full lines
    designation: f.Text = ""
    drawn: f.Text = ""
    checked: f.Text = ""
    approved: f.Text = ""
    date: f.Text = ""
    group: f.Text = ""
    organisation: f.Text = ""


class Scene(Table):
    """What the user asked for: a mechanism, its drive, its loads, and the sheets wanted."""

    title: f.Text = "Mechanism"
    sheets: Annotated[
        tuple[Annotated[str, f.one_fault(f.choice, choices=SHEETS, kind="sheet_name")], ...],
        AfterValidator(f.not_empty),
        AfterValidator(f.no_repeats),
        f.FEW,
    ] = SHEETS
    mechanism: MechanismTable
    drive: DriveTable
    output: OutputTable | None = None
    masses: Annotated[Mapping[f.LinkNumber, MassTable], f.FEW_LINKS] = Field(default_factory=dict)
    loads: LoadsTable | None = None
    sheet: SheetTable = Field(default_factory=SheetTable)
    _source: Source = PrivateAttr()

    @property
    def file(self) -> str:
        """The name of the file."""
        return self._source.file

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
TABLES: Mapping[Path, type[BaseModel]] = {
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
        return _with_source(Scene.model_validate(source.tables), source)
    except ValidationError as error:
        faults = refusals(error, source, TABLES)
        unlisted = max(0, error.error_count() - REFUSALS_LIMIT)
        meaning = [] if unlisted else _further_faults(source, faults)
        raise SceneError([*faults, *meaning], unlisted) from None
    except LimitError as error:
        raise LimitError(f"{source.file}: {error}") from None


def _with_source(scene: Scene, source: Source) -> Scene:
    scene._source = source
    return scene


def _further_faults(source: Source, faults: list[Fault]) -> list[Fault]:
    """Examine the meaning of what the form does take, so that one reading tells all."""
    from plans.linkage import faults_of  # noqa: PLC0415  (the linkage is made from scenes; only here the other way)

    rest = spare(source, Scene.model_validate)
    return faults_of(_with_source(rest, source), doubts_of(faults)) if rest else []
