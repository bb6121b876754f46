"""The survey of a scene: which link has which points, what is in doubt, and the faults found on the way."""

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from decimal import Decimal
from functools import cached_property
from math import pi
from typing import NamedTuple

from plans.linkage.reading.fields import LineTable, split_line
from plans.linkage.reading.form import LinkageForm
from plans.model.mechanism import FRAME, Mechanism, Slide
from plans.scene.faults import SHOWN, SPELLING, Fault, Path, suggestion
from plans.scene.notes import odd_lengths
from plans.scene.scene import Scene
from plans.scene.units import WORKING
from plans.words.words import Message, message

# A fault beyond this ratio: the shortest link moves the longest one by less than half the digits of a number can tell.
RATIO_LIMIT = Decimal(10_000_000)
Pair = frozenset[str]


@dataclass(eq=False, repr=False)
class LinkageSurvey:
    """A scene under examination; `doubts` are paths already at fault, of which nothing more is said."""

    scene: Scene
    doubts: set[Path] = field(default_factory=set)
    strays: set[Pair] = field(default_factory=set)  # ends of faulty lengths: perhaps a length that seems to lack
    faults: list[Fault] = field(default_factory=list)
    slides: tuple[Slide, ...] = ()  # those without fault
    mechanism: Mechanism | None = None  # what it makes, where nothing is at fault

    @cached_property
    def form(self) -> LinkageForm:
        """What the scene says of its linkage."""
        return self.scene.of(LinkageForm)

    def report(self, path: Path, kind: str, settles: Sequence[Path] = (), /, **details: object) -> None:
        """Add a fault, unless its place is in doubt already; it is all that is said of the keys that it settles."""
        if not self.doubtful(path):
            self.faults.append(replace(self.scene.fault(path, kind, **details), settles=settles))

    def doubtful(self, *paths: Path) -> bool:
        """Tell whether one of the paths, or something in it or around it, was at fault before."""
        return any(doubt[: len(path)] == path[: len(doubt)] for doubt in self.doubts for path in paths)

    @cached_property
    def points_of(self) -> dict[int, tuple[str, ...]]:
        """The points of each link: those of the frame, the letters, then those of [mechanism.points]."""
        form = self.form.mechanism
        points = {FRAME: tuple(sorted(form.frame, key=natural)), **form.links}
        for name, placed in sorted(form.points.items(), key=lambda item: natural(item[0])):
            if placed.on in form.links and name not in points[placed.on]:
                points[placed.on] = (*points[placed.on], name)
        return dict(sorted(points.items()))

    @cached_property
    def names(self) -> frozenset[str]:
        """All points; also those whose place is at fault."""
        doubted = {str(path[2]) for path in self.doubts if path[1:2] in (("frame",), ("points",)) and len(path) > 2}
        return frozenset(doubted.union(*self.points_of.values()))

    @cached_property
    def names_in_doubt(self) -> bool:
        """Whether a point may be missing only because the line that names it is at fault."""
        tables = {("mechanism",), *(("mechanism", name) for name in ("frame", "links", "points"))}
        return any(doubt in tables or doubt[:2] == ("mechanism", "links") for doubt in self.doubts)

    @cached_property
    def lengths(self) -> dict[Pair, str]:
        """The key in [mechanism.lengths] of each pair of points; faulty and second keys are left out."""
        found: dict[Pair, str] = {}
        for key in self.form.mechanism.lengths:
            path: Path = ("mechanism", "lengths", key)
            ends = split_line(key)
            pair = frozenset(ends)
            if len(ends) != 2 or len(pair) != 2:
                self.report(path, "two_letters")
                self.strays.add(pair)
            elif pair in found:
                first = found[pair]
                line, _ = self.scene.place((*path[:2], first))
                self.report(path, "twice", first=first, line=line)
            elif self.know(path, ends):
                found[pair] = key
            else:
                self.strays.add(pair)
        return found

    def may_lack(self, first: str, second: str) -> bool:
        """Tell whether a length is missing only because a line of [mechanism.lengths] is at fault."""
        if any({first, second} & stray for stray in self.strays):
            return True
        return any(
            set(split_line(str(doubt[2]))) == {first, second} if len(doubt) > 2 else True
            for doubt in self.doubts
            if doubt[:2] in (("mechanism", "lengths"), ("mechanism",))
        )

    def know(self, path: Path, names: Iterable[str]) -> bool:
        """See that all these points exist; report those that do not."""
        unknown = [name for name in names if name not in self.names]
        if not self.names_in_doubt:
            for name in unknown:
                self.report(path, "unknown_point", name=name, suggestion=self._nearest(name))
        return not unknown

    def _nearest(self, name: str) -> Message:
        if len(self.faults) > SHOWN:
            return SPELLING  # nobody reads it, and comparing a thousand names takes its time
        otherwise = message("advice.points", points=", ".join(sorted(self.names, key=natural)))
        return suggestion(name, self.names, otherwise)

    def know_link(self, path: Path, link: int) -> bool:
        """See that a moving link exists; report it if not."""
        links = self.form.mechanism.links
        if link in links:
            return True
        if not self.doubtful(("mechanism", "links")):
            self.report(path, "unknown_link", link=link, links=", ".join(map(str, sorted(links))))
        return False

    def on_link(self, path: Path, link: int, name: str) -> bool:
        """See that a point is one of a known link's points; report it if not."""
        points = self.points_of[link]
        if name in points:
            return True
        if not self.doubtful(("mechanism", "links", str(link)), ("mechanism", "points")):
            advice = suggestion(name, points, message("advice.of_link", link=link))
            self.report(path, "not_of_link", link=link, points=", ".join(points), name=name, suggestion=advice)
        return False

    def owners(self, names: Iterable[str]) -> list[int]:
        """Give the links that own all these points, in order of number."""
        wanted = set(names)
        return [link for link, points in self.points_of.items() if wanted <= set(points)]


def natural(name: str) -> tuple[str, int, str]:
    """Sort A2 before A10."""
    match = re.fullmatch(r"(\D*)(\d*)(.*)", name, re.DOTALL)
    return (match[1], int(match[2] or 0), match[3]) if match else (name, 0, "")


class Spread(NamedTuple):
    """The longest and the shortest length of a mechanism, by the names of their keys, and their ratio."""

    longest: str
    shortest: str
    ratio: Decimal


def spread(lengths: Mapping[str, Decimal]) -> Spread | None:
    """Compare the longest length with the shortest.

    >>> spread({"OA": Decimal("0.1"), "AB": Decimal(4), "CB": Decimal(2)})
    Spread(longest='AB', shortest='OA', ratio=Decimal('4E+1'))
    """
    if not lengths:
        return None
    longest, shortest = max(lengths, key=lambda key: lengths[key]), min(lengths, key=lambda key: lengths[key])
    return Spread(longest, shortest, WORKING.divide(lengths[longest], lengths[shortest]))


# Lengths in one mechanism that differ more (ratio of longest to shortest) are mostly of two units.
SPREAD = Decimal(10_000)
# Where all angles of a list are smaller than a turn in radians, they were perhaps meant so.
TURN_IN_RADIANS = Decimal("6.3")
TWELFTH, ROUNDED = pi / 12, 0.002  # an angle of the drawing board, 15 degrees, in radians, to three figures
FEW_ANGLES = 3  # a shorter list tells nothing
RADIANS = r"""["'].*\b(?:rad|рад)\s*["']"""


def notes_of(scene: Scene) -> Iterator[Fault]:
    """Give the notes on a linkage and its drive."""
    form = scene.of(LinkageForm)
    for notes in (_lengths, _angles, _spare_points, _sketch, _rest):
        yield from notes(scene, form)


def _lengths(scene: Scene, form: LinkageForm) -> Iterator[Fault]:
    lengths = form.mechanism.lengths
    stated: dict[Path, Decimal] = {("mechanism", "lengths", key): size for key, size in lengths.items()}
    yield from odd_lengths(scene, stated, lambda path: str(path[-1]))
    if (apart := spread(lengths)) and apart.ratio > SPREAD:
        path = ("mechanism", "lengths", apart.longest)
        yield scene.fault(path, "spread", name=apart.longest, other=apart.shortest, ratio=f"{apart.ratio:.3g}")


def _angles(scene: Scene, form: LinkageForm) -> Iterator[Fault]:
    drive = form.drive
    start = drive.first
    if start is not None and abs(start) > 360:
        note = scene.fault(("drive", "start"), "degrees", turns=f"{start / 360:.3g}")
        if re.fullmatch(RADIANS, note.value):
            yield note
    for path, angle in _single(form):
        share = round(float(angle) / TWELFTH)
        if share and abs(angle) < TURN_IN_RADIANS and abs(float(angle) - share * TWELFTH) < ROUNDED:
            yield scene.fault(path, "radian", example=f"{angle:f}", degrees=15 * share)
    if not isinstance(drive.positions, tuple):
        return
    whole = all(angle == angle.to_integral_value() for angle in drive.positions)
    small = all(abs(angle) < TURN_IN_RADIANS for angle in drive.positions)
    if small and not whole and len(drive.positions) >= FEW_ANGLES:
        example = next(angle for angle in drive.positions if angle)
        yield scene.fault(("drive", "positions"), "radians", most=TURN_IN_RADIANS, example=f"{example:f}")


def _single(form: LinkageForm) -> Iterator[tuple[Path, Decimal]]:
    """Give the angles that stand alone, as bare numbers or not."""
    if isinstance(form.drive.start, Decimal):
        yield ("drive", "start"), form.drive.start
    for index, slide in enumerate(form.mechanism.slides):
        path: Path = ("mechanism", "slides", index)
        yield (*path, "angle"), slide.angle
        if isinstance(slide.along, LineTable):
            yield (*path, "along", "angle"), slide.along.angle


def _spare_points(scene: Scene, form: LinkageForm) -> Iterator[Fault]:
    used = {name for points in form.mechanism.links.values() for name in points}
    for slide in form.mechanism.slides:
        used.update(filter(None, [slide.along.letter]) if isinstance(slide.along, LineTable) else slide.along)
    for key in form.mechanism.lengths:
        used.update(split_line(key))
    used.update((form.drive.stroke and form.drive.stroke.between) or ())  # the foot of a cylinder
    used.update(*(other.borrowed() for other in scene.forms))
    for name in form.mechanism.frame:
        if name not in used:
            yield scene.fault(("mechanism", "frame", name), "spare_point", name=name)


def _sketch(scene: Scene, form: LinkageForm) -> Iterator[Fault]:
    """Find fixed points that the sketch shows in another place."""
    for name, place in form.mechanism.sketch.items():
        if form.mechanism.frame.get(name, place) != place:
            yield scene.fault(("mechanism", "sketch", name), "fixed_sketch", name=name)


def _rest(scene: Scene, form: LinkageForm) -> Iterator[Fault]:
    stroke, drive = form.drive.stroke, form.drive
    if not any(stroke.rates if stroke else (drive.speed, drive.acceleration)):
        still: Path = ("drive", "stroke", "speed") if stroke else ("drive", "speed")
        yield scene.fault(still, "stroke_at_rest" if stroke else "at_rest")
