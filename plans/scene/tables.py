"""Tables of a scene (таблицы): read key by key into frozen values.

A key is stated once, in the body of its table: its field, its default, what it means.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from copy import copy
from functools import cache
from keyword import iskeyword
from typing import Any, ClassVar, Final, NamedTuple, TypeAlias, TypeVar

from plans.scene.faults import Path, Wrong
from plans.scene.forms import Form
from plans.scene.readers import REFUSED, FieldReader, Refusal, Refusals, Refused, checked, refusal

REQUIRED: Final = object()  # the default of a key that has none
T = TypeVar("T", bound="Table")


class Missing(NamedTuple):
    """What a required key is, a line that would do, and what stands in for it while the rest is examined."""

    thing: str
    example: str
    stand_in: Any = None


class Key(NamedTuple):
    """A key of a table: the field of its value, what stands for it where it is not given, and what it means.

    `also` are other names that an author may give it.
    """

    field: FieldReader
    default: Any
    meaning: str
    missing: Missing | None
    also: tuple[str, ...] = ()


def key(
    field: FieldReader,
    default: Any = REQUIRED,
    *,
    meaning: str = "",
    missing: Missing | None = None,
    also: tuple[str, ...] = (),
) -> Any:
    """Declare a key in the body of a Table."""
    return Key(field, default, meaning, missing, also)


class Table:
    """A table of the scene: frozen, and closed against unknown keys."""

    keys: ClassVar[Mapping[str, Key]] = {}
    bare: ClassVar[str] = "not_a_table"  # what is said of a value that stands in its place
    given: frozenset[str]  # the keys that the file has

    def __init_subclass__(cls) -> None:
        keys = {name.removesuffix("_"): key for name, key in vars(cls).items() if isinstance(key, Key)}
        cls.keys = keys | {name: key for name, key in cls.keys.items() if name not in keys}

    def __init__(self, **values: Any) -> None:
        for name, known in self.keys.items():
            vars(self)[attribute(name)] = values.get(name, known.default)
        vars(self)["given"] = frozenset(values)

    def changed(self: T, **values: Any) -> T:
        """Give the table with other values of some keys, which are not checked again."""
        found = copy(self)
        vars(found).update(values)
        return found

    def check(self) -> None:
        """See that the keys fit each other; called where each of them is taken."""

    @classmethod
    def misfits(cls, value: Mapping[str, Any]) -> Iterable[Wrong]:
        """Give what is wrong with the keys that a table has or lacks; its words are as they are read."""
        return ()

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
        return type(other) is type(self) and all(a == b for a, b in zip(self._values(), other._values(), strict=True))

    __hash__ = None  # type: ignore[assignment]  # a table holds dictionaries

    def __repr__(self) -> str:
        pairs = zip(self.keys, self._values(), strict=True)
        return f"{type(self).__name__}({', '.join(f'{name}={value!r}' for name, value in pairs)})"

    def _values(self) -> Iterator[Any]:
        return (getattr(self, attribute(name)) for name in self.keys)


def attribute(name: str) -> str:
    """Give the attribute of a table that holds a key: a word of Python's own has a line behind it.

    >>> attribute("return"), attribute("rise")
    ('return_', 'rise')
    """
    return f"{name}_" if iskeyword(name) else name


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


def table(kind: type[Table]) -> FieldReader:
    """Read a table with the keys of its kind."""

    def reader(value: object, path: Path, refused: Refusals) -> Any:
        found = _parts((kind,), value, path, refused)
        return REFUSED if found is REFUSED else found[kind]

    return FieldReader(reader, lambda: form_of((kind,)), "table", (((), kind),))


def form_of(kinds: Kinds) -> Form:
    """Give the form of a table as a JSON Schema: its keys, which of them it must have, and no others."""
    holders = holders_of(kinds)
    properties = {
        name: {"description": parts[0].keys[name].meaning, **_form(parts, name)} for name, parts in holders.items()
    }
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


@cache
def holders_of(kinds: Kinds) -> Mapping[str, Kinds]:
    """Give each key of a table with the kinds that state it; of a key of several each reads a part of its table."""
    names = dict.fromkeys(name for kind in kinds for name in kind.keys)
    return {name: tuple(kind for kind in kinds if name in kind.keys) for name in names}


def _form(holders: Kinds, name: str) -> Form:
    return holders[0].keys[name].field.form() if len(holders) == 1 else form_of(_inner(holders, name))


def _required(holders: Kinds, name: str) -> bool:
    return any(kind.keys[name].default is REQUIRED for kind in holders)


def _inner(holders: Kinds, name: str) -> Kinds:
    return tuple(kind.keys[name].field.tables[0][1] for kind in holders)


def _parts(kinds: Kinds, value: object, path: Path, refused: Refusals) -> Any:
    """Read one table of the file as the kinds that share it; none is made where anything in it is refused."""
    if not isinstance(value, dict):
        refused.append(Refusal(path, kinds[0].bare, {}, value))
        return REFUSED
    before, values, holders = len(refused), {kind: dict[str, Any]() for kind in kinds}, holders_of(kinds)
    for name, parts in holders.items():
        if name in value:
            for kind, found in _key(parts, name, value[name], (*path, name), refused):
                values[kind][name] = found
        elif _required(parts, name):
            refused.append(Refusal((*path, name), "missing", {}, value))
    refused += [Refusal((*path, name), "unknown_key", {}, value[name]) for name in value if name not in holders]
    said = {name: found for read in values.values() for name, found in read.items() if isinstance(found, str)}
    refused += [refusal(wrong, value, path) for kind in kinds for wrong in kind.misfits({**value, **said})]
    if len(refused) > before:
        return REFUSED
    made = {kind: kind(**values[kind]) for kind in kinds}
    results = [checked(part.check, value, path, refused) for part in made.values()]
    return REFUSED if any(result is REFUSED for result in results) else made


def _key(holders: Kinds, name: str, value: object, path: Path, refused: Refusals) -> list[tuple[type[Table], Any]]:
    if len(holders) == 1:
        return [(holders[0], holders[0].keys[name].field.read(value, path, refused))]
    found = _parts(_inner(holders, name), value, path, refused)
    return [] if found is REFUSED else list(zip(holders, found.values(), strict=True))
