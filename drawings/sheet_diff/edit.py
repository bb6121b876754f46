"""Edits: what of a written sheet is not as it must be, where, and by how much (правка листа)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

from drawings.paper.strokes import LineStyle, Text
from drawings.reading.items import Item, MarkScale, SheetFigures, middle
from drawings.sheet_diff.matching import Shift
from plans.words.words import Message, message

UNREAD = "unread"  # what an element draws cannot be told
LETTERS = 60  # of a text are told in a message; the rest is in the sheet


class Edit(NamedTuple):
    """One thing that was edited: how, what it is, its figure, its place (mm from the lower left corner)."""

    how: str  # missing, hidden, added, copied, moved, text, style, reversed, reshaped, radius, end
    what: str
    name: str
    figure: str
    at: complex
    moved: float | None  # mm
    scale: MarkScale | None
    told: Message
    strokes: int = 1  # so many

    def plain(self, language: str) -> dict[str, Any]:
        """Give it as plain data."""
        true = None if self.moved is None or self.scale is None else self.moved * self.scale.size
        return {
            "edit": self.how, "what": self.what, "name": self.name, "figure": self.figure,
            "at": [round(self.at.real, 4), round(self.at.imag, 4)], "count": self.strokes,
            "moved": None if self.moved is None else round(self.moved, 4),
            "true": true, "unit": self.scale.unit if true is not None and self.scale else None,
            "told": self.told.worded(language),
        }  # fmt: skip


def lone(how: str, item: Item, figures: SheetFigures, **parts: object) -> Edit:
    """Tell of one stroke: missing, hidden, added, there twice, or where it must be and written or drawn otherwise."""
    return _edit(how, item, figures, None, message(f"edit.{how}", thing=_thing(item, figures), **parts))


def unseen(item: Item, reason: str, figures: SheetFigures, under: Sequence[Item] = ()) -> Edit:
    """Tell of what is in the file beside what must be there, and is not seen or cannot be read, or hides others."""
    if under:
        parts = {"count": len(under), "first": _thing(under[0], figures)}
        return lone("patch", item, figures, **parts)._replace(strokes=len(under))
    if reason == UNREAD:
        said = message("edit.unread", name=f"{item.home.figure} {item.name}".strip())
        return _edit(UNREAD, item, figures, None, said)
    return lone("unseen", item, figures, reason=reason)


def restated(item: Item, there: Item, figures: SheetFigures) -> Edit:
    """Tell of a mark that is drawn as it must be and states something else, by the first thing that differs."""
    ours, theirs = item.home.mark, there.home.mark
    key = next(key for key in (*ours, *theirs) if ours.get(key) != theirs.get(key))
    said = {"key": key, "is_": theirs.get(key, "—")[:LETTERS], "must": ours.get(key, "—")[:LETTERS]}
    return lone("restated", item, figures, **said)


def moved(how: str, item: Item, figures: SheetFigures, by: float) -> Edit:
    """Tell of a stroke that lies elsewhere, by so many mm."""
    said = message(f"edit.{how}", thing=_thing(item, figures), by=_size(by, figures.scale(item)))
    return _edit(how, item, figures, by, said)


def whole(how: str, items: Sequence[Item], figures: SheetFigures) -> Edit:
    """Tell of a figure as a whole."""
    first = items[0]
    thing = message("edit.figure", figure=figures.called(figures.of(first)), at=_place(middle(first.stroke)))
    edit = _edit(how, first, figures, None, message(f"edit.{how}", thing=thing))
    return edit._replace(what="figure", name="", strokes=len(items))


def together(items: list[Item], figures: SheetFigures, shift: Shift, whole: bool) -> Edit:
    """Tell of strokes of one figure that were moved, turned and scaled as one."""
    first = items[0]
    name = figures.of(first)
    mark = first.home.mark.get("name", "") if all(item.home.mark == first.home.mark for item in items) else ""
    key = "figure" if whole else "mark" if mark else "some"
    thing = message(
        f"edit.{key}", figure=figures.called(name), at=_place(middle(first.stroke)),
        **({"part": message(f"part.{first.what}"), "name": mark} if key == "mark" else {}),
        **({"count": len(items)} if key == "some" else {}),
    )  # fmt: skip
    by = _size(shift.farthest, figures.scale(first) if mark or not whole else None)
    key, parts = _motion(shift)
    edit = _edit(shift.how, first, figures, shift.farthest, message(f"edit.{key}", thing=thing, by=by, **parts))
    return edit._replace(what=first.what if mark else "figure", name=mark, strokes=len(items))


def _motion(shift: Shift) -> tuple[str, dict[str, object]]:
    if shift.how != "moved":
        return shift.how, {}
    scale, turn = f"{shift.scale:.4g}", f"{shift.turn:.2f}"  # as exactly as an arrow of a few mm shows them
    scaled, turned = scale != "1", float(turn) != 0
    parts: dict[str, object] = {**({"scale": scale} if scaled else {}), **({"turn": turn} if turned else {})}
    return ("scaled_turned" if scaled and turned else "scaled" if scaled else "turned" if turned else "moved"), parts


def style(right: LineStyle, there: LineStyle) -> Message:
    """Tell what of the look of a line is another."""
    if right.width != there.width:
        return message("look.width", is_=_number(there.width), must=_number(right.width))
    if right.dash != there.dash:
        return message("look.dash", is_=_dashes(there), must=_dashes(right))
    name = next((name for name in ("colour", "fill", "cap") if getattr(right, name) != getattr(there, name)), "join")
    return message(f"look.{name}", is_=getattr(there, name), must=getattr(right, name))


def written(text: Text) -> str:
    """Give lettering as a message tells it."""
    plain = text.plain
    return plain if len(plain) <= LETTERS else f"{plain[:LETTERS]}…"


def _dashes(style: LineStyle) -> str:
    return " ".join(map(_number, style.dash)) or "—"


def _number(size: float) -> str:
    return f"{size:.4g}"


def _edit(how: str, item: Item, figures: SheetFigures, by: float | None, said: Message) -> Edit:
    scale = figures.scale(item) if by is not None else None
    return Edit(how, item.what, item.name, figures.of(item), middle(item.stroke), by, scale, said)


def _thing(item: Item, figures: SheetFigures) -> Message:
    part: object = message(f"part.{item.what}")
    if item.name:
        quoted = isinstance(item.stroke, Text)
        name = written(item.stroke) if isinstance(item.stroke, Text) else item.name
        part = message("edit.quoted" if quoted else "edit.called", part=part, name=name)
    return message("edit.thing", part=part, at=_place(middle(item.stroke)), figure=figures.called(figures.of(item)))


def _place(at: complex) -> Message:
    return message("edit.place", x=f"{at.real:.2f}", y=f"{at.imag:.2f}")


def _size(by: float, scale: MarkScale | None) -> Message:
    """Tell a length on paper, and what it stands for."""
    if scale is None:
        return message("edit.by", by=f"{by:.4g}")
    return message("edit.by_true", by=f"{by:.4g}", true=f"{by * scale.size:.4g}", unit=scale.unit)
