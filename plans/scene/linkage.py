"""The linkage of a scene: the scene's tables made into a Mechanism, with every fault that its meaning shows."""

from __future__ import annotations

import cmath
from collections.abc import Mapping
from dataclasses import dataclass
from decimal import Decimal
from math import pi

from plans.model.mechanism import FRAME, Drive, Link, Mechanism, Output, Slide, StructureError, Way
from plans.scene.faults import Fault, Path, SceneError, suggestion
from plans.scene.fields import split_line
from plans.scene.joining import check_joining
from plans.scene.references import check_references
from plans.scene.scene import FrameLine, Scene, SlideTable
from plans.scene.shapes import Shaper, Spot, as_complex, line_name
from plans.scene.survey import RATIO_LIMIT, Survey, natural, spread
from plans.scene.units import EXACT
from plans.words.words import Message, message

ORIGIN: Spot = (Decimal(0), Decimal(0))
# Directions of whole right angles have exact unit numbers.
RIGHT_ANGLES: Mapping[Decimal, complex] = {
    Decimal(0): 1 + 0j,
    Decimal(90): 1j,
    Decimal(180): -1 + 0j,
    Decimal(270): -1j,
}


def mechanism_of(scene: Scene) -> Mechanism:
    """Make the mechanism of a scene; all its faults together are one SceneError, a wrong mobility a StructureError."""
    survey = Survey(scene)
    mechanism = _build(survey)
    if survey.faults or mechanism is None:
        raise SceneError(survey.faults)
    if mechanism.mobility != 1:
        raise _wrong_mobility(scene, mechanism)
    return mechanism


def faults_of(scene: Scene, doubts: frozenset[Path]) -> list[Fault]:
    """Give the faults in the meaning of a scene of which some tables are at fault already, without what follows."""
    survey = Survey(scene, set(doubts))
    _build(survey)
    return survey.faults


def direction(angle: Decimal) -> complex:
    """Give the unit vector at an angle in degrees; whole right angles exactly.

    >>> direction(Decimal(450)), direction(Decimal(-180))
    (1j, (-1+0j))
    """
    turn = EXACT.remainder(angle, Decimal(360))
    turn = EXACT.add(turn, Decimal(360)) if turn < 0 else turn
    return RIGHT_ANGLES[turn] if turn in RIGHT_ANGLES else cmath.rect(1.0, float(turn) * pi / 180)


def _build(survey: Survey) -> Mechanism | None:
    scene = survey.scene
    ends = _drive_ends(survey)
    frame = scene.mechanism.frame
    datum = frame.get(ends[0], ORIGIN) if ends else ORIGIN
    fixed = {name: _from_datum(frame[name], datum) for name in survey.points_of[FRAME]}
    sketch = _sketch(survey, datum)
    places = {**sketch, **{name: as_complex(spot) for name, spot in fixed.items()}}
    shaper = Shaper(survey, _with_crank(survey, ends, places))
    shapes = {FRAME: fixed, **{link: shaper.shape(link) for link in sorted(scene.mechanism.links)}}
    _check_points(survey)
    slides = Guides(survey, shapes, datum).slides()
    check_references(survey, slides)
    check_joining(survey, slides)
    output = _output(survey, slides)
    if survey.faults or not ends:
        return None
    links = {
        number: Link(number, {name: as_complex(s) for name, s in shape.items()}) for number, shape in shapes.items()
    }
    drive = Drive(scene.drive.link, *ends, float(scene.drive.speed), float(scene.drive.acceleration))
    return Mechanism(scene.title, datum, links, slides, drive, sketch, output, scene.mechanism.through)


def _from_datum(place: Spot, datum: Spot) -> Spot:
    return EXACT.subtract(place[0], datum[0]), EXACT.subtract(place[1], datum[1])


def _drive_ends(survey: Survey) -> tuple[str, str] | None:
    """Find the drive's fixed hinge and its far end."""
    link, path = survey.scene.drive.link, ("drive", "link")
    if not survey.know_link(path, link):
        return None
    points = survey.points_of[link]
    fixed = [name for name in points if name in survey.points_of[FRAME]]
    free = [name for name in points if name not in fixed]
    if survey.doubtful(path, ("mechanism", "links", str(link)), ("mechanism", "frame")):
        return (fixed[0], free[0]) if fixed and free else None
    if len(fixed) > 1:
        survey.report(path, "many_hinges", points=", ".join(fixed), link=link)
        survey.doubts.add(("mechanism", "links", str(link)))
    elif not fixed:
        advice = message("advice.hinge", link=link)
        survey.report(path, "no_hinge", suggestion=survey.twin(points, survey.points_of[FRAME]) or advice)
    elif not free:
        survey.report(path, "no_end", link=link, pivot=fixed[0])
    return (fixed[0], free[0]) if fixed and free else None


def _sketch(survey: Survey, datum: Spot) -> dict[str, complex]:
    sketch: dict[str, complex] = {}
    for name, place in sorted(survey.scene.mechanism.sketch.items(), key=lambda item: natural(item[0])):
        path: Path = ("mechanism", "sketch", name)
        if name in survey.points_of[FRAME]:
            continue  # it stands in its own place; where the sketch shows another, a note says so
        if survey.know(path, (name,)):
            sketch[name] = as_complex(_from_datum(place, datum))
    return sketch


def _with_crank(survey: Survey, ends: tuple[str, str] | None, places: dict[str, complex]) -> dict[str, complex]:
    """Add the place of the crank's end, where the first crank angle gives it better than no sketch."""
    first = survey.scene.drive.first
    if not ends or ends[1] in places or first is None:
        return places
    size = Shaper(survey, places).length(*ends)
    return places if size is None else {**places, ends[1]: float(size) * direction(first)}


def _check_points(survey: Survey) -> None:
    """See that [mechanism.points] and [mechanism.lengths] say things once, of links that exist."""
    form = survey.scene.mechanism
    for name, placed in form.points.items():
        path: Path = ("mechanism", "points", name)
        if placed.on == FRAME:
            survey.report((*path, "on"), "on_frame")
        elif survey.know_link((*path, "on"), placed.on) and name in form.links[placed.on][:2]:
            line = line_name(*survey.points_of[placed.on][:2]) if len(survey.points_of[placed.on]) > 1 else name
            survey.report(path, "second_by_place", name=name, link=placed.on, line=line)
    for pair, key in survey.lengths.items():
        _check_length(survey, pair, ("mechanism", "lengths", key))
    apart = spread(form.lengths)
    if apart and apart.ratio > RATIO_LIMIT:
        details = {"name": apart.longest, "other": apart.shortest, "ratio": f"{apart.ratio:.3g}"}
        survey.report(("mechanism", "lengths", apart.longest), "ratio", most=f"{RATIO_LIMIT:.0e}", **details)


def _check_length(survey: Survey, pair: frozenset[str], path: Path) -> None:
    first, second = split_line(str(path[2]))
    owners = survey.owners(pair)
    moving = [link for link in owners if link != FRAME]
    if not owners:
        if not survey.doubtful(("mechanism", "links"), ("mechanism", "points")):
            near = [line_name(*link[:2]) for link in survey.scene.mechanism.links.values() if len(link) > 1]
            advice = suggestion(str(path[2]), near, message("advice.add_link"))
            survey.report(path, "no_common_link", first=first, second=second, suggestion=advice)
    elif not moving:
        survey.report(path, "fixed_length", first=first, second=second)
    elif all(_by_place(survey, link, pair) for link in moving):
        name = next(name for name in (second, first) if name in survey.scene.mechanism.points)
        survey.report(path, "placed_twice", name=name)
    elif not any(pair & set(survey.points_of[link][:2]) for link in moving):
        base = survey.points_of[moving[0]][:2]
        needed = ", ".join(line_name(end, name) for name in (first, second) for end in base)
        survey.report(path, "spare_length", needed=needed)


def _by_place(survey: Survey, link: int, pair: frozenset[str]) -> bool:
    placed = survey.scene.mechanism.points
    letters = survey.scene.mechanism.links[link][:2]
    return any(name in placed and placed[name].on == link and name not in letters for name in pair)


@dataclass(frozen=True)
class Guides:
    """Makes the slides (направляющие) of a scene from its links' shapes."""

    survey: Survey
    shapes: Mapping[int, Mapping[str, Spot]]
    datum: Spot

    def slides(self) -> tuple[Slide, ...]:
        """Give all slides whose links, points and lines are known; report the others."""
        made = (self._slide(index, table) for index, table in enumerate(self.survey.scene.mechanism.slides))
        return tuple(slide for slide in made if slide)

    def _slide(self, index: int, table: SlideTable) -> Slide | None:
        path: Path = ("mechanism", "slides", index)
        if not self.survey.know_link((*path, "link"), table.link):
            return None
        point = table.point or self.survey.points_of[table.link][0]
        known = self.survey.on_link((*path, "point"), table.link, point)
        line = self._line((*path, "along"), table)
        spot = self.shapes[table.link].get(point)
        if not known or line is None or spot is None:
            return None
        owner, on_owner, label = line
        course = direction(EXACT.minus(table.angle))
        on_slider = Way(as_complex(spot) - float(table.offset) * 1j * course, course)
        return Slide(table.link, owner, on_slider, on_owner, point, label)

    def _line(self, path: Path, table: SlideTable) -> tuple[int, Way, str] | None:
        along = table.along
        if isinstance(along, FrameLine):
            course = direction(along.angle)
            through = as_complex(_from_datum(along.through, self.datum))
            # The point nearest to the datum: a guide may be named by one that is far away.
            return FRAME, Way(1j * course * (course.conjugate() * through).imag, course), ""
        if not self.survey.know(path, along):
            return None
        owner = self._owner(path, along, table.link)
        if owner is None:
            return None
        spots = [self.shapes[owner].get(name) for name in along]
        if spots[0] is None or spots[1] is None:
            return None  # the link's shape is at fault already
        if spots[0] == spots[1]:
            self.survey.report(path, "no_direction", first=along[0], second=along[1])
            return None
        run = as_complex(_from_datum(spots[1], spots[0]))
        return owner, Way(as_complex(spots[0]), run / abs(run)), line_name(*along)

    def _owner(self, path: Path, along: tuple[str, ...], slider: int) -> int | None:
        owners = self.survey.owners(along)
        others = [link for link in owners if link != slider]
        if len(others) == 1:
            return others[0]
        if self.survey.doubtful(("mechanism", "links"), ("mechanism", "points"), ("mechanism", "frame")):
            return None
        if others:
            self.survey.report(path, "many_owners", links=", ".join(map(str, others)))
        elif owners:
            self.survey.report(path, "not_itself")
        else:
            lines = {line_name(*points[:2]): link for link, points in self.survey.points_of.items() if len(points) > 1}
            advice = suggestion(line_name(*along), lines, message("advice.two_points"))
            self.survey.report(path, "no_common_link", first=along[0], second=along[1], suggestion=advice)
        return None


def _output(survey: Survey, slides: tuple[Slide, ...]) -> Output | None:
    """Give the output link: named, or that of the named point, of several the one that slides, else the last."""
    wanted = survey.scene.output
    if wanted is None:
        return None
    if wanted.link is not None:
        if not survey.know_link(("output", "link"), wanted.link):
            return None
        sliding = [slide.point for slide in slides if slide.slider == wanted.link and slide.owner == FRAME]
        return Output(wanted.link, sliding[0] if sliding else None)
    point = wanted.point or ""
    if not survey.know(("output", "point"), (point,)):
        return None
    owners = survey.owners((point,))
    if not owners or owners[0] == FRAME:
        survey.report(("output", "point"), "fixed_output", name=point)
        return None
    sliders = [slide.slider for slide in slides if slide.slider in owners and slide.owner == FRAME]
    return Output(sliders[-1] if sliders else owners[-1], point)


def _wrong_mobility(scene: Scene, mechanism: Mechanism) -> StructureError:
    hinges = sum(len(links) - 1 for links in mechanism.hinges.values())
    details = {
        "n": mechanism.moving_links,
        "p": mechanism.lower_pairs,
        "found": mechanism.mobility,
        "hinges": hinges,
        "slides": len(mechanism.slides),
        "advice": _mobility_advice(scene, mechanism),
    }
    links = tuple(sorted(scene.mechanism.links))
    return StructureError(scene.fault(("mechanism", "links"), "mobility", **details), links, mechanism.mobility)


def _mobility_advice(scene: Scene, mechanism: Mechanism) -> Message:
    fixed = mechanism.links[FRAME].points
    unused = [name for name in fixed if name not in mechanism.hinges]
    if mechanism.mobility > 1 and unused:
        return message("advice.joint_fixed", points=", ".join(unused))
    ends = _free_ends(scene, mechanism)
    if mechanism.mobility > 1 and ends:
        link, name = ends[0]
        return message("advice.joint_end", name=name, link=link)
    return message("advice.joint" if mechanism.mobility > 1 else "advice.held_twice")


def _free_ends(scene: Scene, mechanism: Mechanism) -> list[tuple[int, str]]:
    """Give the ends of links that hang on nothing: of a lead, one of its first two points is of no other link."""
    slid = {link for slide in mechanism.slides for link in (slide.slider, slide.owner)}
    leads = {link: points[:2] for link, points in scene.mechanism.links.items() if link not in slid}
    return [(link, name) for link, names in leads.items() for name in names if name not in mechanism.hinges]
