"""Readers (чтение значений): how one value of a file is read, every refusal kept, so that all are told at once.

A field knows how its value is read, and what editors and people are told of it; which is made only where asked for.
"""

from collections import Counter
from collections.abc import Callable, Mapping
from functools import partial
from typing import Any, Final, NamedTuple, TypeAlias

from plans.scene import forms
from plans.scene.faults import Path, Wrong
from plans.scene.forms import Form

REFUSED: Final = object()  # what a reader gives for a value that it refuses


class Refusal(NamedTuple):
    """One refused value: its path, the kind of fault with its details, and the value."""

    path: Path
    kind: str
    details: Mapping[str, object]
    value: object


Refusals: TypeAlias = list[Refusal]
# Takes a value of the file, its path and the list of refusals; gives what it read, or REFUSED.
Reader: TypeAlias = Callable[[Any, Path, Refusals], Any]


class Refused(ValueError):  # noqa: N818  (it is caught and worded, never shown)
    """A scene whose form is not taken, with all refusals in the order of the form."""

    def __init__(self, refusals: Refusals) -> None:
        super().__init__(f"{len(refusals)} refusals")
        self.refusals = refusals


class FieldReader(NamedTuple):
    """How a value of the file is read, its form for editors and for people, and the tables in it by their paths."""

    read: Reader
    form: Callable[[], Form]
    shown: str
    tables: tuple[tuple[Path, type[Any]], ...] = ()


class Check(NamedTuple):
    """What is seen to of a whole list or table, and what of it a JSON Schema can say."""

    see: Callable[[Any], object]
    least: int = 0
    most: int | None = None
    unique: bool = False


def one(check: Callable[..., Any], form: Callable[[], Form] = dict, shown: str = "", **given: object) -> FieldReader:
    """Read a value by a check that raises Wrong: every wrong value is one refusal."""

    def reader(value: object, path: Path, refused: Refusals) -> Any:
        return checked(partial(check, value, **given), value, path, refused)

    return FieldReader(reader, form, shown)


def many(entry: FieldReader, *checks: Check, first: Check | None = None) -> FieldReader:
    """Read a list as a tuple: `first` looks at the whole before any entry is read, the checks afterwards."""

    def reader(value: object, path: Path, refused: Refusals) -> Any:
        before = len(refused)
        if first and checked(partial(first.see, value), value, path, refused) is REFUSED:
            return REFUSED
        if not isinstance(value, list):
            refused.append(Refusal(path, "not_a_list", {}, value))
            return REFUSED
        entries = tuple(entry.read(part, (*path, place), refused) for place, part in enumerate(value))
        refused[before:] = _gathered(refused[before:], len(path) + 1)
        return REFUSED if len(refused) > before else _all(checks, entries, path, refused)

    def form() -> Form:
        least, most, unique = _bounds(first, *checks)
        return forms.entries(entry.form(), least, most, **({"uniqueItems": True} if unique else {}))

    return FieldReader(reader, form, f"[{entry.shown}, ...]", _within(entry))


def named(name: FieldReader, entry: FieldReader, *checks: Check, first: Check | None = None) -> FieldReader:
    """Read a table whose keys are names that the author chose."""

    def reader(value: object, path: Path, refused: Refusals) -> Any:
        before = len(refused)
        if first and checked(partial(first.see, value), value, path, refused) is REFUSED:
            return REFUSED
        if not isinstance(value, dict):
            refused.append(Refusal(path, "not_a_table", {}, value))
            return REFUSED
        rows = ((key, part, (*path, key)) for key, part in value.items())
        pairs = [(name.read(key, way, refused), entry.read(part, way, refused)) for key, part, way in rows]
        return REFUSED if len(refused) > before else _all(checks, dict(pairs), path, refused)

    def form() -> Form:
        least, most, _ = _bounds(first, *checks)
        return forms.named(entry.form(), name.form()["pattern"], least, most)

    return FieldReader(reader, form, f"{name.shown} = {entry.shown}", _within(entry))


def either(kind: type, then: FieldReader, otherwise: FieldReader) -> FieldReader:
    """Read values of one kind (list, dict) in one way and all others in another."""
    return FieldReader(
        lambda value, path, refused: (then if isinstance(value, kind) else otherwise).read(value, path, refused),
        lambda: {"anyOf": [otherwise.form(), then.form()]},
        f"{otherwise.shown}, or {then.shown}",
        otherwise.tables + then.tables,
    )


def _gathered(refused: Refusals, depth: int) -> Refusals:
    """Tell one wrong unit of the entries of a list once, at the first of them."""
    units = Counter(refusal.details["unit"] for refusal in refused if _of_unit(refusal, depth))
    found: Refusals = []
    known: set[object] = set()
    for refusal in refused:
        unit = refusal.details["unit"] if _of_unit(refusal, depth) else None
        if unit is None or units[unit] == 1:
            found.append(refusal)
        elif unit not in known:
            known.add(unit)
            found.append(refusal._replace(kind="wrong_units", details={**refusal.details, "others": units[unit] - 1}))
    return found


def _of_unit(refusal: Refusal, depth: int) -> bool:
    return refusal.kind == "wrong_unit" and len(refusal.path) == depth


def _within(entry: FieldReader) -> tuple[tuple[Path, type[Any]], ...]:
    return tuple((("*", *path), kind) for path, kind in entry.tables)


def _bounds(*checks: Check | None) -> tuple[int, int | None, bool]:
    given = [check for check in checks if check]
    most = [check.most for check in given if check.most is not None]
    return max((check.least for check in given), default=0), min(most, default=None), any(c.unique for c in given)


def _all(checks: tuple[Check, ...], found: Any, path: Path, refused: Refusals) -> Any:
    for check in checks:
        if checked(partial(check.see, found), found, path, refused) is REFUSED:
            return REFUSED
    return found


def checked(check: Callable[[], Any], value: object, path: Path, refused: Refusals) -> Any:
    """Give what a check gives; what it raises as Wrong is a refusal."""
    try:
        return check()
    except Wrong as wrong:
        refused.append(refusal(wrong, value, path))
        return REFUSED


def refusal(wrong: Wrong, value: object, path: Path) -> Refusal:
    """Make the refusal of a value for what is wrong with it or a part of it."""
    return Refusal(path + wrong.at, wrong.kind, wrong.details, value)
