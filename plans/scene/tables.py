"""Tables of a scene (таблицы): read key by key into frozen values, every refusal kept, so that all are told at once.

A reader takes a value of the file, its path and the list of refusals; it gives what it read, or REFUSED.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from copy import copy
from functools import partial
from typing import Any, ClassVar, Final, NamedTuple, TypeAlias, TypeVar

from plans.scene.faults import Path, Wrong

REQUIRED: Final = object()  # the default of a key that has none
REFUSED: Final = object()  # what a reader gives for a value that it refuses
T = TypeVar("T", bound="Table")


class Refusal(NamedTuple):
    """One refused value: its path, the kind of fault with its details, and the value."""

    path: Path
    kind: str
    details: Mapping[str, object]
    value: object


Refusals: TypeAlias = list[Refusal]
Reader: TypeAlias = Callable[[Any, Path, Refusals], Any]
Check: TypeAlias = Callable[[Any], object]


class Refused(ValueError):  # noqa: N818  (it is caught and worded, never shown)
    """A scene whose form is not taken, with all refusals in the order of the form."""

    def __init__(self, refusals: Refusals) -> None:
        super().__init__(f"{len(refusals)} refusals")
        self.refusals = refusals


class Key(NamedTuple):
    """A key of a table: how its value is read, and what stands for it where it is not given."""

    reader: Reader
    default: Any


def key(reader: Reader, default: Any = REQUIRED) -> Any:
    """Declare a key in the body of a Table."""
    return Key(reader, default)


class Table:
    """A table of the scene: frozen, and closed against unknown keys."""

    form: ClassVar[Mapping[str, Key]] = {}
    given: frozenset[str]  # the keys that the file has

    def __init_subclass__(cls) -> None:
        cls.form = {name: key for name, key in vars(cls).items() if isinstance(key, Key)}

    def __init__(self, **values: Any) -> None:
        for name, known in self.form.items():
            vars(self)[name] = values.get(name, known.default)
        vars(self)["given"] = frozenset(values)

    def changed(self: T, **values: Any) -> T:
        """Give the table with other values of some keys, which are not checked again."""
        found = copy(self)
        vars(found).update(values)
        return found

    def check(self) -> None:
        """See that the keys fit each other; called where each of them is taken."""

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"{type(self).__name__} is frozen")

    def __eq__(self, other: object) -> bool:
        return type(other) is type(self) and all(getattr(self, name) == getattr(other, name) for name in self.form)

    __hash__ = None  # type: ignore[assignment]  # a table holds dictionaries

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{name}={getattr(self, name)!r}' for name in self.form)})"


def read(kind: type[T], data: object) -> T:
    """Read a whole file as a table; all refusals together are one Refused."""
    refused: Refusals = []
    found = table(kind)(data, (), refused)
    if refused:
        raise Refused(refused)
    assert isinstance(found, kind)
    return found


def one(check: Callable[..., Any], **given: object) -> Reader:
    """Read a value by a check that raises Wrong: every wrong value is one refusal."""

    return lambda value, path, refused: _checked(partial(check, value, **given), value, path, refused)


def table(kind: type[Table]) -> Reader:
    """Read a table with the keys of its kind."""

    def reader(value: object, path: Path, refused: Refusals) -> Any:
        if not isinstance(value, dict):
            refused.append(Refusal(path, "not_a_table", {}, value))
            return REFUSED
        before = len(refused)
        values = {}
        for name, known in kind.form.items():
            if name in value:
                values[name] = known.reader(value[name], (*path, name), refused)
            elif known.default is REQUIRED:
                refused.append(Refusal((*path, name), "missing", {}, value))
        refused += [Refusal((*path, name), "unknown_key", {}, value[name]) for name in value if name not in kind.form]
        if len(refused) > before:
            return REFUSED
        found = kind(**values)
        return REFUSED if _checked(found.check, value, path, refused) is REFUSED else found

    return reader


def many(entry: Reader, *checks: Check, first: Check | None = None) -> Reader:
    """Read a list as a tuple: `first` looks at the whole before any entry is read, the checks afterwards."""

    def reader(value: object, path: Path, refused: Refusals) -> Any:
        before = len(refused)
        if first and _checked(partial(first, value), value, path, refused) is REFUSED:
            return REFUSED
        if not isinstance(value, list):
            refused.append(Refusal(path, "not_a_list", {}, value))
            return REFUSED
        entries = tuple(entry(part, (*path, place), refused) for place, part in enumerate(value))
        return REFUSED if len(refused) > before else _all(checks, entries, path, refused)

    return reader


def named(name: Reader, entry: Reader, *checks: Check, first: Check | None = None) -> Reader:
    """Read a table whose keys are names that the author chose."""

    def reader(value: object, path: Path, refused: Refusals) -> Any:
        before = len(refused)
        if first and _checked(partial(first, value), value, path, refused) is REFUSED:
            return REFUSED
        if not isinstance(value, dict):
            refused.append(Refusal(path, "not_a_table", {}, value))
            return REFUSED
        pairs = [(name(own, (*path, own), refused), entry(part, (*path, own), refused)) for own, part in value.items()]
        return REFUSED if len(refused) > before else _all(checks, dict(pairs), path, refused)

    return reader


def either(kind: type, then: Reader, otherwise: Reader) -> Reader:
    """Read values of one kind (list, dict) in one way and all others in another."""
    return lambda value, path, refused: (then if isinstance(value, kind) else otherwise)(value, path, refused)


def _all(checks: tuple[Check, ...], found: Any, path: Path, refused: Refusals) -> Any:
    for check in checks:
        if _checked(partial(check, found), found, path, refused) is REFUSED:
            return REFUSED
    return found


def _checked(check: Callable[[], Any], value: object, path: Path, refused: Refusals) -> Any:
    try:
        return check()
    except Wrong as wrong:
        refused.append(Refusal(path + wrong.at, wrong.kind, wrong.details, value))
        return REFUSED
