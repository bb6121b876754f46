"""What a scene gives (дано): its numbers, by which any writing is told from an answer, and its data in words."""

from __future__ import annotations

import math
import re
import tomllib
from collections.abc import Iterable, Iterator
from decimal import Decimal
from typing import Any, Final, NamedTuple

from drawings.lettering.words import word
from plans.scene.scene import Scene
from plans.techniques import TECHNIQUES

NUMERAL = re.compile(r"\d+(?:[.,]\d+)?")
TOLD = 3  # digits: a number of fewer counts or names something, and tells no value
SKETCH = "sketch"  # where points lie about is what the plan of positions has to find
# Degrees of two turns, or mm of a plate, by which the rows of a table count, though no scene gives them.
TURN = "360"  # positions that a turn is looked through in, as heads of tables say
STEPS: Final = frozenset(2.5 * step for step in range(289))
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
        return all(self._knows(one[0]) or _counts(one) for one in NUMERAL.finditer(text))

    def _knows(self, numeral: str) -> bool:
        digits = numeral.replace(",", ".")
        if len(digits.replace(".", "").lstrip("0")) < TOLD and "." not in digits:
            return True
        half = 0.5 * 10.0 ** -len(digits.partition(".")[2])
        return any(abs(abs(number) - float(digits)) <= half for number in self.numbers)


def _counts(numeral: re.Match[str]) -> bool:
    """Tell whether a number is by what the rows of a table count: the name of a row alone, or degrees."""
    alone = numeral[0] == numeral.string.strip()
    degrees = numeral.string[numeral.end() :].lstrip().startswith("°")
    return numeral[0] == TURN or ((alone or degrees) and float(numeral[0].replace(",", ".")) in STEPS)


def given(scene: Scene) -> Given:
    """Gather the numbers of a scene."""
    own = {abs(number) for number in _numbers(tomllib.loads(_text(scene)))}
    return Given(tuple(sorted({number * unit for number in own for unit in UNITS})))


def data(scene: Scene) -> list[str]:
    """Write the tables of a scene's techniques, key by key as its file has them."""
    tables = tomllib.loads(_text(scene))
    names = dict.fromkeys(name for technique in scene.techniques for name in TECHNIQUES[technique].tables)
    told = [line for name in names if name in tables for line in _lines(name, tables[name])]
    return [word(scene.sheet.language, "form given"), *told]


def _text(scene: Scene) -> str:
    return scene.content.decode("utf-8-sig")


def _lines(name: str, value: Any) -> Iterator[str]:
    """Write a table in one paragraph, and each table within it in one of its own."""
    for table in value if isinstance(value, list) else [value]:
        inner = {key: one for key, one in table.items() if _is_table(one)}
        plain = {key: one for key, one in table.items() if key not in inner}
        if plain:
            yield f"[{name}] {_written(plain)}"
        for key, one in inner.items():
            if key != SKETCH:
                yield from _lines(f"{name}.{key}", one)


def _is_table(value: Any) -> bool:
    rows = value if isinstance(value, list) else [value]
    return bool(rows) and all(isinstance(row, dict) for row in rows)


def _written(value: Any) -> str:
    match value:
        case dict():
            return ", ".join(f"{key} = {_inner(one)}" for key, one in value.items())
        case list():
            return ", ".join(map(_inner, value))
        case bool() | str():
            return str(value)
    return f"{Decimal(repr(value)):f}"  # no power of ten: it would be read as two numbers


def _inner(value: Any) -> str:
    return f"({_written(value)})" if isinstance(value, dict | list) else _escaped(_written(value))


def _escaped(text: str) -> str:
    return re.sub(r"([_^{}\\])", r"\\\1", text)


def _numbers(value: Any) -> Iterator[float]:
    """Give all numbers that stand in a value, in its texts too."""
    match value:
        case bool():
            return
        case int() | float():
            yield float(value)
        case str():
            yield from (float(numeral.replace(",", ".")) for numeral in NUMERAL.findall(value))
        case dict() | list():
            inner: Iterable[Any] = [*value.values(), *value] if isinstance(value, dict) else value
            for one in inner:
                yield from _numbers(one)
