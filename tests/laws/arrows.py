"""The law of arrows: a head lies at the end of its line, looks along it, and is as sharp as all (стрелки)."""

from __future__ import annotations

import math
from collections.abc import Iterator

from drawings.paper.hand import Hand
from drawings.paper.strokes import Arc, Circle, Fill, Group, Kind, Leaf, Line, Polyline, Stroke
from drawings.paper.walk import flat, groups

LONG = 5.0  # mm of a straight head on A1
SHARP, BLUNT = (math.tan(math.radians(angle / 2)) for angle in (20, 30))  # half the width by the length of one, at most
SHARE = 1.5  # lengths of its head that a vector has at the least: a shorter one has a smaller, blunter head
LEAST = 1.5  # mm of a head that is seen: a shorter vector is all head
FINE = 0.02  # mm: less than a twentieth of the thinnest line
MARKS = ("vector", "force")


def breaches(leaf: Leaf, hand: Hand) -> Iterator[str]:
    """Name the arrows whose heads stand elsewhere, look elsewhere or have another shape."""
    for group in groups(leaf.groups):
        own = [*flat((group,))] if _is_arrow(group) else []
        lines = [one for one in own if isinstance(one, Line)]
        for head in own:
            if isinstance(head, Fill | Polyline) and len(head.points) == 3 and lines:
                wrong = _wrong(lines[0], head, hand)
                if wrong:
                    yield f"{group.data.get('plan', '')} {group.data.get('name') or group.states}: its head {wrong}"
        arc = next((one for one in own if isinstance(one, Arc)), None)
        if arc is not None and not lines and not any(_on(arc, head) for head in own if _is_head(head)):
            yield f"{group.states or group.data}: no head at an end of its arc"
    for figure in (figure for figure in leaf.groups if figure.name.startswith("lever-")):
        yield from (f"{figure.name}: {name} is off its image" for name in _loose(figure))


def _loose(figure: Group) -> Iterator[str]:
    """Name the forces of a lever that neither stand at an image nor are led from one by a thin line."""
    every, leads = [*groups((figure,))], [one for one in figure.strokes if isinstance(one, Line)]
    marks = [one for group in every if group.data.get("kind") in ("point", "pole") for one in group.strokes]
    images = [one.centre for one in marks if isinstance(one, Circle)]
    for force in (group for group in every if group.data.get("kind") == "force"):
        ends = [end for one in force.strokes if isinstance(one, Line) for end in (one.start, one.end)]
        ends += [lead.start for lead in leads if min(abs(lead.end - end) for end in ends) <= FINE]
        if min(abs(end - image) for end in ends for image in images) > FINE:
            yield force.data["name"]


def _is_arrow(group: Group) -> bool:
    stated = group.states is not None and group.states.kind in (Kind.DIRECTION, Kind.AXIS)
    return stated or group.data.get("kind") in MARKS


def _is_head(stroke: Stroke) -> bool:
    return isinstance(stroke, Fill | Polyline) and len(stroke.points) == 3


def _wrong(line: Line, head: Fill | Polyline, hand: Hand) -> str:
    """Say what is wrong with a head of a line that ends in its arrow."""
    tip, back, half = parts_of(head)
    run = line.end - line.start
    if not abs(run) > FINE:
        return ""
    if min(abs(tip - line.end), abs(tip - line.start)) > FINE:
        return "is not at its end"
    away = line.start if abs(tip - line.end) <= FINE else line.end
    if abs(((back - tip) * run.conjugate()).imag) > FINE * abs(run):
        return "does not lie along it"
    long = abs(tip - back)
    most = max(abs(run) / SHARE, min(abs(run), LEAST))
    if long > min(LONG, most) + FINE and ((tip - back) * (tip - away).conjugate()).real > 0:
        return "is too large"
    small = abs(long - most) <= FINE
    wide = [min(size * LONG * SHARP, long * BLUNT) for size in (hand.symbol, 1.0)] if small else [long * SHARP]
    return "" if any(abs(half - one) <= 2 * FINE for one in wide) else "has another angle"


def parts_of(head: Fill | Polyline) -> tuple[complex, complex, float]:
    """Give the tip of a head, the middle of its back, and half its width."""
    points = head.points
    far = [abs(2 * one - sum(points) + one) for one in points]
    tip = points[far.index(max(far))]
    wings = [one for one in points if one != tip]
    return tip, sum(wings) / 2, abs(wings[0] - wings[-1]) / 2


def _on(arc: Arc, head: Stroke) -> bool:
    """Tell whether a head goes on from an end of an arc, or ends there, along its circle."""
    assert isinstance(head, Fill | Polyline)
    tip, back, _ = parts_of(head)
    round_ = all(abs(abs(spot - arc.centre) - arc.radius) <= FINE for spot in (tip, back))
    return round_ and min(abs(spot - arc.at(share)) for spot in (tip, back) for share in (0.0, 1.0)) <= FINE
