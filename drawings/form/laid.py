"""What stands on a laid sheet that a form may take over (лист): its figures with their headings, its tables with heads.

A laid sheet has the answer on it. What is read here is a figure's name, title, pole and rough size, and a table's heads
and rows; no line and no cell of it goes any further.
"""

from __future__ import annotations

import math
import re
import tomllib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from decimal import Decimal
from itertools import chain
from types import MappingProxyType
from typing import Any, Final, NamedTuple

from drawings.layout.table import RuledTable, TableRow
from drawings.layout.table import table as ruled
from drawings.layout.value_table import BOTH, COLUMNS
from drawings.lettering.lettering import bounds
from drawings.lettering.words import WRITTEN, decimal, numerals, verbatim, with_index, word
from drawings.page.page import Drafting, Scale
from drawings.paper.strokes import Circle, Group, Leaf, Stroke, Text
from drawings.paper.walk import flat, groups
from drawings.sheets.kind import FRAME, PLAN, figure_of, table_of
from plans.scene.scene import Scene
from plans.techniques import techniques
from plans.words.words import words

NUMERAL = re.compile(WRITTEN)
TOLD = 3  # digits: a number of fewer counts or names something, and tells no value
QUANTITY = re.compile(r"-?\d+(?:\.\d+)?\s*(?:[^\W\d_][^-_^{}\\]*|[°%]|$)")  # as a scene writes it: "340 N*m"
SIGNS = str.maketrans("-*", "−·")
INDEXED = re.compile(r"[^\W\d_]+_[^\W_]+")  # a letter with its index: "F_g"
SKETCH = "sketch"  # where points lie about is what the plan of positions has to find
# Degrees of two turns, or mm of a plate, by which the rows of a table count, though no scene gives them.
TURN = "360"  # positions that a turn is looked through in, as heads of tables say
GIVEN_STEPS: Final = frozenset(2.5 * step for step in range(289))
# What a number of a scene is written in: its own unit, a thousandth or a thousand of it; degrees; turns a minute.
UNITS: Final = tuple(
    power * turn for power in (1.0, 1e3, 1e-3) for turn in (1.0, math.pi / 180, 180 / math.pi, math.pi / 30)
)


class Given(NamedTuple):
    """The numbers of a scene in all the units that they may be written in."""

    numbers: tuple[float, ...]

    def says(self, text: str) -> bool:
        """Tell whether a text writes no other number than given ones: what else has digits may be an answer.

        >>> Given((0.12,)).says("l = 0.120 m, position 2"), Given((0.12,)).says("v = 0.124 m/s")
        (True, False)
        >>> Given(()).says("215"), Given(()).says("φ = 215°"), Given(()).says("R = 215 N")
        (True, True, False)
        >>> Given(()).says("Largest of 360 positions")
        True
        """
        return all(self._knows(numeral[0]) or _counts(numeral) for numeral in NUMERAL.finditer(text))

    def _knows(self, numeral: str) -> bool:
        digits, _, power = numerals(numeral).partition("e")
        if len(digits.replace(".", "").lstrip("0")) < TOLD and "." not in digits and not power:
            return True
        half = 0.5 * 10.0 ** (int(power or 0) - len(digits.partition(".")[2]))
        return any(abs(abs(number) - float(numerals(numeral))) <= half for number in self.numbers)


def _counts(numeral: re.Match[str]) -> bool:
    """Tell whether a number is by what the rows of a table count: the name of a row alone, or degrees."""
    alone = numeral[0] == numeral.string.strip()
    degrees = numeral.string[numeral.end() :].lstrip().startswith("°")
    return numeral[0] == TURN or ((alone or degrees) and float(numerals(numeral[0])) in GIVEN_STEPS)


def given(scene: Scene) -> Given:
    """Gather the numbers of a scene."""
    numbers = {abs(number) for number in _numbers(tomllib.loads(_text(scene)))}
    return Given((*sorted({number * unit for number in numbers for unit in UNITS}), *_numbers(_rules(scene))))


def data(scene: Scene) -> list[str]:
    """Write the tables of a scene's techniques as a task in words: what each table is of, and each key in it."""
    tables, language = tomllib.loads(_text(scene)), scene.sheet.language
    known = techniques()
    names = dict.fromkeys(name for technique in scene.techniques for name in known[technique].tables)
    lines = [line for name in names if name in tables for line in _lines(name, tables[name], language)]
    return [word(language, "form given"), *lines, *_rules(scene)]


def _rules(scene: Scene) -> list[str]:
    """Tell what is usual in a technique where the scene does not give it."""
    language, known = scene.sheet.language, words(scene.sheet.language)
    return [word(language, f"form {one}") for one in scene.techniques if f"sheet.form {one}" in known]


def _text(scene: Scene) -> str:
    return scene.content.decode("utf-8-sig")


def _lines(name: str, value: Any, language: str) -> Iterator[str]:
    """Write a table in one paragraph, and each table within it in one of its own."""
    for row in value if isinstance(value, list) else [value]:
        inner = {key: entry for key, entry in row.items() if _is_table(entry)}
        plain = {key: entry for key, entry in row.items() if key not in inner}
        if plain:
            said = ", ".join(_said(f"{name}.{key}", entry, language) for key, entry in plain.items())
            yield f"{_worded('form_table', name, language)}: {said}"
        for key, entry in inner.items():
            if key != SKETCH:
                yield from _lines(f"{name}.{key}", entry, language)


def _is_table(value: Any) -> bool:
    rows = value if isinstance(value, list) else [value]
    return bool(rows) and all(isinstance(row, dict) for row in rows)


def _worded(of: str, name: str, language: str) -> str:
    path, _, last = name.rpartition(".")
    known = words(language)
    phrase = next((known[key] for key in (f"{of}.{name}", f"{of}.{path}.*", f"{of}.{last}") if key in known), None)
    if phrase is not None:
        return str(phrase).format(name=last)
    return last if INDEXED.fullmatch(last) else verbatim(last.replace("_", " "))


def _said(key: str, value: Any, language: str) -> str:
    """Word a key with its value; one that holds or not by itself."""
    name, key = key, key.rpartition(".")[2]
    own = key == "name" and f"form_value.{value}" not in words(language)  # of a cam, whatever it looks like
    joined = verbatim(value) if own else _written(value, language)
    joined = f"({joined})" if isinstance(value, dict | list) else joined
    if value is True:
        return _worded("form_key", name, language)
    if key[:1].isupper() or key[:1].isdigit():  # the name of a point, or the number of a link
        return f"{key} {joined}" if isinstance(value, list | dict) else f"{key} = {joined}"
    return f"{_worded('form_key', name, language)} {joined}"


def _written(value: Any, language: str) -> str:
    match value:
        case dict():
            return ", ".join(_said(key, entry, language) for key, entry in value.items())
        case list():
            return "; ".join(_written(entry, language) for entry in value)
        case bool():
            return str(words(language)["form_value.yes" if value else "form_value.no"])
        case str():
            said = str(words(language).get(f"form_value.{value}", value))
            if QUANTITY.fullmatch(said):
                return _lettered(said, language)
            return said if INDEXED.fullmatch(said) else verbatim(said)
    return _lettered(f"{Decimal(repr(value)):f}", language)  # no power of ten: it would be read as two numbers


def _lettered(quantity: str, language: str) -> str:
    """Write a number of a scene, with the unit that it has there, as sheets write numbers."""
    return decimal(quantity.translate(SIGNS), language)


def _numbers(value: Any) -> Iterator[float]:
    """Give all numbers that stand in a value, in its texts too."""
    match value:
        case bool():
            return
        case int() | float():
            yield float(value)
        case str():
            yield from (float(numerals(numeral)) for numeral in NUMERAL.findall(value))
        case dict() | list():
            inner: Iterable[Any] = [*value.values(), *value] if isinstance(value, dict) else value
            for part in inner:
                yield from _numbers(part)


SCALE = re.compile(rf"([μK]_?(\{{[^{{}}]*\}}|[^\s=]+))(\s*=\s*){WRITTEN}(\s*(?:\([^()]*\)|1)?[^\d;()]*)")
LETTER = re.compile(r"[^\W\d]{1,2}['’ʹ]{0,2}(, \D*(1/\D+)?)?")  # of an axis, with its unit: no number, no name
VALUED = re.compile(r"=|(^|\s)\d")  # of what no vector is lettered by: a dimension, the ray of an angle
STEPS = (1.0, 1.5, 2.0, 3.0, 5.0, 7.0, 10.0)  # the sizes of places within each power of ten: the next one is taken
CENTRED = 0  # parts of a place whose pole stands in its middle, so that what shows the wrong way fits too
PARTS = 4  # of the size of a place: so coarsely is its pole set in it
ROUNDING = 1e-9  # of a length: no two of these steps lie so near


class Heading(NamedTuple):
    """The title of a figure and the line under it, marked up."""

    title: str
    under: str


class LaidFigure(NamedTuple):
    """A figure of the task: what it is, its heading, its pole's data, letter and unit of its scale, its place.

    `of` is the plan and position that its marks are of. `reach` is how far the place goes from the pole to the left,
    down, right and up, in true units, rounded up coarsely.
    """

    name: str
    what: str
    heading: Heading
    pole: Mapping[str, str]
    letter: str
    unit: str
    reach: tuple[float, float, float, float]
    axes: tuple[str, ...]  # the letters of a graph's ordinate and abscissa
    of: Mapping[str, str]
    arrows: tuple[str, ...] = ()  # the vectors that are asked for there, by their letters
    times: float = 1.0  # what its marks measure over what it is laid out by: velocities over heights
    rays: Mapping[str, str] = MappingProxyType({})  # the data of a second pole, that of rays

    def marked(self, scale: Scale) -> Scale:
        """Give the scale of its marks where it is laid out at some scale."""
        return scale if self.times == 1 else Scale(float(f"{scale.mu * self.times:.12g}"), self.letter, self.unit)

    @property
    def scales(self) -> tuple[str, ...]:
        """The scales of a graph with their letters and units, and no numbers."""
        found = (f"{mark}{equals}……{unit}".strip() for mark, _, equals, unit in SCALE.findall(self.heading.under))
        return tuple(dict.fromkeys(found))


class LaidTable(NamedTuple):
    """The heads of a table: positions of its bands, head of its names, of the columns of a band, names of its rows."""

    name: str
    positions: tuple[int, ...]
    first: str
    heads: tuple[str, ...]
    rows: tuple[str, ...]
    text: float


def figures(leaf: Leaf, kind: str, known: Given, parts: int = PARTS) -> Iterator[LaidFigure]:
    """Give the figures of a laid sheet that are known as places of the task, and whose titles say nothing else."""
    pending: Heading | None = None
    for group in leaf.groups:
        if (found := _heading(group)) is not None:
            pending = found
            continue
        what = figure_of(kind, group.name) if group.name else ""
        inner = (_heading(found) for found in groups(group.strokes))
        heading, pending = next((found for found in inner if found is not None), pending), None
        if what and heading is not None and known.says(heading.title):
            yield from _figure(group, what, heading, parts, leaf.metadata.get("scales", {}))


def tables(leaf: Leaf, kind: str, known: Given) -> Iterator[LaidTable]:
    """Give the tables of a laid sheet that are known as parts of the task, band by band."""
    for group in groups(leaf.groups):
        name = table_of(kind, group.name) if group.name else ""
        texts = [text for inner in groups(group.strokes) for text in inner.strokes if isinstance(text, Text)]
        if name and texts:
            yield _table(name, tuple(map(int, group.data.get("positions", "").split())), texts, known)


def _heading(group: Group) -> Heading | None:
    """Read a group as a heading: two lines or more that begin alike, the first of them larger."""
    strokes = list(flat(group.strokes))  # a line that states a number is a group of its own
    texts = [stroke for stroke in strokes if isinstance(stroke, Text)]
    if group.name or group.data or len(texts) != len(strokes) or len(texts) < 2:
        return None
    title, under = texts[:2]
    return None if title.anchor != under.anchor or title.size <= under.size else Heading(_marked(title), _marked(under))


def _figure(group: Group, what: str, heading: Heading, parts: int, scales: Mapping[str, float]) -> Iterator[LaidFigure]:
    marks = [mark for mark in groups(group.strokes) if "scale" in mark.data]
    poles = [mark for mark in marks if mark.data["kind"] == "pole"]
    scale = SCALE.search(heading.under)
    ink = [stroke for stroke in flat(group.strokes) if not isinstance(stroke, Text)]
    if not ink or not marks or scale is None:
        return
    data, pole = (poles or marks)[0].data, poles[0].data if poles else {}
    at, mu = _centre(poles[0]) if poles else None, float(data["scale"])
    laid = scales.get(group.name, mu) if ";" in heading.under else mu
    settled = parts == CENTRED and (what == FRAME or laid != mu)
    reach = _reach(ink, at, laid, PARTS if settled else parts)
    level = ((text, "".join(run.text for run in text.runs if not run.level)) for text in _loose(group))
    lettered = [text for text, own in level if LETTER.fullmatch(own)][:2]
    axes = tuple(map(_marked, sorted(lettered, key=lambda text: text.at.real)))  # of the ordinate stands further left
    of = {key: data[key] for key in ("plan", "position") if key in data}
    vectors = (mark for mark in marks if mark.data["kind"] == "vector")
    names = ((mark.data["name"], mark.title) for mark in vectors if not VALUED.search(mark.title or mark.data["name"]))
    # One that is lettered itself has a title
    letters = (title if title and " " not in name else with_index(name.replace(" ", "")) for name, title in names)
    laid_out = (scale[2], data["unit"], reach, axes, of, tuple(sorted(set(letters))), mu / laid)
    yield LaidFigure(group.name, what, heading, pole, *laid_out, poles[1].data if len(poles) > 1 else {})


def asked(places: Iterable[LaidFigure], bands: Iterable[LaidTable], language: str) -> Iterator[str]:
    """Say which arrows are asked for in the places of plans, and what the columns of a table are for."""
    named: dict[tuple[str, tuple[str, ...]], list[str]] = {}  # the positions of a plan with the same arrows
    for place in places:
        if place.what == PLAN and place.arrows:
            plan, comma, position = place.heading.title.rpartition(", ")
            named.setdefault((plan + comma, place.arrows), []).append(position)
    for (plan, arrows), positions in named.items():
        yield word(language, "form arrows", plan=plan + "; ".join(positions), arrows=", ".join(arrows))
    roads = tuple(word(language, road) for road in ("by plan", "by analysis"))
    if any(set(roads) <= set(band.heads) for band in bands):
        yield word(language, "form columns", plan=roads[0], analysis=roads[1])


def _loose(group: Group) -> list[Text]:
    """Give the letters of a figure that stand in its own groups, the headings left out."""
    own = (stroke for stroke in group.strokes if isinstance(stroke, Group) and not stroke.data)
    return [text for part in own if _heading(part) is None for text in part.strokes if isinstance(text, Text)]


def _centre(pole: Group) -> complex:
    circle = pole.strokes[0]
    assert isinstance(circle, Circle)  # a pole is measured by it
    return circle.centre


def _reach(ink: Sequence[Stroke], at: complex | None, mu: float, parts: int) -> tuple[float, float, float, float]:
    """Give how far strokes reach from a point, or from their middle, in true units, rounded up coarsely."""
    left, low, right, high = bounds(Group(tuple(ink)))
    at = complex(left + right, low + high) / 2 if at is None else at
    far = [max(reach, 0.0) * mu for reach in (at.real - left, at.imag - low, right - at.real, high - at.imag)]
    return coarse(far, parts)


def coarse(far: Sequence[float], parts: int = PARTS) -> tuple[float, float, float, float]:
    """Round lengths up to a part of their largest one, and that to the next step; of finer parts to one of these.

    >>> coarse((0.0, 1.1, 2.6, 2.9)), coarse((0.0, 1.1, 2.6, 3.1)), coarse((0.0, 1.1, 2.6, 3.1), 10)
    ((0.75, 1.5, 3.0, 3.0), (1.25, 1.25, 3.75, 3.75), (0.31, 1.24, 2.79, 3.1))
    """
    largest = max(far)
    if largest <= 0:
        return 1.0, 1.0, 1.0, 1.0
    if parts == CENTRED:
        across, up = max(far[0], far[2]), max(far[1], far[3])
        return coarse((across, up, across, up))
    power = 10.0 ** math.floor(math.log10(largest))
    steps = STEPS if parts == PARTS else [1 + k / parts for k in range(9 * parts + 1)]
    size = next(step * power for step in steps if step * power >= largest * (1 - ROUNDING))
    left, low, right, high = (max(math.ceil(parts * reach / size * (1 - ROUNDING)), 1) * size / parts for reach in far)
    return left, low, right, high


def _table(name: str, positions: tuple[int, ...], texts: Sequence[Text], known: Given) -> LaidTable:
    """Read heads and rows: the heads stand before the first row, whose name begins at its left."""
    count = next((k for k, text in enumerate(texts) if text.anchor == "start"), len(texts))
    head, bands = texts[:count], max(len(positions), 1)
    columns = (count - 1) // bands
    heads = [text for text in head[1 : 1 + columns][1 if positions else 0 :] if known.says(text.plain)]
    rows = (text for text in texts[count:] if text.anchor == "start")
    said = tuple(_marked(row) if known.says(row.plain) else "" for row in rows)
    return LaidTable(name, positions, _marked(head[0]), tuple(map(_marked, heads)), said, head[0].size)


def _marked(text: Text) -> str:
    if isinstance(text.content, str):
        return text.content
    marks = {-1: "_{%s}", 0: "%s", 1: "^{%s}"}
    return "".join(marks[run.level] % run.text for run in text.content)


# Columns of a sheet that tell how far a value may be out: a form asks for no such thing.
BESIDE = ("drawing error", "true error")


def blank(bands: Iterable[LaidTable], drafting: Drafting) -> tuple[RuledTable, ...]:
    """Give the tables of a set of sheets, each whole: the bands and parts in which it was set put together."""
    parts: dict[str, list[LaidTable]] = {}
    for band in bands:
        parts.setdefault(band.name, []).append(band)
    return tuple(_whole(name, parts, drafting) for name, parts in parts.items())


def _whole(name: str, parts: list[LaidTable], drafting: Drafting) -> RuledTable:
    positions = tuple(dict.fromkeys(position for part in parts for position in part.positions))
    rows = dict.fromkeys(row for part in parts for row in part.rows if row)
    first, beside = parts[0], [drafting.word(key) for key in BESIDE]
    both, apart = drafting.word(BOTH), tuple(map(drafting.word, COLUMNS[:2]))
    split = (apart if head == both else (head,) for head in first.heads if head not in beside)
    heads = tuple(chain(*split))
    cells = ("",) * (len(heads) * max(len(positions), 1))
    lines = [TableRow(row, cells) for row in rows]
    return ruled(lines, first.first, heads, first.text, positions)._replace(name=name)
