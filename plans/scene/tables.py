"""Tables of a scene (таблицы): read key by key into frozen values, every refusal kept, so that all are told at once.

A key is stated once, in the body of its table: its field, its default, what it means. A field knows how its value is
read, and the form of it in a JSON Schema, which is made only where it is asked for.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from copy import copy
from functools import partial
from typing import Any, ClassVar, Final, NamedTuple, TypeAlias, TypeVar

from plans.scene import forms
from plans.scene.faults import Path, Wrong
from plans.scene.forms import Form

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
# Takes a value of the file, its path and the list of refusals; gives what it read, or REFUSED.
Reader: TypeAlias = Callable[[Any, Path, Refusals], Any]


class Refused(ValueError):  # noqa: N818  (it is caught and worded, never shown)
    """A scene whose form is not taken, with all refusals in the order of the form."""

    def __init__(self, refusals: Refusals) -> None:
        super().__init__(f"{len(refusals)} refusals")
        self.refusals = refusals


class Field(NamedTuple):
    """How a value of the file is read, its form in a JSON Schema, and the tables in it with the path to each."""

    read: Reader
    form: Callable[[], Form]
    tables: tuple[tuple[Path, type[Table]], ...] = ()


class Check(NamedTuple):
    """What is seen to of a whole list or table, and what of it a JSON Schema can say."""

    see: Callable[[Any], object]
    least: int = 0
    most: int | None = None
    unique: bool = False


class Missing(NamedTuple):
    """What a required key is, a line that would do, and what stands in for it while the rest is examined."""

    thing: str
    example: str
    stand_in: Any = None


class Key(NamedTuple):
    """A key of a table: the field of its value, what stands for it where it is not given, and what it means."""

    field: Field
    default: Any
    meaning: str
    missing: Missing | None


def key(field: Field, default: Any = REQUIRED, *, meaning: str = "", missing: Missing | None = None) -> Any:
    """Declare a key in the body of a Table."""
    return Key(field, default, meaning, missing)


class Table:
    """A table of the scene: frozen, and closed against unknown keys."""

    keys: ClassVar[Mapping[str, Key]] = {}
    given: frozenset[str]  # the keys that the file has

    def __init_subclass__(cls) -> None:
        own = {name: key for name, key in vars(cls).items() if isinstance(key, Key)}
        cls.keys = own | {name: key for name, key in cls.keys.items() if name not in own}

    def __init__(self, **values: Any) -> None:
        for name, known in self.keys.items():
            vars(self)[name] = values.get(name, known.default)
        vars(self)["given"] = frozenset(values)

    def changed(self: T, **values: Any) -> T:
        """Give the table with other values of some keys, which are not checked again."""
        found = copy(self)
        vars(found).update(values)
        return found

    def check(self) -> None:
        """See that the keys fit each other; called where each of them is taken."""

    @classmethod
    def home_of(cls, name: str) -> Path:
        """Give the table of free names within it that a stray key may be meant for."""
        return ()

    @classmethod
    def rules(cls) -> Form:
        """Give what the keys mean for each other, as a JSON Schema says it."""
        return {}

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"{type(self).__name__} is frozen")

    def __eq__(self, other: object) -> bool:
        return type(other) is type(self) and all(getattr(self, name) == getattr(other, name) for name in self.keys)

    __hash__ = None  # type: ignore[assignment]  # a table holds dictionaries

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{name}={getattr(self, name)!r}' for name in self.keys)})"


Kinds: TypeAlias = tuple[type[Table], ...]  # what is read of one table of the file: each kind takes its own keys


def read(kind: type[T], data: object) -> T:
    """Read a whole file as a table; all refusals together are one Refused."""
    found = read_parts((kind,), data)[kind]
    assert isinstance(found, kind)
    return found


def read_parts(kinds: Kinds, data: object, *before: Refusal) -> Mapping[type[Table], Table]:
    """Read a whole file as several tables, each taking its own keys; all refusals together are one Refused."""
    refused: Refusals = [*before]
    found = _parts(kinds, data, (), refused)
    if refused:
        raise Refused(refused)
    assert isinstance(found, dict)
    return found


def one(check: Callable[..., Any], form: Callable[[], Form] = dict, **given: object) -> Field:
    """Read a value by a check that raises Wrong: every wrong value is one refusal."""
    return Field(lambda value, path, refused: _checked(partial(check, value, **given), value, path, refused), form)


def table(kind: type[Table]) -> Field:
    """Read a table with the keys of its kind."""

    def reader(value: object, path: Path, refused: Refusals) -> Any:
        found = _parts((kind,), value, path, refused)
        return REFUSED if found is REFUSED else found[kind]

    return Field(reader, lambda: form_of((kind,)), (((), kind),))


def many(entry: Field, *checks: Check, first: Check | None = None) -> Field:
    """Read a list as a tuple: `first` looks at the whole before any entry is read, the checks afterwards."""

    def reader(value: object, path: Path, refused: Refusals) -> Any:
        before = len(refused)
        if first and _checked(partial(first.see, value), value, path, refused) is REFUSED:
            return REFUSED
        if not isinstance(value, list):
            refused.append(Refusal(path, "not_a_list", {}, value))
            return REFUSED
        entries = tuple(entry.read(part, (*path, place), refused) for place, part in enumerate(value))
        return REFUSED if len(refused) > before else _all(checks, entries, path, refused)

    def form() -> Form:
        least, most, unique = _bounds(first, *checks)
        return forms.entries(entry.form(), least, most, **({"uniqueItems": True} if unique else {}))

    return Field(reader, form, _within(entry))


def named(name: Field, entry: Field, *checks: Check, first: Check | None = None) -> Field:
    """Read a table whose keys are names that the author chose."""

    def reader(value: object, path: Path, refused: Refusals) -> Any:
        before = len(refused)
        if first and _checked(partial(first.see, value), value, path, refused) is REFUSED:
            return REFUSED
        if not isinstance(value, dict):
            refused.append(Refusal(path, "not_a_table", {}, value))
            return REFUSED
        pairs = [
            (name.read(own, (*path, own), refused), entry.read(part, (*path, own), refused))
            for own, part in value.items()
        ]
        return REFUSED if len(refused) > before else _all(checks, dict(pairs), path, refused)

    def form() -> Form:
        least, most, _ = _bounds(first, *checks)
        return forms.named(entry.form(), name.form()["pattern"], least, most)

    return Field(reader, form, _within(entry))


def either(kind: type, then: Field, otherwise: Field) -> Field:
    """Read values of one kind (list, dict) in one way and all others in another."""
    return Field(
        lambda value, path, refused: (then if isinstance(value, kind) else otherwise).read(value, path, refused),
        lambda: {"anyOf": [otherwise.form(), then.form()]},
        otherwise.tables + then.tables,
    )


def form_of(kinds: Kinds) -> Form:
    """Give the form of a table as a JSON Schema: its keys, which of them it must have, and no others."""
    holders = holders_of(kinds)
    properties = {name: {"description": _meaning(parts, name), **_form(parts, name)} for name, parts in holders.items()}
    required = [name for name, parts in holders.items() if _required(parts, name)]
    rules = [rule for kind in kinds if (rule := kind.rules())]
    form: Form = {"type": "object", "properties": properties, "additionalProperties": False}
    form |= {"required": required} if required else {}
    return form | (rules[0] if len(rules) == 1 else {"allOf": rules} if rules else {})


def tables_of(kinds: Kinds) -> Mapping[Path, Kinds]:
    """Give all tables of a form, the outer before the inner, "*" standing for any key or number in a list."""
    found: dict[Path, Kinds] = {(): kinds}
    waiting: list[Path] = [()]
    for path in waiting:
        for name, parts in holders_of(found[path]).items():
            for part in parts:
                for steps, kind in part.keys[name].field.tables:
                    inner = (*path, name, *steps)
                    waiting += () if inner in found else (inner,)
                    found[inner] = (*found.get(inner, ()), kind)
    return found


def holders_of(kinds: Kinds) -> Mapping[str, Kinds]:
    """Give each key of a table with the kinds that state it; of a key of several each reads a part of its table."""
    names = dict.fromkeys(name for kind in kinds for name in kind.keys)
    return {name: tuple(kind for kind in kinds if name in kind.keys) for name in names}


def _meaning(holders: Kinds, name: str) -> str:
    return holders[0].keys[name].meaning


def _form(holders: Kinds, name: str) -> Form:
    first = holders[0].keys[name].field
    return first.form() if len(holders) == 1 else form_of(_inner(holders, name))


def _required(holders: Kinds, name: str) -> bool:
    return any(kind.keys[name].default is REQUIRED for kind in holders)


def _inner(holders: Kinds, name: str) -> Kinds:
    return tuple(kind.keys[name].field.tables[0][1] for kind in holders)


def _within(entry: Field) -> tuple[tuple[Path, type[Table]], ...]:
    return tuple((("*", *path), kind) for path, kind in entry.tables)


def _bounds(*checks: Check | None) -> tuple[int, int | None, bool]:
    given = [check for check in checks if check]
    most = [check.most for check in given if check.most is not None]
    return max((check.least for check in given), default=0), min(most, default=None), any(c.unique for c in given)


def _parts(kinds: Kinds, value: object, path: Path, refused: Refusals) -> Any:
    """Read one table of the file as the kinds that share it; none is made where anything in it is refused."""
    if not isinstance(value, dict):
        refused.append(Refusal(path, "not_a_table", {}, value))
        return REFUSED
    before, values, holders = len(refused), {kind: dict[str, Any]() for kind in kinds}, holders_of(kinds)
    for name, parts in holders.items():
        if name in value:
            for kind, found in _key(parts, name, value[name], (*path, name), refused):
                values[kind][name] = found
        elif _required(parts, name):
            refused.append(Refusal((*path, name), "missing", {}, value))
    refused += [Refusal((*path, name), "unknown_key", {}, value[name]) for name in value if name not in holders]
    if len(refused) > before:
        return REFUSED
    made = {kind: kind(**values[kind]) for kind in kinds}
    checked = [_checked(part.check, value, path, refused) for part in made.values()]
    return REFUSED if any(result is REFUSED for result in checked) else made


def _key(holders: Kinds, name: str, value: object, path: Path, refused: Refusals) -> list[tuple[type[Table], Any]]:
    """Read the value of a key for each kind that states it."""
    if len(holders) == 1:
        return [(holders[0], holders[0].keys[name].field.read(value, path, refused))]
    found = _parts(_inner(holders, name), value, path, refused)
    if found is REFUSED:
        return []
    return list(zip(holders, found.values(), strict=True))


def _all(checks: tuple[Check, ...], found: Any, path: Path, refused: Refusals) -> Any:
    for check in checks:
        if _checked(partial(check.see, found), found, path, refused) is REFUSED:
            return REFUSED
    return found


def _checked(check: Callable[[], Any], value: object, path: Path, refused: Refusals) -> Any:
    try:
        return check()
    except Wrong as wrong:
        refused.append(Refusal(path + wrong.at, wrong.kind, wrong.details, value))
        return REFUSED
