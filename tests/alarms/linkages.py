"""Linkages of course projects (механизмы курсовых проектов) by lot, of sizes by which the crank turns fully."""

from __future__ import annotations

import cmath
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from math import asin, cos, degrees, pi, radians, sin, sqrt

from tests.alarms.lot import Lot, length, place, rows
from tests.trials.crank_rockers import meeting

SMALLEST, LARGEST = 0.03, 0.15  # m: a crank
QUARTERS = (0, 90, 180, -90)  # degrees

Guide = tuple[complex, complex] | str  # a point of it and its direction; or as it is written


@dataclass(frozen=True)
class Linkage:
    """A linkage as it stands at one crank angle: links, lengths, guides by their link, places; and its tool."""

    name: str
    links: Mapping[int, str]
    frame: Mapping[str, complex]
    lengths: Mapping[str, float]
    slides: Sequence[tuple[int, Guide]]
    sketch: Mapping[str, complex]
    tool: tuple[int, str]  # link and point
    stroke: float  # of the tool, m; of one that turns, rad
    end: complex  # direction of the crank
    points: Mapping[str, str] = field(default_factory=dict)
    drive: str = ""  # where it goes over a stroke

    @property
    def crank(self) -> float:
        """Length of the crank, m, or of the longest link of what is driven otherwise."""
        return next(iter(self.lengths.values()))

    @property
    def rods(self) -> Mapping[int, float]:
        """The links that have a length, m; blocks and sliders have none."""
        return {link: self.lengths[name[:2]] for link, name in self.links.items() if name[:2] in self.lengths}

    @property
    def slides_on_the_frame(self) -> bool:
        """Whether its tool goes along a guide."""
        return any(link == self.tool[0] and not isinstance(guide, str) for link, guide in self.slides)

    def seen(self, turn: complex, mirrored: bool) -> Linkage:
        """Turn it, after it is mirrored."""

        def moved(point: complex) -> complex:
            return (point.conjugate() if mirrored else point) * turn

        slides = [(k, one if isinstance(one, str) else (moved(one[0]), moved(one[1]))) for k, one in self.slides]
        frame = {name: moved(point) for name, point in self.frame.items()}
        sketch = {name: moved(point) for name, point in self.sketch.items()}
        return replace(self, frame=frame, sketch=sketch, slides=slides, end=moved(self.end))

    def tables(self) -> str:
        """Write its tables."""
        guides = [(link, one if isinstance(one, str) else _guide(*one)) for link, one in self.slides]
        tables = {
            "frame": {name: place(point) for name, point in self.frame.items()},
            "links": {link: f'"{points}"' for link, points in self.links.items()},
            "lengths": {name: length(size) for name, size in self.lengths.items()},
            "points": self.points,
            "sketch": {name: place(point) for name, point in self.sketch.items()},
        }
        told = ([f"[mechanism.{key}]", *(f"{k} = {v}" for k, v in own.items())] for key, own in tables.items())
        return rows(*told, (f"[[mechanism.slides]]\nlink = {link}\nalong = {way}" for link, way in guides))


def linkage(lot: Lot, names: Sequence[str] = ()) -> Linkage:
    """Draw a linkage of one of these names, or of any, its guide mostly along an axis."""
    name = lot.any(*(names or LINKAGES))
    found = LINKAGES[name](lot, cmath.rect(1, radians(lot.size(-180, 180, 0, 30, 45, 60, 90, 120, 180))))
    ways = [guide[1] for _, guide in found.slides if not isinstance(guide, str)]
    axis = lot.any(0, 0, *QUARTERS) if lot.on(0.85) else lot.size(-180, 180, 30, 45, 60)
    mirrored = lot.on(0.3)
    way = (ways[-1].conjugate() if mirrored else ways[-1]) if ways else 1
    return found.seen(cmath.rect(1, radians(axis)) / way, mirrored)


def _guide(through: complex, way: complex) -> str:
    return f"{{ through = {place(through)}, angle = {round(degrees(cmath.phase(way)), 4):g} }}"


def _along(pin: complex, rod: float, through: complex, way: complex) -> complex:
    """Give the place of a slider at the end of a rod, in the sense of its guide."""
    local = (pin - through) / way
    return through + way * (local.real + sqrt(rod**2 - local.imag**2))


def _unit(vector: complex) -> complex:
    return vector / abs(vector)


def _further(
    one: Linkage, name: str, links: Mapping[int, str], lengths: Mapping[str, float], sketch: Mapping[str, complex]
) -> Linkage:
    """Hang a further group on a linkage; its last link is the tool."""
    tool = max(links)
    named = {"links": {**one.links, **links}, "lengths": {**one.lengths, **lengths}, "tool": (tool, links[tool][-1])}
    return replace(one, name=name, sketch={**one.sketch, **sketch}, **named)


def slider_crank(lot: Lot, end: complex) -> Linkage:
    """Give a slider-crank, in half of the scenes with its guide beside the shaft."""
    crank = lot.size(SMALLEST, LARGEST)
    rod, beside = crank * lot.size(2.4, 6, 3, 4, 5), crank * lot.size(-0.4, 0.4, 0) * lot.any(0, 1)
    stroke = sqrt((rod + crank) ** 2 - beside**2) - sqrt((rod - crank) ** 2 - beside**2)
    guide, lengths = (beside * 1j, 1 + 0j), {"OA": crank, "AB": rod}
    sketch, links = {"B": _along(crank * end, rod, *guide)}, {1: "OA", 2: "AB", 3: "B"}
    return Linkage("slider-crank", links, {"O": 0j}, lengths, [(3, guide)], sketch, (3, "B"), stroke, end)


def crank_rocker(lot: Lot, end: complex) -> Linkage:
    """Give a crank-rocker: of the lengths of its rod by which the crank turns fully one well within."""
    crank = lot.size(SMALLEST, LARGEST)
    frame, rocker = crank * lot.size(2.2, 5, 3, 4), crank * lot.size(1.7, 4.5, 2, 3)
    least, most = abs(frame - rocker) + crank, frame + rocker - crank
    lengths = {"OA": crank, "AB": least + (most - least) * lot.size(0.2, 0.8, 0.5), "CB": rocker}
    sketch = {"B": meeting(crank * end, lengths["AB"], complex(frame), rocker, 1)}
    frames, links = {"O": 0j, "C": complex(frame)}, {1: "OA", 2: "AB", 3: "CB"}
    one = Linkage("crank-rocker", links, frames, lengths, [], sketch, (3, "B"), 0, end)
    far, near = _extremes(one)
    return replace(one, stroke=abs(cmath.phase(far / near)))


def coupler(lot: Lot, end: complex) -> Linkage:
    """Give a crank-rocker with a point of its rod whose curve is drawn."""
    one = crank_rocker(lot, end)
    rod = one.lengths["AB"]
    at = complex(rod * lot.size(0.2, 1.3, 0.5, 1), rod * lot.size(0.15, 0.5, 0.5) * lot.any(1, -1))
    return replace(one, links={**one.links, 2: "ABE"}, points={"E": f"{{ on = 2, at = {place(at)} }}"})


def rocker_slider(lot: Lot, end: complex) -> Linkage:
    """Give a crank-rocker whose rocker, longer than to B or not, moves a slider by a rod."""
    one = crank_rocker(lot, end)
    centre, rocker, half = one.frame["C"], one.lengths["CB"], one.stroke / 2
    letter, reach = ("B", rocker) if lot.on(0.5) else ("D", rocker * lot.size(0.6, 1.6, 1.5))
    middle, rod = _unit(sum(_extremes(one))), reach * lot.size(1, 2.5, 1, 2)
    guide = (centre + middle * reach * (1 + cos(half)) / 2, -1j * middle)
    sketch = {"E": _along(centre + reach * _unit(one.sketch["B"] - centre), rod, *guide)}
    rocking = {3: "CB"} if letter == "B" else {3: "CBD"}
    found = _further(one, "rocker and slider", {**rocking, 4: f"{letter}E", 5: "E"}, {f"{letter}E": rod}, sketch)
    points = {"D": f"{{ on = 3, at = [{reach:.6f}, 0] }}"} if letter == "D" else {}
    return replace(found, slides=[(5, guide)], points=points, stroke=2 * reach * sin(half))


def toggle_press(lot: Lot, end: complex) -> Linkage:
    """Give a press whose knee is all but straight at one extreme of the rocker, a few degrees short of it."""
    one = crank_rocker(lot, end)
    rocker, short = one.lengths["CB"], radians(lot.size(2, 6, 3, 5))
    widest = one.stroke + short
    way = _unit(sum(_extremes(one))) * cmath.exp(1j * lot.any(1, -1) * (one.stroke / 2 + short))
    rod = rocker * (lot.size(0.95, 1.1, 1) if sin(min(widest, pi / 2)) < 0.8 else lot.size(1.2, 1.6))
    guide = (one.frame["C"], way)
    sketch = {"D": _along(one.sketch["B"], rod, *guide)}
    stroke = rocker * cos(short) + rod - rocker * cos(widest) - sqrt(rod**2 - (rocker * sin(widest)) ** 2)
    found = _further(one, "toggle press", {4: "BD", 5: "D"}, {"BD": rod}, sketch)
    return replace(found, slides=[(5, guide)], stroke=stroke)


def crusher(lot: Lot, end: complex) -> Linkage:
    """Give a crank-rocker whose rocker moves another one by a rod."""
    one = crank_rocker(lot, end)
    rocker, middle = one.lengths["CB"], _unit(sum(_extremes(one)))
    chord = 2 * rocker * sin(one.stroke / 2)
    rod, jaw = max(rocker, chord) * lot.size(1.2, 1.8, 1.5), max(rocker, chord) * lot.size(1.2, 2.2, 1.5, 2)
    pivot = one.frame["C"] + middle * (rocker + jaw) - 1j * middle * rod
    sketch = {"D": meeting(one.sketch["B"], rod, pivot, jaw, -1)}
    found = _further(one, "crusher", {4: "BD", 5: "ED"}, {"BD": rod, "ED": jaw}, sketch)
    return replace(found, frame={**one.frame, "E": pivot}, stroke=2 * asin(chord / 2 / jaw))


def _extremes(one: Linkage) -> tuple[complex, complex]:
    """Give the directions of a rocker where crank and rod lie in one line."""
    crank, rod, rocker = one.lengths.values()
    far, near = (meeting(0j, rod + sign * crank, one.frame["C"], rocker, 1) for sign in (1, -1))
    return _unit(far - one.frame["C"]), _unit(near - one.frame["C"])


def shaper(lot: Lot, end: complex) -> Linkage:
    """Give a crank shaper, whose guide halves the rise of the arc of B."""
    crank, times = lot.size(0.05, LARGEST), lot.size(1.9, 4, 2, 3)
    slotted, half = crank * (1 + times) * lot.size(1.2, 1.6, 1.5), asin(1 / times)
    one = _slotted("shaper", end, (crank, slotted, slotted * lot.size(0.25, 0.6, 0.5)), times, (1 + cos(half)) / 2)
    return replace(one, stroke=2 * slotted / times)


def whitworth(lot: Lot, end: complex) -> Linkage:
    """Give Whitworth's quick return: the pivot within the circle of the crank, the guide through it."""
    crank = lot.size(0.05, LARGEST)
    slotted = crank * lot.size(1.2, 2, 1.5)
    return _slotted("Whitworth", end, (crank, slotted, slotted * lot.size(2, 4, 2, 3)), lot.size(0.25, 0.7, 0.5), 0)


def _slotted(name: str, end: complex, sizes: tuple[float, float, float], times: float, height: float) -> Linkage:
    """Give a slotted link with a rod and a slider; the guide is so many of its lengths above its pivot."""
    crank, slotted, rod = sizes
    centre, pin = -1j * crank * times, crank * end
    b, guide = centre + slotted * _unit(pin - centre), (centre + 1j * slotted * height, 1 + 0j)
    slides: list[tuple[int, Guide]] = [(2, '"CB"'), (5, guide)]
    links, sketch = {1: "OA", 2: "A", 3: "CB", 4: "BD", 5: "D"}, {"A": pin, "B": b, "D": _along(b, rod, *guide)}
    lengths, frame = {"OA": crank, "CB": slotted, "BD": rod}, {"O": 0j, "C": centre}
    return Linkage(name, links, frame, lengths, slides, sketch, (5, "D"), 2 * slotted, end)


def swinging_cylinder(lot: Lot, end: complex) -> Linkage:
    """Give a crank whose rod slides in a cylinder that swings."""
    crank, times = lot.size(SMALLEST, LARGEST), lot.size(2.2, 5, 3, 4)
    rod, frame = crank * (times + lot.size(1.3, 2, 1.5)), {"O": 0j, "C": -1j * crank * times}
    sketch, links = {"B": crank * end + rod * _unit(frame["C"] - crank * end)}, {1: "OA", 2: "AB", 3: "C"}
    lengths, swing = {"OA": crank, "AB": rod}, 2 * asin(1 / times)
    return Linkage("swinging cylinder", links, frame, lengths, [(3, '"AB"')], sketch, (3, "C"), swing, end)


def scotch_yoke(lot: Lot, end: complex) -> Linkage:
    """Give a Scotch yoke."""
    crank = lot.size(SMALLEST, LARGEST)
    beside = -crank * lot.size(1, 2, 1.5) * 1j
    slides: list[tuple[int, Guide]] = [(2, "{ link = 3, angle = 90 }"), (3, (beside, 1 + 0j))]
    sketch, links = {"B": crank * end.real + beside}, {1: "OA", 2: "A", 3: "B"}
    return Linkage("yoke", links, {"O": 0j}, {"OA": crank}, slides, sketch, (3, "B"), 2 * crank, end)


def ram(lot: Lot, _end: complex) -> Linkage:
    """Give a ram that lifts a rocker by a rod."""
    rod = lot.size(0.3, 0.8, 0.5)
    rocker, high = rod * lot.size(0.8, 1.3, 1), rod * lot.size(0, 0.2, 0)
    far, near = rod + rocker - 0.15 * rod, abs(rod - rocker) + 0.35 * rod
    at, stroke = sqrt(far**2 - high**2), sqrt(far**2 - high**2) - sqrt(near**2 - high**2)
    frame, guide, links = {"C": complex(at, high)}, (0j, 1 + 0j), {1: "A", 2: "AB", 3: "CB"}
    sketch, drive = {"B": meeting(0j, rod, frame["C"], rocker, 1)}, _stroke(lot, 0, stroke)
    lengths = {"AB": rod, "CB": rocker}
    return Linkage("ram", links, frame, lengths, [(1, guide)], sketch, (3, "B"), 0.5, 1 + 0j, drive=drive)


def boom(lot: Lot, _end: complex) -> Linkage:
    """Give a boom that a hydraulic cylinder lifts."""
    arm, apart = lot.size(0.3, 0.8, 0.5), lot.size(0.4, 0.75, 0.5, 0.6)
    near, far = arm * (1 - apart) + 0.3 * arm * apart, arm * (1 + apart) - 0.2 * arm * apart
    lengths, frame = {"OF": arm, "FG": near * lot.size(0.9, 0.97)}, {"O": 0j, "E": complex(arm * apart)}
    top, links = meeting(0j, arm, frame["E"], near, 1), {1: "OF", 2: "FG", 3: "E"}
    sketch = {"F": top, "G": top + lengths["FG"] * _unit(frame["E"] - top)}
    drive = _stroke(lot, near, far, 'between = "EF"')
    return Linkage("boom", links, frame, lengths, [(3, '"FG"')], sketch, (1, "F"), 1, 1 + 0j, drive=drive)


def _stroke(lot: Lot, start: float, end: float, *more: str) -> str:
    speed = lot.size(0.02, 0.3, 0.1)
    law = lot.any(f"speed = {speed}", f"speeds = [0, {speed}, {speed}, 0]", f"speeds = [{speed}, {2 * speed}]")
    ends = (f"from = {length(start)}", f"to = {length(end)}")
    return rows("[drive]", "link = 1", f"positions = {lot.any(6, 8, 10, 12)}", "[drive.stroke]", more, ends, law)


LINKAGES: Mapping[str, Callable[[Lot, complex], Linkage]] = {
    "slider-crank": slider_crank, "crank-rocker": crank_rocker, "coupler curve": coupler, "shaper": shaper,
    "rocker and slider": rocker_slider, "toggle press": toggle_press, "crusher": crusher, "Whitworth": whitworth,
    "swinging cylinder": swinging_cylinder, "yoke": scotch_yoke, "ram": ram,
    "boom": boom,
}  # fmt: skip
