"""Tables of a scene: closed, frozen, read to the end whatever is refused."""

from __future__ import annotations

from typing import Any

import pytest

from plans.scene.faults import wrong
from plans.scene.readers import Check, Refused, either, many, named, one
from plans.scene.tables import Table, key, read, table


def even(value: Any) -> int:
    if not isinstance(value, int) or value % 2:
        raise wrong("not_whole", least=2)
    return value


def few(value: Any) -> None:
    if len(value) > 3:
        raise wrong("empty")


class Inner(Table):
    size: int = key(one(even))
    name: str = key(one(str), "pin")

    def check(self) -> None:
        if self.name == "pin" and "name" in self.given:
            raise wrong("repeated", entry="pin", at=("name",))


class Outer(Table):
    inner: Inner = key(table(Inner))
    sizes: tuple[int, ...] = key(many(one(even), Check(few)), ())
    named: dict[str, int] = key(named(one(str.upper), one(even)), {})
    form_or_size: Any = key(either(dict, table(Inner), one(even)), None)


def refused(data: object) -> list[tuple[tuple[str | int, ...], str]]:
    with pytest.raises(Refused) as found:
        read(Outer, data)
    return [(refusal.path, refusal.kind) for refusal in found.value.refusals]


def test_all_refusals_come_at_once_and_each_where_it_stands() -> None:
    data = {"inner": {"size": 3, "nmae": 1}, "sizes": [4, 5, 7], "named": {"a": "b"}, "form_or_size": {}, "other": 0}
    assert refused(data) == [
        (("inner", "size"), "not_whole"),
        (("inner", "nmae"), "unknown_key"),
        (("sizes", 1), "not_whole"),
        (("sizes", 2), "not_whole"),
        (("named", "a"), "not_whole"),
        (("form_or_size", "size"), "missing"),
        (("other",), "unknown_key"),
    ]


@pytest.mark.parametrize("data", [None, 1, "x", []])
def test_no_table_is_refused_as_one(data: object) -> None:
    assert refused(data) == [((), "not_a_table")]
    assert refused({"inner": data}) == [(("inner",), "not_a_table")]


def test_a_table_is_frozen_and_shows_its_keys() -> None:
    found = Inner(size=2, name="pin")
    with pytest.raises(AttributeError, match="Inner is frozen"):
        found.size = 3
    assert repr(found) == "Inner(size=2, name='pin')"


def test_what_is_given_is_read_and_the_rest_stands_as_declared() -> None:
    found = read(Outer, {"inner": {"size": 2}, "sizes": [4, 6], "named": {"a": 8}, "form_or_size": {"size": 2}})
    assert (found.inner.size, found.inner.name, found.sizes, found.named) == (2, "pin", (4, 6), {"A": 8})
    assert found.form_or_size == found.inner == Inner(size=2) != Inner(size=4)
    assert found.inner.given == {"size"}
    assert read(Outer, {"inner": {"size": 2}, "form_or_size": 4}).form_or_size == 4
