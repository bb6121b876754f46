"""Slips of a careless draughtsman (небрежность): changes of a laid-out sheet that its self-check must see."""

from __future__ import annotations

from collections.abc import Callable

from drawings.paper.strokes import Circle, Group, Leaf, Line, Stroke, Text, stated

Change = Callable[[Stroke], Stroke | None]


def changed(leaf: Leaf, change: Change) -> Leaf:
    """Change every stroke of a sheet; one changed into None is left out."""
    return leaf._replace(groups=tuple(group for g in leaf.groups if isinstance(group := _walked(g, change), Group)))


def _walked(stroke: Stroke, change: Change) -> Stroke | None:
    found = change(stroke)
    if isinstance(found, Group):
        kept = tuple(inner for s in found.strokes if (inner := _walked(s, change)) is not None)
        return found._replace(strokes=kept) if kept else None
    return found


def marked(name: str, plan: str = "", kind: str = "") -> Callable[[Stroke], bool]:
    """Tell of a stroke whether it is a mark of a name on a plan, of a kind or of any."""

    def is_it(stroke: Stroke) -> bool:
        data = stroke.data if isinstance(stroke, Group) else {}
        own = data.get("name") == name and data.get("plan", "") == plan
        return own and kind in ("", data.get("kind"))

    return is_it


def stretched(name: str, plan: str, by: complex = 1.01) -> Change:
    """Draw a vector otherwise than it is, 1 % too long, and state it so: measuring alone cannot see it."""
    is_it = marked(name, plan, "vector")

    def change(stroke: Stroke) -> Stroke:
        if isinstance(stroke, Group) and is_it(stroke):
            line = stroke.strokes[0]
            assert isinstance(line, Line)
            x, y = (float(part) for part in stroke.data["value"].split())
            longer = line._replace(end=line.start + by * (line.end - line.start))
            return stroke._replace(strokes=(longer,), data={**stroke.data, "value": stated(by * complex(x, y))})
        return stroke

    return change


def shifted(name: str, plan: str, by: complex) -> Change:
    """Draw a mark some millimetres aside, and state it so."""

    is_it = marked(name, plan)

    def change(stroke: Stroke) -> Stroke:
        if not isinstance(stroke, Group) or not is_it(stroke):
            return stroke
        first, *rest = stroke.strokes
        scale = float(stroke.data["scale"])
        x, y = (float(part) for part in stroke.data["value"].split())
        data = {**stroke.data, "value": stated(complex(x, y) + by * scale)}
        moved = (
            first._replace(end=first.end + by)
            if isinstance(first, Line)
            else first._replace(centre=first.centre + by)
            if isinstance(first, Circle)
            else first
        )
        return stroke._replace(strokes=(moved, *rest), data=data)

    return change


def rewritten(old: str, new: str) -> Change:
    """Write another text for one, known by its markup or as it is read."""
    return lambda s: s._replace(content=new) if isinstance(s, Text) and old in (s.content, s.plain) else s


def in_part(name: str, change: Change) -> Change:
    """Change strokes of one part of the sheet alone."""

    def whole(stroke: Stroke) -> Stroke | None:
        if not isinstance(stroke, Group) or stroke.name != name:
            return stroke
        return changed(Leaf(1.0, 1.0, (stroke,)), change).groups[0]

    return whole
