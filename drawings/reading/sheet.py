"""A sheet that was seen: all that is drawn on it and can be seen, and what cannot (увиденный лист)."""

import cmath
import math
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from functools import lru_cache
from itertools import pairwise
from typing import NamedTuple

from drawings.paper.limits import SheetRefused
from drawings.paper.strokes import GIVEN, INK, LOWERED, RAISED, Group, Leaf, LineStyle, Run, Stroke, Text
from drawings.paper.walk import flat, groups
from drawings.reading import alphabet
from drawings.reading.alphabet import UNREAD as NO_LETTER
from drawings.reading.covering import veiled
from drawings.reading.lettered import PathLetters, any_letters, pen_of_letters, plain_letters, written
from drawings.reading.marks import KINDS, Nest
from drawings.reading.measure import Measured, measure
from drawings.reading.outlines import SHAPES, cornered, outlines, scale_of
from drawings.reading.pathdata import SPACE, number
from drawings.reading.transform import STAY, Affine, Viewport, viewport
from drawings.reading.visibility import LineInk, Look, Said, Unseen, declarations, ink, length, unfollowed

EM = 1.4  # a font's size over the height of its capitals
FREE = 0.1  # sizes, which a font leaves free before its first letter
_WORDS = 0.4  # sizes: what is farther apart is two words
_EVEN = 0.01  # sizes: how far a level may be off
_RISES = {-1: -LOWERED, 1: RAISED}


class Typeset(NamedTuple):
    """One element of text: its characters, where its ink begins (mm, y up), its size and length, mm, how it stands."""

    plain: str
    at: complex
    size: float
    length: float
    rotation: float
    slanted: bool


def typeset(plain: str, place: Affine, look: Look, attributes: Mapping[str, str]) -> Typeset:
    """Read one element of text."""
    # A font stands on a line of writing that goes along x, and upward against y.
    along, up = place.p + place.q, (place.p - place.q) * -1j
    size = length(look.font_size) / EM * abs(up)
    turn = along / abs(along)
    at = place(complex(number(attributes.get("x", "0")), number(attributes.get("y", "0")))) + FREE * size * turn
    long = number(attributes.get("textLength", "0")) * abs(along) - 2 * FREE * size
    slanted = look.font_style in ("italic", "oblique")
    return Typeset(plain, at, size, long, round(math.degrees(cmath.phase(turn)) % 360, 6) % 360, slanted)


def joined(parts: Sequence[Typeset], said: str, ink: LineStyle) -> Text:
    """Read elements of text that stand together as one text with its levels."""
    size = max(part.size for part in parts)
    first = parts[0]
    turn = cmath.rect(1, math.radians(first.rotation))
    row = sorted(parts, key=lambda part: (part.at / turn).real)
    low = next((part.at / turn).imag for part in row if part.size == size)
    signs = [(sign, level) for plain, level in _levels(row, turn, low, size) for sign in alphabet.signs(plain)]
    shown = [(sign.seen, level or sign.level) for sign, level in signs]
    runs = alphabet.picked(shown, [sign.thin for sign, _ in signs], said, fonts=True)
    at = turn * complex((row[0].at / turn).real, low)
    return Text(at, runs, round(size, 4), "start", first.slanted, first.rotation, ink)


def _levels(row: Sequence[Typeset], turn: complex, low: float, size: float) -> Iterator[tuple[str, int]]:
    before = [""] + [" " if _apart(text, after, turn, size) else "" for text, after in pairwise(row)]
    for part, space in zip(row, before, strict=True):
        rise = ((part.at / turn).imag - low) / size
        yield space + part.plain, next((level for level, raised in _RISES.items() if abs(rise - raised) <= _EVEN), 0)


def _apart(before: Typeset, after: Typeset, turn: complex, size: float) -> bool:
    return ((after.at - before.at) / turn).real - before.length > _WORDS * size


# What each may say without any effect; editors write many of them so.
_IDLE = {
    **dict.fromkeys(("stroke-dashoffset", "letter-spacing", "word-spacing"), ("0", "0px", "normal")),
    **dict.fromkeys(("marker", "marker-start", "marker-mid", "marker-end"), ("none",)),
    **dict.fromkeys(("vector-effect", "mask-image", "text-decoration"), ("none",)),
    **dict.fromkeys(("mix-blend-mode", "paint-order", "font-variant", "font-stretch"), ("normal",)),
    "font-weight": ("normal", "400"),
    **dict.fromkeys(("baseline-shift", "dominant-baseline", "alignment-baseline"), ("baseline", "auto", "0")),
    "writing-mode": ("lr-tb", "lr", "horizontal-tb"),
    "content-visibility": ("visible",),
    "stroke-linejoin": ("round",),  # a pen draws all its corners so
    "clip": ("auto",),
    "all": (),
}
# Attributes on which it depends whether an element is shown at all, or how long its dashes are.
_NEVER = ("systemLanguage", "requiredExtensions", "pathLength", "rotate")
_MADE = ("var(", "env(", "attr(", "calc(")  # what a viewer works out
_FOREIGN = "-webkit-"


@lru_cache(maxsize=1024)
def effect(said: Said) -> str:
    """Name a property of an element that changes what is seen of it and is not followed; "" if there is none.

    >>> effect((("stroke-dashoffset", "0"), ("style", "mix-blend-mode:screen; -webkit-filter: blur(9px)")))
    'mix-blend-mode'
    """
    style = declarations(said)
    fault = next((name for name in _NEVER if name in dict(said)), "") or unfollowed(style)
    others = ((name, text) for name, text in (*said, *style.items()) if name != "style")
    return fault or next((name for name, text in others if not _idle(name, text.strip(SPACE).lower())), "")


def _idle(name: str, value: str) -> bool:
    """Tell whether a property is followed, or has no effect."""
    if name.startswith(_FOREIGN):
        return value in ("none", "normal", "auto")
    return value in _IDLE.get(name, (value,)) and not ("(" in value and any(made in value for made in _MADE))


# What draws by other means than lines and letters, or decides how they look: the eye cannot read it.
UNREAD = frozenset(("use", "image", "foreignObject", "style", "script", "switch", "pattern", "marker", "tspan"))
PLAIN = LineInk(INK)


@lru_cache(maxsize=1024)  # thousands of elements share a dozen frames
def unread(frame: Nest) -> str:
    """Name what of an element the eye cannot read; "" if there is nothing."""
    if frame.tag in UNREAD or frame.tag == "svg":
        return f"<{frame.tag}>"
    fault = effect(frame.said) if frame.tag else ""
    return fault and f"<{frame.tag} {fault}>"


@lru_cache(maxsize=1024)
def ink_of(frame: Nest) -> LineInk:
    """Give the ink of an element."""
    return ink(frame.look, scale_of(frame.to_paper))


UNPAINTED = ("hidden", "clipped")  # why a stroke is unseen that hides nothing itself
_SAID = "data-text"


class Opened:
    """An element that has begun, and what was seen in it."""

    __slots__ = ("attributes", "data", "frame", "heard", "ink", "letters", "strokes", "title")

    def __init__(self, frame: Nest, attributes: Mapping[str, str]) -> None:
        self.frame, self.attributes, self.title, self.ink = frame, attributes, "", PLAIN
        self.strokes: list[Stroke] = []
        self.data: dict[str, str] = {}
        self.heard: list[str] = []
        self.letters: list[PathLetters | Typeset] = []


class Observer:
    """Sees the elements of a sheet one by one."""

    def __init__(self) -> None:
        self.open: list[Opened] = []
        self.unseen: list[Unseen] = []
        self.clear: set[int] = set()  # strokes, by their ids, whose filling hides nothing
        self.gone: set[int] = set()  # and those that are not painted at all
        self.description, self.lettering = "", "strokes"
        self.paper = Viewport(0.0, 0.0, STAY, ())
        self.begun: PathLetters | None = None  # the letters of the text that was written last
        self.root = Opened(Nest("svg", STAY, Look(), None), {})

    def opened(self, attributes: Mapping[str, str]) -> Viewport:
        """See the paper that a root lays what is drawn on."""
        self.paper = viewport(attributes)
        return self.paper

    def enter(self, frame: Nest, attributes: Mapping[str, str]) -> None:
        """See an element begin."""
        element = Opened(frame, attributes)
        self.open.append(element)
        if len(self.open) == 1:
            self.root = element
        elif what := unread(frame):
            self._leave_aside(what)
        if frame.tag in SHAPES:
            try:
                if not self._letter(element, ink := ink_of(frame)):
                    self._line(element, ink)
            except SheetRefused:
                self._leave_aside(f"<{frame.tag}>")

    def hear(self, text: str) -> None:
        """Take the characters within the innermost element."""
        if self.open:
            self.open[-1].heard.append(text)

    def leave(self) -> None:
        """See the innermost element end."""
        element = self.open.pop()
        if element.frame.tag in SHAPES and not element.strokes:
            return
        match element.frame.tag:
            case "g":
                self._close(element)
            case "text":
                self._typeset(element)
            case "title" if self.open:
                self.open[-1].title = "".join(element.heard)
            case "desc" if len(self.open) == 1:
                self.description = "".join(element.heard)
            case _ if element.strokes and self.open:  # a link, or what no viewer knows
                self._close(element)

    def _line(self, element: Opened, ink: LineInk) -> None:
        outline = outlines(element.frame.tag, element.attributes, element.frame.to_paper, ink.style)
        strokes = tuple(map(cornered, outline))
        outer = self.open[-2]
        data = _data(element.attributes) if element.attributes.get("data-kind") in KINDS else {}
        if not data:
            self._add(outer, strokes, ink)
        elif outer.frame.tag == "g" and not outer.strokes and not outer.data:
            outer.data = data
            self._add(outer, strokes, ink)
        else:
            self._add(outer, (Group(strokes, element.attributes.get("id", ""), data),), ink)

    def _letter(self, element: Opened, ink: LineInk) -> bool:
        """Take a path as letters, if it is one of them; those of several pens are one text with its levels."""
        path, outer = element.attributes.get("d", ""), self.open[-2]
        if element.frame.tag != "path" or not path or not pen_of_letters(ink.style):
            return False
        said = element.attributes.get(_SAID, outer.attributes.get(_SAID))
        letters = plain_letters(path, element.frame.to_paper, ink.style)
        if letters is None:
            letters = any_letters(path, element.frame.to_paper, ink.style)
        if letters is None or (said is None and not all(glyph.known for glyph in letters.glyphs)):
            return False
        if _SAID in outer.attributes:
            outer.letters.append(letters)
            outer.ink = ink if ink.unseen or not outer.ink.unseen else outer.ink
        elif said is not None or not self._goes_on(outer, letters, ink):
            self._add(outer, (written([letters], said or "", _penned(ink.style)),), ink)
            self.begun = letters
        return True

    def _goes_on(self, outer: Opened, letters: PathLetters, ink: LineInk) -> bool:
        """Take letters of a finer pen as the levels of the text before them, whose group an editor has dissolved."""
        last = outer.strokes[-1] if outer.strokes else None
        if not isinstance(last, Text) or self.begun is None or letters.unit >= self.begun.unit or ink.unseen:
            return False
        whole = written([self.begun, letters], "", _penned(ink.style))
        if NO_LETTER in whole.plain:
            return False
        outer.strokes[-1], self.begun = whole, None
        return True

    def _typeset(self, element: Opened) -> None:
        plain, outer = "".join(element.heard), self.open[-1]
        if not plain.strip():
            return
        try:
            shown = ink(element.frame.look, 1.0)
            part = typeset(plain, element.frame.to_paper, element.frame.look, element.attributes)
        except SheetRefused:
            self._leave_aside(f"<{element.frame.tag}>")
            return
        self.lettering = "text"
        if _SAID in outer.attributes and outer.frame.tag == "g":
            outer.letters.append(part)
            outer.ink = shown
        else:
            self._add(outer, (joined([part], plain, _filled(shown.style.fill)),), shown)

    def _close(self, element: Opened) -> None:
        """Take a group: a text of several pens or sizes, or what holds others."""
        outer = self.open[-1]
        if text := _text(element):
            self._add(outer, (text,), element.ink)
        name, data = element.attributes.get("id", ""), element.data or _data(element.attributes)
        group = Group(tuple(element.strokes), name, data, element.title)
        if group.strokes or group.name or group.data or group.title:
            outer.strokes.append(group)

    def _add(self, outer: Opened, strokes: tuple[Stroke, ...], ink: LineInk) -> None:
        outer.strokes += strokes
        if ink.clear:
            self.clear.update(id(part) for part in flat(strokes))
        if ink.unseen in UNPAINTED:
            self.gone.update(id(part) for part in flat(strokes))
        if ink.unseen:
            self.unseen += [Unseen(stroke, ink.unseen, self._group) for stroke in strokes]

    def _leave_aside(self, what: str) -> None:
        self.unseen.append(Unseen(Text(0j, (Run(what),)), "unread", self._group))

    @property
    def _group(self) -> str:
        return next((name for element in reversed(self.open[1:]) if (name := element.attributes.get("id", ""))), "")


def _text(element: Opened) -> Text | None:
    if not element.letters:
        return None
    said, style = element.attributes.get(_SAID, ""), element.ink.style
    if typed := [part for part in element.letters if isinstance(part, Typeset)]:
        return joined(typed, said, _filled(style.fill))
    return written([part for part in element.letters if isinstance(part, PathLetters)], said, _penned(style))


def _penned(style: LineStyle) -> LineStyle:
    """Give the ink of letters that are drawn with a pen, whose corners are seen."""
    plain = _filled(style.colour)
    return plain if style.join == plain.join else plain._replace(join=style.join)


def _filled(colour: str) -> LineStyle:
    return INK if colour == INK.fill else INK._replace(fill=colour)


def _data(attributes: Mapping[str, str]) -> dict[str, str]:
    return {name[5:]: text for name, text in attributes.items() if name.startswith("data-") and name != _SAID}


class SeenSheet(NamedTuple):
    """What an eye sees of a sheet, what it does not, and all that is written, seen or not."""

    leaf: Leaf
    unseen: tuple[Unseen, ...]
    written: Leaf
    measured: Measured


def see(source: bytes, observer: Observer | None = None) -> SeenSheet:
    """See a written sheet, and measure it: it is read once for both."""
    observer = observer or Observer()
    measured = measure(source, observer)
    root = observer.root
    groups = _unwrapped(tuple(stroke if isinstance(stroke, Group) else Group((stroke,)) for stroke in root.strokes))
    data = {key: value for key, value in measured.metadata.items() if key != "format"}
    paper = observer.paper
    whole = Leaf(paper.width, paper.height, groups, root.title, observer.description, data, observer.lettering)
    gone = {id(lost.stroke) for lost in observer.unseen}
    under = (lost for lost in veiled(whole, observer.clear, observer.gone) if id(lost.stroke) not in gone)
    unseen = (*observer.unseen, *under)
    return SeenSheet(without(whole, [lost.stroke for lost in unseen]), unseen, whole, measured)


def uncovered(leaf: Leaf) -> Leaf:
    """Give a leaf without what is covered or off the paper."""
    return without(leaf, [lost.stroke for lost in veiled(leaf)])


def without(leaf: Leaf, strokes: Iterable[Stroke]) -> Leaf:
    """Give a leaf without some of its strokes."""
    hidden = {id(stroke) for stroke in strokes}
    return leaf._replace(groups=tuple(_kept(group, hidden) for group in leaf.groups)) if hidden else leaf


def ungiven(leaf: Leaf) -> Leaf:
    """Give a leaf without the lines of the figures that are a part of its task."""
    return without(leaf, flat(group for group in groups(leaf.groups) if group.data.get("kind") == GIVEN))


def _unwrapped(groups: tuple[Group, ...]) -> tuple[Group, ...]:
    """Take what an editor has put into one layer out of it."""
    while len(groups) == 1 and not groups[0].data and groups[0].strokes:
        inside = tuple(stroke for stroke in groups[0].strokes if isinstance(stroke, Group))
        if len(inside) < len(groups[0].strokes):
            break
        groups = inside
    return groups


def _kept(group: Group, hidden: Collection[int]) -> Group:
    left = (child for child in group.strokes if id(child) not in hidden)
    return group._replace(strokes=tuple(_kept(child, hidden) if isinstance(child, Group) else child for child in left))
