"""Edits that a forger makes with the source at hand: another leaf, drawn by the same pen."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from random import Random
from typing import Any

from drawings.paper.strokes import Arc, Circle, Fill, Group, Leaf, Line, LineStyle, Polyline, Stroke, Text
from drawings.reading.items import Item, SheetFigures, brought, items, middle
from drawings.reading.transform import Affine
from tests.forgeries.forgery import Told, of

Edit = Callable[[Leaf, Random], tuple[Leaf, Told] | None]
DIGITS = "0123456789"


def changed(leaf: Leaf, change: Callable[[Stroke], Any]) -> Leaf:
    """Change strokes: each is what `change` gives for it, none or several as it likes."""

    def within(strokes: tuple[Stroke, ...]) -> Iterator[Any]:
        for stroke in strokes:
            other = change(stroke)
            if other is stroke and isinstance(stroke, Group):
                other = stroke._replace(strokes=tuple(within(stroke.strokes)))
            yield from other if isinstance(other, list) else [] if other is None else [other]

    return leaf._replace(groups=tuple(within(leaf.groups)))


def swapped(leaf: Leaf, old: Stroke, new: Any) -> Leaf:
    """Put another stroke, several as a list, or none in the place of one."""
    return changed(leaf, lambda stroke: new if stroke is old else stroke)


def marked(leaf: Leaf, kind: str) -> list[Group]:
    found: list[Group] = []

    def look(stroke: Stroke) -> Stroke:
        if isinstance(stroke, Group) and stroke.data.get("kind") == kind:
            found.append(stroke)
        return stroke

    changed(leaf, look)
    return found


def pick(leaf: Leaf, chance: Random, wanted: Callable[[Item], bool]) -> Item | None:
    own = [item for item in items(leaf) if wanted(item)]
    return chance.choice(own) if own else None


def bearer(leaf: Leaf, mark: Group) -> Item:
    return next(item for item in items(leaf) if item.stroke is mark.strokes[0])


def _deleted(kind: str) -> Edit:
    def edit(leaf: Leaf, chance: Random) -> tuple[Leaf, Told] | None:
        if not (own := marked(leaf, kind)):
            return None
        mark = chance.choice(own)
        return swapped(leaf, mark, None), of(bearer(leaf, mark), SheetFigures(leaf), "missing")

    return edit


def all_but_one_deleted(leaf: Leaf, chance: Random) -> tuple[Leaf, Told] | None:
    own = [mark for kind in ("vector", "point") for mark in marked(leaf, kind)]
    if len(own) < 2:
        return None
    kept = chance.choice(own)
    gone = {id(mark) for mark in own if mark is not kept}
    first = next(mark for mark in own if mark is not kept)
    return changed(leaf, lambda one: None if id(one) in gone else one), of(
        bearer(leaf, first), SheetFigures(leaf), "missing"
    )


def arrow_shifted(leaf: Leaf, chance: Random) -> tuple[Leaf, Told] | None:
    own = [mark for mark in marked(leaf, "vector") if len(mark.strokes) > 1]
    if not own:
        return None
    mark = chance.choice(own)
    by = complex(chance.uniform(2, 9), chance.uniform(2, 9))
    return swapped(leaf, mark, brought(mark, Affine(t=by))), of(bearer(leaf, mark), SheetFigures(leaf), "moved")


def value_forged(leaf: Leaf, chance: Random) -> tuple[Leaf, Told] | None:
    """Forge a value together with its drawing: line, arrowhead and what is stated."""
    own = [mark for mark in marked(leaf, "vector") if abs(_along(mark)) > 2]
    if not own:
        return None
    mark = chance.choice(own)
    line = mark.strokes[0]
    assert isinstance(line, Line)
    by = _along(mark) * 0.07
    head = [brought(one, Affine(t=by)) for one in mark.strokes[1:]]
    value = complex(*map(float, mark.data["value"].split())) * 1.07
    data = dict(mark.data) | {"value": f"{value.real:.12g} {value.imag:.12g}"}
    forged = mark._replace(strokes=(line._replace(end=line.end + by), *head), data=data)
    return swapped(leaf, mark, forged), of(bearer(leaf, mark), SheetFigures(leaf), "end", "reshaped")


def _along(mark: Group) -> complex:
    line = mark.strokes[0]
    return line.end - line.start if isinstance(line, Line) else 0j


def reversed_vector(leaf: Leaf, chance: Random) -> tuple[Leaf, Told] | None:
    if not (own := marked(leaf, "vector")):
        return None
    mark = chance.choice(own)
    line = mark.strokes[0]
    assert isinstance(line, Line)
    other = mark._replace(strokes=(line._replace(start=line.end, end=line.start), *mark.strokes[1:]))
    return swapped(leaf, mark, other), of(bearer(leaf, mark), SheetFigures(leaf), "reversed")


def head_lost(leaf: Leaf, chance: Random) -> tuple[Leaf, Told] | None:
    found = pick(leaf, chance, lambda item: item.what == "arrowhead")
    return None if found is None else (swapped(leaf, found.stroke, None), of(found, SheetFigures(leaf), "missing"))


def head_at_the_other_end(leaf: Leaf, chance: Random) -> tuple[Leaf, Told] | None:
    own = [mark for mark in marked(leaf, "vector") if len(mark.strokes) == 2 and isinstance(mark.strokes[1], Fill)]
    if not own:
        return None
    mark = chance.choice(own)
    head = mark.strokes[1]
    other = brought(head, Affine(-1 + 0j, 0j, _ends(mark)))
    item = next(one for one in items(leaf) if one.stroke is head)
    return swapped(leaf, head, other), of(item, SheetFigures(leaf), "moved", "reshaped", "turned")


def _ends(mark: Group) -> complex:
    line = mark.strokes[0]
    assert isinstance(line, Line)
    return line.start + line.end


def _lettering(what: str) -> Edit:
    def edit(leaf: Leaf, chance: Random) -> tuple[Leaf, Told] | None:
        found = pick(leaf, chance, lambda item: item.what == what and any(one in DIGITS for one in item.name))
        if found is None or not isinstance(found.stroke, Text):
            return None
        runs = list(found.stroke.runs)
        place = chance.choice([k for k, run in enumerate(runs) if any(one in DIGITS for one in run.text)])
        runs[place] = runs[place]._replace(text=_other_digit(runs[place].text, chance))
        return swapped(leaf, found.stroke, found.stroke._replace(content=tuple(runs))), Told(
            ("text",), found.name, SheetFigures(leaf).of(found)
        )

    return edit


def _other_digit(text: str, chance: Random) -> str:
    place = chance.choice([k for k, one in enumerate(text) if one in DIGITS])
    digit = chance.choice([one for one in "123456789" if one != text[place]])
    return text[:place] + digit + text[place + 1 :]


def letters_swapped(leaf: Leaf, chance: Random) -> tuple[Leaf, Told] | None:
    own = [item for item in items(leaf) if item.what == "letter" and isinstance(item.stroke, Text)]
    pairs = [(a, b) for a in own for b in own if a.name != b.name and a.home.top == b.home.top]
    if not pairs:
        return None
    pair = chance.choice(pairs)
    a, b = (item.stroke for item in pair)
    assert isinstance(a, Text) and isinstance(b, Text)
    other = {id(a): a._replace(content=b.runs), id(b): b._replace(content=a.runs)}
    return changed(leaf, lambda one: other.get(id(one), one)), Told(
        ("text", "moved"), pair[0].name, SheetFigures(leaf).of(pair[0])
    )


def letter_lost(leaf: Leaf, chance: Random) -> tuple[Leaf, Told] | None:
    found = pick(leaf, chance, lambda item: item.what == "letter")
    return None if found is None else (
        swapped(leaf, found.stroke, None), Told(("missing",), found.name, SheetFigures(leaf).of(found))
    )  # fmt: skip


def letter_moved(leaf: Leaf, chance: Random) -> tuple[Leaf, Told] | None:
    found = pick(leaf, chance, lambda item: item.what == "letter")
    if found is None or not isinstance(found.stroke, Text):
        return None
    other = found.stroke._replace(at=found.stroke.at + 3 - 2j)
    return swapped(leaf, found.stroke, other), Told(("moved",), found.name, SheetFigures(leaf).of(found))


def _gone(kind: type) -> Edit:
    def edit(leaf: Leaf, chance: Random) -> tuple[Leaf, Told] | None:
        found = pick(leaf, chance, lambda item: type(item.stroke) is kind and not item.home.mark)
        return None if found is None else (swapped(leaf, found.stroke, None), of(found, SheetFigures(leaf), "missing"))

    return edit


def _styled(change: Callable[[LineStyle], LineStyle], *kinds: str) -> Edit:
    def edit(leaf: Leaf, chance: Random) -> tuple[Leaf, Told] | None:
        found = pick(leaf, chance, lambda item: isinstance(item.stroke, Line) and item.stroke.style.colour != "none")
        if found is None or not isinstance(found.stroke, Line):
            return None
        other = found.stroke._replace(style=change(found.stroke.style))
        return swapped(leaf, found.stroke, other), of(found, SheetFigures(leaf), *kinds)

    return edit


def line_turned(leaf: Leaf, chance: Random) -> tuple[Leaf, Told] | None:
    found = pick(leaf, chance, lambda item: isinstance(item.stroke, Line) and not item.home.mark)
    if found is None or not isinstance(found.stroke, Line):
        return None
    line = found.stroke
    other = line._replace(end=line.start + (line.end - line.start) * (1 + 0.2j))
    return swapped(leaf, line, other), of(found, SheetFigures(leaf), "end", "missing")


def circle_larger(leaf: Leaf, chance: Random) -> tuple[Leaf, Told] | None:
    found = pick(leaf, chance, lambda item: isinstance(item.stroke, Circle) and not item.home.mark)
    if found is None or not isinstance(found.stroke, Circle):
        return None
    other = found.stroke._replace(radius=found.stroke.radius * 1.1)
    return swapped(leaf, found.stroke, other), of(found, SheetFigures(leaf), "radius")


def copied(leaf: Leaf, chance: Random) -> tuple[Leaf, Told] | None:
    found = pick(leaf, chance, lambda item: not item.home.mark)
    if found is None:
        return None
    return swapped(leaf, found.stroke, [found.stroke, found.stroke]), of(found, SheetFigures(leaf), "copied")


def line_added(leaf: Leaf, chance: Random) -> tuple[Leaf, Told] | None:
    found = pick(leaf, chance, lambda item: isinstance(item.stroke, Line) and not item.home.mark)
    if found is None:
        return None
    at = middle(found.stroke)
    added = Line(at + 1.7 + 1j, at + 6 + 3j, LineStyle(0.35))
    return swapped(leaf, found.stroke, [found.stroke, added]), Told(("added",), "", None, middle(added))


def covered(leaf: Leaf, chance: Random) -> tuple[Leaf, Told] | None:
    """Cover a part of a figure by a rectangle in the colour of paper."""
    found = pick(leaf, chance, lambda item: item.what in ("vector", "cell", "letter"))
    if found is None:
        return None
    at, r = middle(found.stroke), 60.0
    patch = Polyline(
        (at - r - r * 1j, at + r - r * 1j, at + r + r * 1j, at - r + r * 1j),
        True,
        LineStyle(0.25, (), "#ffffff", "#ffffff"),
    )
    return leaf._replace(groups=(*leaf.groups, Group((patch,)))), Told(("patch",))


def title_cell(leaf: Leaf, chance: Random) -> tuple[Leaf, Told] | None:
    found = pick(
        leaf,
        chance,
        lambda item: item.what == "title_cell" and item.home.figure == "title-block" and len(item.name) > 3,
    )
    if found is None or not isinstance(found.stroke, Text):
        return None
    other = found.stroke._replace(content=(found.stroke.runs[0]._replace(text="Иванов"),))
    return swapped(leaf, found.stroke, other), Told(("text",), found.name, "title-block")


def group_lost(leaf: Leaf, chance: Random) -> tuple[Leaf, Told] | None:
    own = [group for group in leaf.groups if group.name and group.name not in ("frame", "corners", "title-block")]
    gone = chance.choice(own)
    return swapped(leaf, gone, None), Told(("missing",), None, gone.name)


def _group(by: Affine) -> Edit:
    """Bring a group elsewhere that has no lettering, which our pen turns by quarters alone."""

    def edit(leaf: Leaf, chance: Random) -> tuple[Leaf, Told] | None:
        written = {item.home.figure for item in items(leaf) if isinstance(item.stroke, Text)} if by.p.imag else set()
        own = [
            one for one in leaf.groups if one.name and one.name not in ("frame", "corners", *written) and one.strokes
        ]
        if not own:
            return None
        group = chance.choice(own)
        return swapped(leaf, group, brought(group, by)), Told(("moved",), None, group.name)

    return edit


def paper_larger(leaf: Leaf, chance: Random) -> tuple[Leaf, Told] | None:
    return leaf._replace(width=leaf.width * 1.01, height=leaf.height * 1.01), Told(("whole",))


LEAF_EDITS: dict[str, Edit] = {
    "a vector deleted": _deleted("vector"),
    "a point deleted": _deleted("point"),
    "all marks but one deleted": all_but_one_deleted,
    "an arrow shifted whole": arrow_shifted,
    "a value forged with its drawing": value_forged,
    "a vector drawn end for end": reversed_vector,
    "an arrowhead lost": head_lost,
    "an arrowhead at the other end": head_at_the_other_end,
    "a letter's number changed": _lettering("letter"),
    "a table cell changed": _lettering("cell"),
    "a heading or scale changed": _lettering("heading"),
    "a note changed": _lettering("note"),
    "an equation changed": _lettering("equation"),
    "two letters swapped": letters_swapped,
    "a letter lost": letter_lost,
    "a letter moved": letter_moved,
    "a line lost": _gone(Line),
    "an arc lost": _gone(Arc),
    "a circle lost": _gone(Circle),
    "a chain of lines lost": _gone(Polyline),
    "a line in white": _styled(lambda style: style._replace(colour="#ffffff"), "hidden"),
    "a line as thin as a hair": _styled(lambda style: style._replace(width=0.001), "hidden"),
    "a line of another width": _styled(lambda style: style._replace(width=style.width * 2), "style"),
    "a line with other dashes": _styled(lambda style: style._replace(dash=(1.0, 2.0)), "style"),
    "a line turned": line_turned,
    "a circle larger": circle_larger,
    "a stroke twice": copied,
    "a line added": line_added,
    "a patch over a figure": covered,
    "a cell of the title block changed": title_cell,
    "a figure or table lost": group_lost,
    "a group moved": _group(Affine(t=3 + 1j)),
    "a group scaled": _group(Affine(1.02 + 0j, 0j, -3 - 3j)),
    "a group turned": _group(Affine(1 + 0.01j, 0j, 1j)),
    "larger paper": paper_larger,
}
