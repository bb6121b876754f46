"""Units as students write them: with powers, prefixes and brackets, in either language (запись единицы)."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from functools import lru_cache, reduce
from types import MappingProxyType
from typing import Final, NamedTuple

from drawings.reading.alphabet import folded

LONGEST = 24  # letters: no unit of ours has half as many
TOGETHER = 3  # units that may be written without a sign between them: "kgm2", "Nmm"
TURN, MINUTE = 2 * math.pi, 60.0  # of speeds in turns a minute


class Worth(NamedTuple):
    """What a unit is worth in metres, kilograms and seconds, and their powers; an angle is a number."""

    size: float
    metres: int = 0
    kilograms: int = 0
    seconds: int = 0

    @property
    def powers(self) -> tuple[int, int, int]:
        """Of which kind of quantity it is."""
        return self.metres, self.kilograms, self.seconds

    def times(self, other: Worth, power: int = 1) -> Worth:
        """Multiply it by a power of another."""
        powers = (ours + power * theirs for ours, theirs in zip(self.powers, other.powers, strict=True))
        return Worth(self.size * other.size**power, *powers)


ONE: Final = Worth(1.0)
_NEWTON, _JOULE = Worth(1.0, 1, 1, -2), Worth(1.0, 2, 1, -2)
# By how each looks: what is written alike in both languages stands once.
_PREFIXED: Final = MappingProxyType({
    folded(name): unit
    for names, unit in (
        ("m м", Worth(1.0, 1)), ("g г", Worth(1e-3, 0, 1)), ("s с sec сек", Worth(1.0, 0, 0, 1)), ("N Н", _NEWTON),
        ("J Дж", _JOULE), ("W Вт", Worth(1.0, 2, 1, -3)), ("Pa Па", Worth(1.0, -1, 1, -2)), ("rad рад", ONE),
    )
    for name in names.split()
})  # fmt: skip
_BARE: Final = MappingProxyType({
    folded(name): unit
    for names, unit in (
        ("1", ONE), ("%", Worth(0.01)), ("° deg град", Worth(math.pi / 180)), ("min мин", Worth(MINUTE, 0, 0, 1)),
        ("rev turn об", Worth(TURN)), ("rpm", Worth(TURN / MINUTE, 0, 0, -1)),
    )
    for name in names.split()
})  # fmt: skip
_PREFIXES: Final = MappingProxyType({
    folded(name): size
    for names, size in (
        ("n н", 1e-9), ("μ µ мк", 1e-6), ("m м", 1e-3), ("c с", 1e-2), ("d д", 0.1), ("k к", 1e3), ("M М", 1e6),
        ("G Г", 1e9),
    )
    for name in names.split()
})  # fmt: skip
_A_MINUTE: Final = tuple(folded(name) for name in ("1/min", "min-1", "1/мин", "мин-1"))  # said of turns
_POWER = re.compile(r"\^?([-+]?\d)")


def in_unit(text: str, expected: str) -> float | None:
    """Give how many of a due unit one that is written is; None where it is not understood, or of another quantity.

    Where none is written it is the due one.

    >>> in_unit("g·mm", "kg·m"), in_unit("mm²", "м²"), in_unit("(mm/s)/mm", "(m/s)/mm"), in_unit("foot", "m")
    (1e-06, 1e-06, 0.001, None)
    >>> in_unit("", "N·m"), in_unit("N", "N·m"), round(in_unit("rpm", "rad/s"), 4)
    (1.0, None, 0.1047)
    """
    written, wanted = _bare(text), _bare(expected)
    if written in ("", wanted):
        return 1.0
    aims = [reading for reading in _readings(wanted) if written not in _A_MINUTE or reading.powers == (0, 0, -1)]
    if written in _A_MINUTE:
        written = "rpm"
    alike = (reading for reading in _readings(written) if aims and reading.powers == aims[0].powers)
    return next((reading.size / aims[0].size for reading in alike), None)


def in_system(unit: str) -> float | None:
    """Give what a unit is worth in metres, kilograms and seconds; None where it is not understood.

    >>> in_system("kN·m"), in_system("foot")
    (1000.0, None)
    """
    return next((reading.size for reading in _readings(_bare(unit))), None)


def _bare(unit: str) -> str:
    """Write a unit as it is seen, with one sign for products."""
    plain = folded(re.sub(r"[{}]", "", unit).strip().rstrip(".,;"))
    plain = re.sub(r"\s*([·∙⋅*/()])\s*", r"\1", plain)
    return re.sub(r"\s+|[∙⋅*]", "·", plain).translate(str.maketrans("−–‑", "---"))


@lru_cache(maxsize=1024)
def _readings(unit: str) -> tuple[Worth, ...]:
    """Give all that a unit may be: letters that stand together may be several, and a product after a stroke too."""
    if not unit:
        return (ONE,)
    return tuple(_quotients(unit)) if len(unit) <= LONGEST else ()


def _quotients(unit: str) -> Iterator[Worth]:
    """Read what is over and under strokes: all that is after one is under it, or its first factor alone."""
    over, *under = (list(map(_factor, _parts(part, "·"))) for part in _parts(unit, "/"))
    for top in _products(over):
        yield from (top.times(below, -1) for below in _products([factor for part in under for factor in part]))
        if any(len(part) > 1 for part in under):
            for below in _products([part[0] for part in under]):
                beside = _products([factor for part in under for factor in part[1:]])
                yield from (top.times(factor).times(below, -1) for factor in beside)


def _parts(unit: str, sign: str) -> list[str]:
    """Take a unit apart at a sign that is in no brackets."""
    parts, depth = [""], 0
    for letter in unit:
        depth += (letter == "(") - (letter == ")")
        if letter == sign and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    return parts


def _products(factors: list[tuple[Worth, ...]]) -> Iterator[Worth]:
    found = [ONE]
    for factor in factors:
        found = [product.times(other) for product in found for other in factor]
    yield from found


def _factor(text: str) -> tuple[Worth, ...]:
    power = re.search(rf"(?:{_POWER.pattern}|\^\({_POWER.pattern}\))$", text)
    if power is None or text == "1":
        return tuple(_atoms(text))
    return tuple(_raised(text[: power.start()], int(power[1] or power[2])))


def _raised(text: str, power: int) -> Iterator[Worth]:
    """Read what has a power: of units written together only the last one has it."""
    if text.startswith("("):
        yield from (ONE.times(atom, power) for atom in _atoms(text))
        return
    yield from (reduce(Worth.times, row[:-1], ONE).times(row[-1], power) for row in _words(text, TOGETHER))


def _atoms(text: str) -> Iterator[Worth]:
    if text.startswith("(") and text.endswith(")"):
        yield from _readings(text[1:-1])
    else:
        yield from (reduce(Worth.times, row, ONE) for row in _words(text, TOGETHER))


def _words(text: str, most: int) -> Iterator[tuple[Worth, ...]]:
    """Read letters as one unit with its prefix or none, then as several."""
    whole = _named(text)
    if whole is not None:
        yield (whole,)
    for k in range(1, len(text)) if most > 1 else ():
        first = _named(text[:k])
        if first is not None:
            yield from ((first, *rest) for rest in _words(text[k:], most - 1))


def _named(text: str) -> Worth | None:
    if text in _BARE:
        return _BARE[text]
    if text in _PREFIXED:
        return _PREFIXED[text]
    for name, unit in _PREFIXED.items():
        prefix = text.removesuffix(name)
        if prefix != text and prefix in _PREFIXES:
            return unit.times(Worth(_PREFIXES[prefix]))
    return None
