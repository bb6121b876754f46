"""A walk over the strokes of a sheet, and ties of a layout broken by a margin (обход линий)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from drawings.paper.strokes import Group, Leaf, Statement, Stroke, Text


def walk(strokes: Iterable[Stroke]) -> Iterator[Stroke]:
    """Give strokes in their order from back to front, each group before what it holds.

    >>> [type(stroke).__name__ for stroke in walk([Group((Text(0j, "A"),))])]
    ['Group', 'Text']
    """
    left = [*strokes][::-1]
    while left:
        stroke = left.pop()
        yield stroke
        if isinstance(stroke, Group):
            left += stroke.strokes[::-1]


def flat(strokes: Iterable[Stroke]) -> Iterator[Stroke]:
    """Give the strokes that ink the paper: all but the groups."""
    return (stroke for stroke in walk(strokes) if not isinstance(stroke, Group))


def groups(strokes: Iterable[Stroke]) -> Iterator[Group]:
    """Give the groups, each before those within it."""
    left = [stroke for stroke in strokes if isinstance(stroke, Group)][::-1]
    while left:
        group = left.pop()
        yield group
        left += [stroke for stroke in group.strokes[::-1] if isinstance(stroke, Group)]


def group_named(strokes: Iterable[Stroke], name: str) -> Group | None:
    """Give the first group of a name, if there is one."""
    return next((group for group in groups(strokes) if group.name == name), None)


def texts(strokes: Iterable[Stroke]) -> Iterator[Text]:
    """Give the lettering."""
    return (stroke for stroke in walk(strokes) if isinstance(stroke, Text))


def stating(statement: Statement, *strokes: Stroke) -> Group:
    """Give strokes as what they state."""
    return Group(strokes, states=statement)


def stated(strokes: Iterable[Stroke]) -> Iterator[Group]:
    """Give the groups that state something, each before those within it."""
    return (group for group in groups(strokes) if group.states is not None)


def unstated(leaf: Leaf) -> Leaf:
    """Give a leaf as it is written: what does nothing but state is its strokes alone.

    >>> from drawings.paper.strokes import Kind
    >>> cell = stating(Statement(Kind.NUMBER, "table", "m"), Text(0j, "1"))
    >>> unstated(Leaf(1, 1, (Group((cell,), "table"),))).groups == (Group((Text(0j, "1"),), "table"),)
    True
    """
    return leaf._replace(
        groups=tuple(stroke for group in leaf.groups for stroke in _written(group) if isinstance(stroke, Group))
    )


def _written(stroke: Stroke) -> Iterator[Stroke]:
    if not isinstance(stroke, Group):
        yield stroke
        return
    strokes = (inner for part in stroke.strokes for inner in _written(part))
    if stroke.states is not None and not (stroke.name or stroke.data or stroke.title):
        yield from strokes
    else:
        yield Group(tuple(strokes), stroke.name, stroke.data, stroke.title)


PLACES = 6
# Far over what the last bits of a processor make of millimetres, 1e-12, and far under what is seen of them, 1e-3.
MARGIN = 10.0**-PLACES


def tied(value: float) -> float:
    """Give what a value counts in a choice, mm or a share: of those that are tied the first is taken.

    >>> min((0.3, 0.1 + 0.2 - 1e-12), key=tied), tied(-1e-12)
    (0.3, 0.0)
    """
    return round(value, PLACES) + 0.0


def tied_spot(value: complex) -> complex:
    """Give what a place or a way counts in a choice: one straight to the left has no lean up or down.

    >>> tied_spot(-2 - 1e-15j)
    (-2+0j)
    """
    return complex(tied(value.real), tied(value.imag))


def apart(spots: Iterable[complex]) -> Iterable[complex]:
    """Give places in their order, of those that are tied the first.

    >>> list(apart([1j, 2j, 1j + 1e-12]))
    [1j, 2j]
    """
    found: dict[complex, complex] = {}
    for spot in spots:
        found.setdefault(tied_spot(spot), spot)
    return found.values()
