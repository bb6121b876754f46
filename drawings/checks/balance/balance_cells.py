"""The self-check of the tables of balancing: counterweights with their sizes, what they change (проверка таблиц)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from drawings.checks import reading
from drawings.checks.balance.balance_expected import Expected
from drawings.checks.documents_old import ruled
from drawings.checks.precise import KNOWN
from drawings.checks.wrong import Wrong, within
from drawings.figures.balance.balance_table import COSTS, DIGITS, NONE, PLACES, SHARE_DIGITS, WEIGHTS
from drawings.lettering.balance_letters import FORCE, MOMENT, counterweight
from drawings.lettering.indices import with_index
from drawings.paper.strokes import Group, Leaf, Text
from drawings.paper.walk import groups
from plans.balance.weights import line_of
from plans.forces.cut import indices
from plans.forces.primary import BALANCING
from plans.model.balance.linkage import DISC, Counterweight, State

MILLIMETRES = 1000.0
TURN = 360.0


class Number(NamedTuple):
    """A number that a cell must say, with how far it may be off beside its last digit."""

    true: float
    slack: float
    turns: bool = False  # whether whole turns are left aside

    def holds(self, text: str) -> bool:
        """Tell whether a text says it."""
        found = reading.value(text)
        if found is None:
            return False
        turned = TURN * round((found - self.true) / TURN) if self.turns else 0.0
        return reading.reads(text, self.true + turned, self.slack + KNOWN * abs(self.true), DIGITS)


class Change(NamedTuple):
    """A change in per cent that a cell must say, with its sign."""

    true: float

    def holds(self, text: str) -> bool:
        """Tell whether a text says it."""
        signed = text.startswith("+") == (round(self.true, PLACES) > 0)
        lost = 0.5 * 10.0**-PLACES + 100 * KNOWN
        return signed and reading.reads(text.removeprefix("+"), self.true, lost, SHARE_DIGITS)


class Said(NamedTuple):
    """Words that a cell must say."""

    text: str

    def holds(self, text: str) -> bool:
        """Tell whether a text says them."""
        return text == Text(0j, self.text).plain


Cell = Number | Change | Said


def weights(leaf: Leaf, expected: Expected) -> Iterator[Wrong]:
    """Read the table of counterweights back."""
    language = expected.drafting.language
    rows = {counterweight(one.link, language): _weight(one, expected) for one in expected.balance.counterweights}
    word = expected.drafting.word
    mm = word("mm")
    heads = (
        word("counterweight column"), f"m·a, {word('kg*m')}", f"m, {word('kg')}", word("from"),
        f"a, {mm}", "∠, °", word("shape"), f"R, {mm}", f"b, {mm}",
    )  # fmt: skip
    yield from _table(leaf, WEIGHTS, heads, rows)


def _weight(one: Counterweight, expected: Expected) -> list[Cell]:
    if not one.needed:
        return [Said("0"), Said("0"), *(Said(NONE) for _ in range(6))]
    slacks = [expected.slack(f"{letter}{one.link}", "counterweights") for letter in ("U_", "m_cw", "r_cw")]
    turned = one.moment / line_of(expected.mechanism, one.link, one.begin)
    angle = Number(math.degrees(cmath.phase(turned)), math.degrees(slacks[0] / abs(one.moment) + KNOWN), turns=True)
    sector = expected.drafting.number(math.degrees(2 * one.place.half_angle))
    shape = (
        expected.drafting.word("disc") if one.place.shape == DISC else expected.drafting.word("sector", angle=sector)
    )
    outer = MILLIMETRES * one.outer
    return [
        Number(abs(one.moment), slacks[0]), Number(one.mass, slacks[1]), Said(one.begin),
        Number(MILLIMETRES * one.distance, MILLIMETRES * slacks[2]), angle, Said(shape),
        Number(outer, outer * slacks[1] / one.mass), Number(MILLIMETRES * one.place.thickness, 0.0),
    ]  # fmt: skip


def costs(leaf: Leaf, expected: Expected) -> Iterator[Wrong]:
    """Read the table of what is largest before and after back."""
    word, after = expected.drafting.word, expected.after
    keys = ("before column", *(("after column", "change column") if after is not None else ()))
    heads = word("largest value", count=expected.balance.before.count), *map(word, keys)
    was = dict(_largest(expected, expected.balance.before))
    now = {} if after is None else dict(_largest(expected, after))
    rows = {name: _change(value, now.get(name)) for name, value in was.items()}
    yield from _table(leaf, COSTS, heads, rows)


def _largest(expected: Expected, state: State) -> Iterator[tuple[str, float]]:
    """Give what is largest of a state by the names of the rows; what is nothing is 0."""
    none, word = expected.none, expected.drafting.word
    yield word("path of S", unit=word("mm")), MILLIMETRES * _rounded(state.path, none.way)
    yield f"{FORCE}, {word('N')}", _rounded(state.shaking, none.force)
    shaft = expected.mechanism.drive.pivot
    yield word("moment about", letter=MOMENT, point=shaft, unit=word("N*m")), _rounded(state.rocking, none.moment)
    drafting = expected.drafting
    for key, one in state.forces.reactions.items():
        letter = drafting.letter(with_index(f"{drafting.reactions}_{indices(one.giver, one.taker)}"))
        yield f"{letter}, {word('N')}", _rounded(state.reactions[key], none.force)
    balancing = drafting.letter(with_index(BALANCING))
    yield f"{balancing}, {word('N*m')}", _rounded(state.balancing, none.moment)
    yield word("moving mass", unit=word("kg")), state.centre.mass


def _rounded(value: float, none: float) -> float:
    return 0.0 if abs(value) <= none else value


def _change(was: float, now: float | None) -> list[Cell]:
    if now is None:
        return [Number(was, 0.0)]
    return [Number(was, 0.0), Number(now, 0.0), Change(100 * (now / was - 1)) if was else Said(NONE)]


def _table(leaf: Leaf, name: str, heads: Sequence[str], rows: Mapping[str, Sequence[Cell]]) -> Iterator[Wrong]:
    """Hold a table: its headings, every cell, no row missing; a set of one sheet bears all of its tables."""
    parts = [one for one in groups(leaf.groups) if one.name.removeprefix(f"{name}-").isdigit()]
    if not parts:
        yield from [within("missing_from", name, name=row) for row in rows] if leaf.metadata["of"] == 1 else []
        return
    due = {Text(0j, row).plain: cells for row, cells in rows.items()}
    seen = dict.fromkeys(due, False)
    for part in parts:
        yield from _heads(part, name, heads)
        yield from ruled.faults(part, name, [Text(0j, head).plain for head in heads])
        for row, *cells in _rows(part)[1:]:
            if row not in due or seen[row]:
                yield within("stranger_in", name, text=row)
                continue
            seen[row] = True
            yield from _cells(name, row, cells, due[row])
    yield from (within("missing_from", name, name=row) for row, there in seen.items() if not there)


def _rows(part: Group) -> list[list[str]]:
    return [[text.plain for text in row] for row in reading.rows(part)]


def _heads(part: Group, name: str, heads: Sequence[str]) -> Iterator[Wrong]:
    found = _rows(part)[0]
    wrong = [text for text, head in zip(found, heads, strict=False) if text != Text(0j, head).plain]
    if wrong or len(found) != len(heads):
        yield within("stranger_in", name, text=(wrong or found)[0])


def _cells(name: str, row: str, cells: Sequence[str], due: Sequence[Cell]) -> Iterator[Wrong]:
    if len(cells) != len(due):
        yield within("row", name, name=row)
        return
    wrong = (text for text, cell in zip(cells, due, strict=True) if not cell.holds(text))
    yield from (within("cell", name, name=row, text=text) for text in wrong)
