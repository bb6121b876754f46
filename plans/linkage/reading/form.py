"""The form of a linkage: what a scene says of a mechanism, its drive, its output and its sheet (исходные данные)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from decimal import Decimal
from typing import Any

from geometry.errors import LimitError
from plans.linkage.reading import fields as g
from plans.linkage.reading.fields import LineTable, Place, StrokeTable
from plans.model.mechanism import PARTINGS, SLOWER, STROKES, THROUGH
from plans.scene import fields as f
from plans.scene.faults import Path, Wrong, wrong
from plans.scene.forms import Form
from plans.scene.readers import either, many, named
from plans.scene.scene import Scene, TechniqueForm
from plans.scene.tables import Missing, Table, key, table
from plans.words.words import message, placed

# Links times positions of one run. Their numbers and the text of them take 1.0 to 1.6 kB each: a run stays under 2 GB.
LINK_POSITIONS_LIMIT = 1_000_000


def check_capacity(links: int, positions: int, limit: int, name: str) -> None:
    """See that the numbers of some links in some positions have room within a limit, which has a name."""
    if links * positions > limit:
        counts = {"links": links, "positions": positions, "name": name, "limit": limit, "most": limit // links}
        raise LimitError(placed(f"drive.positions = {positions}", message("limit.link_positions", **counts)))


class SlideTable(Table):
    """A sliding pair (поступательная пара): a link and the line it slides along."""

    link: int = key(g.MOVING_LINK, meaning="The sliding link.", missing=Missing("number of a moving link", "link = 2"))
    along: tuple[str, ...] | LineTable = key(
        either(dict, table(LineTable), g.LINE),
        meaning='The line it slides along: two letters of another link, "CB", or a line by a point and its angle.',
        missing=Missing("line", 'along = "CB", or along = { through = [0, 0], angle = 0 }'),
    )
    point: str | None = key(f.POINT, None, meaning="Point of the link on that line; default: its first.")
    offset: Decimal = key(f.COORDINATE, Decimal(0), meaning="Distance of that point to the left of the line.")
    angle: Decimal = key(f.ANGLE, Decimal(0), meaning="Angle of the link's own +x axis to the line, counter-clockwise.")


class PointTable(Table):
    """A point of a link by its place in the link's own frame."""

    on: int = key(g.ANY_LINK, meaning="The link.", missing=Missing("number of a moving link", "on = 2"))
    at: Place = key(
        f.PLACE,
        meaning="Place in the link's own frame.",
        missing=Missing("place in the link's own frame", "at = [0.1, 0]"),
    )


class MechanismTable(Table):
    """Frame, links, lengths, points, slides and sketch, as the scene gives them."""

    frame: Mapping[str, Place] = key(
        named(f.POINT, f.PLACE, f.NOT_EMPTY, first=f.FEW),
        meaning="Fixed points (стойка): O = [0, 0].",
        missing=Missing("table of fixed points", "[mechanism.frame] with O = [0, 0]", {"O": [0, 0]}),
    )
    links: Mapping[int, tuple[str, ...]] = key(
        named(g.LINK_NUMBER, g.LETTERS, f.NOT_EMPTY, first=g.FEW_LINKS),
        meaning='Moving links (звенья), each with the letters of its points, 1 = "OA": capitals with an optional '
        'number or prime, A, B1, O\'; longer names as a list, 1 = ["crank", "pin"]. The first point is the origin of '
        "the link's own frame, the second lies on its +x.",
        missing=Missing("table of links", '[mechanism.links] with 1 = "OA"', {"1": "OA"}),
    )
    lengths: Mapping[str, Decimal] = key(
        named(g.LENGTH_NAME, f.LENGTH, first=f.FEW),
        {},
        meaning='Lengths: OA = 0.110 or "110 mm"; a third point of a link by its lengths to the first two, on the side '
        "that the sketch shows.",
    )
    points: Mapping[str, PointTable] = key(
        named(f.POINT, table(PointTable), first=f.FEW),
        {},
        meaning="Points by their place in a link's own frame: E = { on = 2, at = [0.2, 0.09] }.",
    )
    slides: tuple[SlideTable, ...] = key(
        many(table(SlideTable), first=f.FEW), (), meaning="Sliding pairs (поступательные пары)."
    )
    sketch: Mapping[str, Place] = key(
        named(f.POINT, f.PLACE, first=f.FEW),
        {},
        meaning='Rough places at the first position (with start = "extreme", at any): they choose the assembly. One '
        "point of each group with two assemblies; the crank's end and blocks are found; where a third point has its "
        "place by lengths, all three points.",
    )
    through: str | None = key(
        f.words(*THROUGH),
        None,
        meaning="What carries the linkage through its change points, so that it goes on smoothly: another linkage "
        "beside it, or its own inertia; default: nothing, a change point bars the crank, and what lies beyond is a "
        "gap.",
    )


class DriveTable(Table):
    """The drive (начальное звено): crank, angular velocity and acceleration, and its positions; or a stroke."""

    link: int = key(
        g.MOVING_LINK,
        meaning="The crank (кривошип), or with a stroke the link that slides.",
        missing=Missing("number of the crank", "link = 1", 1),
    )
    speed: Decimal | None = key(
        f.ANGULAR_SPEED,
        None,
        meaning='Angular speed of the crank, also as "60 rpm"; negative is clockwise. A stroke has a speed of its own.',
        missing=Missing("angular speed", 'speed = "60 rpm"', 1),
    )
    acceleration: Decimal = key(f.ANGULAR_ACCELERATION, Decimal(0), meaning="Angular acceleration.")
    start: Decimal | str = key(
        g.START,
        Decimal(0),
        meaning='First crank angle from +x, or "extreme": the position from which the output\'s working stroke begins.',
    )
    positions: int | tuple[Decimal, ...] = key(
        g.POSITIONS,
        12,
        meaning="Number of equal steps over a turn in the sense of rotation, or over the stroke, or a list of crank "
        "angles (then no start); links times positions are at most 1,000,000, with a force sheet 500,000.",
    )

    stroke: StrokeTable | None = key(
        table(StrokeTable), None, meaning="The stroke of a primary link that slides on the frame: a ram, a plunger."
    )

    @property
    def omega(self) -> Decimal:
        """Angular speed of the crank, rad/s; none of a link that slides."""
        return self.speed or Decimal(0)

    @property
    def count(self) -> int:
        """Number of positions: a stroke has one at either end of each step."""
        if isinstance(self.positions, int):
            return self.positions + (self.stroke is not None)
        return len(self.positions)

    @property
    def first(self) -> Decimal | None:
        """First crank angle in degrees, or nothing where it is an extreme position yet to be found."""
        if isinstance(self.positions, tuple):
            return self.positions[0]
        return self.start if isinstance(self.start, Decimal) else None

    def check(self) -> None:
        """See that a list of positions stands alone, and a stroke without what belongs to a crank."""
        if self.stroke is not None:
            alone = {"speed": "stroke_alone", "acceleration": "stroke_alone", "start": "turn_alone"}
            if isinstance(self.positions, tuple):
                raise wrong("stroke_with_list", at=("positions",))
            for name in alone.keys() & self.given:
                raise wrong(alone[name], name=name, at=(name,))
        elif isinstance(self.positions, tuple) and "start" in self.given:
            raise wrong("start_with_list", at=("start",))

    @classmethod
    def misfits(cls, value: Mapping[str, Any]) -> Iterator[Wrong]:
        """Give the speed that a crank lacks: one behind a gear train has that of its shaft."""
        if not {"speed", "stroke"} & value.keys() and value.get("train") is not True:
            yield wrong("missing", at=("speed",))

    @classmethod
    def rules(cls) -> Form:
        """Say that a list of positions stands alone, and that a speed or a stroke is needed."""
        lone: Form = {"not": {"required": ["start", "positions"], "properties": {"positions": {"type": "array"}}}}
        geared: Form = {"required": ["train"], "properties": {"train": {"const": True}}}
        return lone | {"oneOf": [{"anyOf": [{"required": ["speed"]}, geared]}, {"required": ["stroke"]}]}


class OutputTable(Table):
    """The output link (выходное звено), by its number or by a point of it, and which of its strokes works."""

    link: int | None = key(g.MOVING_LINK, None, meaning="The output link.")
    point: str | None = key(
        f.POINT, None, meaning="A point of the output link.", missing=Missing("point of the link", 'point = "B"')
    )
    along: Decimal | None = key(
        f.ANGLE,
        None,
        meaning="The direction in which the way S of that point counts, where no guide gives it (направление отсчёта "
        "пути точки): its angle from +x; default: of a link without a guide its turn counts.",
    )
    working: str = key(
        f.words(*(name for name in STROKES if name not in PARTINGS)),
        SLOWER,
        meaning="Its working stroke (рабочий ход): by the time that it takes, by the way of its point or slider, or "
        "by the turn of its link.",
    )

    def check(self) -> None:
        """See that the output is named once, or its working stroke alone, and of what a direction is."""
        if self.along is not None and self.point is None:
            raise wrong("missing", at=("point",))
        both = self.link is not None and self.point is not None
        if both or self.given.isdisjoint(self.keys):
            raise wrong("one_of_two", first="link", second="point", found="both" if both else "none")

    @classmethod
    def rules(cls) -> Form:
        """Say that the output is named once, or its working stroke alone, and of what a direction is."""
        either: Form = {"not": {"required": ["link", "point"]}, "anyOf": [{"required": [name]} for name in cls.keys]}
        return either | {"dependentRequired": {"along": ["point"]}}


class PlansTable(Table):
    """Of the sheet what shows a linkage: the positions whose plans are drawn, and the one in full lines."""

    plans: tuple[int, ...] = key(
        many(f.POSITION, f.NO_REPEATS, first=f.FEW),
        (),
        meaning="Positions whose plans are drawn; default: one of the working stroke and one more, both "
        "open figures; beside force sheets the positions of these first.",
    )
    position: int | None = key(f.POSITION, None, meaning="In full lines; default: of plans or forces, or the fastest.")


class ChosenTable(Table):
    """Of a technique that shows a linkage in single positions: which of them."""

    positions: tuple[int, ...] = key(
        many(f.POSITION, f.NO_REPEATS, first=f.FEW),
        (),
        meaning="Positions that are drawn; default: those of sheet.plans, or one.",
    )


class LinkageForm(TechniqueForm):
    """What a scene says of a linkage."""

    mechanism: MechanismTable = key(
        table(MechanismTable),
        meaning="The linkage: frame, links, lengths, slides and a rough sketch.",
        missing=Missing("table", "[mechanism.frame], [mechanism.links], [mechanism.lengths]", {}),
    )
    drive: DriveTable = key(
        table(DriveTable),
        meaning="The drive (начальное звено): crank, speed and positions.",
        missing=Missing("table", '[drive] with link = 1 and speed = "60 rpm"', {}),
    )
    output: OutputTable | None = key(
        table(OutputTable),
        None,
        meaning="The output link (выходное звено); default: the last link on the frame of the last group.",
    )
    sheet: PlansTable = key(table(PlansTable), PlansTable(), meaning="What of a linkage is shown.")

    def fit(self, scene: Scene) -> None:
        """See that a run has room for its positions."""
        check_capacity(len(self.mechanism.links), self.drive.count, LINK_POSITIONS_LIMIT, "LINK_POSITIONS_LIMIT")

    @classmethod
    def home_of(cls, name: str) -> Path:
        """Give the table that two letters or one may be meant for: lengths, or fixed points."""
        tables = {1: ("mechanism", "frame"), 2: ("mechanism", "lengths")}
        return tables.get(len(g.split_letters(name)), ())
