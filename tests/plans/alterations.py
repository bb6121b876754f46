"""A mechanism altered as a whole: mapped with its frame, or described by other names and numbers."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

from plans.model.mechanism import FRAME, Link, Mechanism, Way

Map = Callable[[complex], complex]


def moved(mechanism: Mechanism, frame: Map, own: Map | None = None) -> Mechanism:
    """Map the frame and the sketch, and where `own` says so, every link in its own frame."""
    maps: dict[int, Map] = dict.fromkeys(mechanism.links, own or (lambda place: place)) | {FRAME: frame}
    links = {n: Link(n, {p: maps[n](z) for p, z in link.points.items()}) for n, link in mechanism.links.items()}
    slides = tuple(
        s._replace(on_slider=_way(s.on_slider, maps[s.slider]), on_owner=_way(s.on_owner, maps[s.owner]))
        for s in mechanism.slides
    )
    sketch = {name: frame(place) for name, place in mechanism.sketch.items()}
    return replace(mechanism, links=links, slides=slides, sketch=sketch)


def _way(way: Way, by: Map) -> Way:
    return Way(by(way.through), by(way.direction) / abs(by(1 + 0j)))


def renamed(mechanism: Mechanism, points: Mapping[str, str], numbers: Mapping[int, int]) -> Mechanism:
    """Give links other numbers and points other names, and list them all in the order of their new names."""
    links = {
        numbers[n]: Link(numbers[n], {points[p]: z for p, z in link.points.items()})
        for n, link in mechanism.links.items()
    }
    slides = [
        s._replace(slider=numbers[s.slider], owner=numbers[s.owner], point=points.get(s.point, s.point))
        for s in mechanism.slides
    ]
    old = mechanism.drive
    drive = old._replace(link=numbers[old.link], pivot=points[old.pivot], end=points[old.end])
    return replace(
        mechanism,
        links=dict(sorted(links.items())),
        slides=tuple(reversed(slides)),
        drive=drive,
        sketch={points[name]: place for name, place in sorted(mechanism.sketch.items(), reverse=True)},
        output=None,
    )
