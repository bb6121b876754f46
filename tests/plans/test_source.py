"""The source of a scene: bytes read safely, TOML's refusals explained, and every key found in the text."""

from __future__ import annotations

import os
import time
import tomllib
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from geometry.errors import LimitError
from plans.scene import faults, source
from plans.scene.faults import SceneError
from plans.scene.guard import Places
from plans.scene.source import parse_source, read_source
from tests.parts import examples, some

NESTED = '''# a comment with [brackets] and "quotes
title = "x = 1" # speed = 3
[mechanism.frame]
O = [0, 0]
"O'" = [
  1, # first
  2,
]
[mechanism]
lengths.AB = 1
lengths . "CD" = 2
text = """
OA = 3
"""
[[mechanism.slides]]
link = 2
along = { through = [0, 0.25], angle = 0 }
[[mechanism.slides]]
link = 5
[mechanism.slides.along]
angle = 90
'''


@pytest.mark.parametrize(
    ("path", "place", "written"),
    [
        (("title",), (2, 1), '"x = 1"'),
        (("mechanism", "frame", "O"), (4, 1), "[0, 0]"),
        (("mechanism", "frame", "O", 1), (4, 9), "0"),
        (("mechanism", "frame", "O'"), (5, 1), "[\n  1, # first\n  2,\n]"),
        (("mechanism", "frame", "O'", 1), (7, 3), "2"),
        (("mechanism", "lengths", "AB"), (10, 1), "1"),
        (("mechanism", "lengths", "CD"), (11, 1), "2"),
        (("mechanism", "text"), (12, 1), '"""\nOA = 3\n"""'),
        (("mechanism", "slides", 0), (15, 1), ""),
        (("mechanism", "slides", 0, "along", "angle"), (17, 32), "0"),
        (("mechanism", "slides", 0, "along", "through", 1), (17, 25), "0.25"),
        (("mechanism", "slides", 1, "link"), (19, 1), "5"),
        (("mechanism", "slides", 1, "along", "angle"), (21, 1), "90"),
        (("mechanism", "slides", 1, "point"), (18, 1), ""),  # missing: the table that lacks it
        (("drive", "speed"), (1, 1), ""),
    ],
)
def test_a_key_is_found_in_every_form_of_toml(path: faults.Path, place: tuple[int, int], written: str) -> None:
    read = parse_source(NESTED, "scene.toml")
    assert read.place(path) == place
    assert read.places.written(path) == written


KEYS = st.one_of(
    st.from_regex(r"[A-Za-z0-9_-]{1,4}", fullmatch=True),
    st.sampled_from(["O'", "a b", "a.b", "[x]", "#", "имя", "q=1"]),
)
SCALARS = st.sampled_from(["1", "-0.5", "true", '"a # b"', "'[1]'", '"\\" ]"', '"""\n[x]\n"""', "1979-05-27 07:32:00"])


def quoted_key(key: str) -> str:
    return key if faults.BARE.fullmatch(key) else f'"{key}"'


def values(deep: int) -> st.SearchStrategy[str]:
    if not deep:
        return SCALARS
    inner = values(deep - 1)
    arrays = st.lists(inner, max_size=3).map(lambda parts: "[\n  " + ",\n  ".join(parts) + " # end ]\n]")
    pairs = st.dictionaries(KEYS, SCALARS.filter(lambda text: "\n" not in text), max_size=3)
    tables = pairs.map(lambda table: "{ " + ", ".join(f"{quoted_key(k)} = {v}" for k, v in table.items()) + " }")
    return st.one_of(SCALARS, arrays, tables)


@st.composite
def texts(draw: st.DrawFn) -> str:
    lines: list[str] = []
    names = draw(st.lists(KEYS, unique=True, max_size=4))
    for number, name in enumerate(names):
        array = draw(st.booleans())
        for _ in range(draw(st.integers(1, 3)) if array else 1):
            header = f"{quoted_key(name)}.sub{number}"
            lines.append(f"[[{header}]]" if array else f"[{header}]  # {number}")
            for key, value in draw(st.dictionaries(KEYS, values(2), max_size=3)).items():
                lines.append(f"{quoted_key(key)} . {quoted_key(key)} = {value}" if draw(st.booleans()) else "")
                lines.append(f"  other{number}{len(lines)} = {value}")
    return draw(st.sampled_from(["\n", "\r\n"])).join(lines) + "\n"


def leaves(value: Any, path: faults.Path = ()) -> list[tuple[faults.Path, Any]]:
    if isinstance(value, dict):
        return [leaf for key, inner in value.items() for leaf in leaves(inner, (*path, key))]
    if isinstance(value, list):
        return [leaf for index, inner in enumerate(value) for leaf in leaves(inner, (*path, index))]
    return [(path, value)]


@pytest.mark.rest
@examples(2)
@given(texts())
def test_what_stands_at_a_path_is_its_value(text: str) -> None:
    tables = tomllib.loads(text)
    places = Places(text)
    assert places.duplicate is None
    for path, value in leaves(tables):
        written = places.written(path)
        assert tomllib.loads(f"value = {written}")["value"] == value
        if isinstance(path[-1], str):
            key = text[places.offset(path) :].lstrip("{ ")
            assert key.startswith((quoted_key(path[-1]), quoted_key(path[-1])[:1]))


@given(st.text(alphabet="ab.[]{}=,\"'#\n\\ 1“", max_size=60))
@examples(20)
def test_any_text_is_read_or_refused(text: str) -> None:
    Places(text)
    try:
        parse_source(text, "scene.toml")
    except (SceneError, LimitError) as error:
        assert str(error).startswith("scene.toml:")


@given(st.binary(max_size=60))
def test_any_bytes_are_text_or_refused(data: bytes) -> None:
    try:
        source._text(data, "scene.toml")
    except SceneError as error:
        assert str(error).startswith("scene.toml:")


def refusal(path: Path, data: bytes) -> str:
    path.write_bytes(data)
    with pytest.raises(SceneError) as refused:
        read_source(path)
    return str(refused.value)


def test_a_mark_at_the_start_of_the_file_is_accepted(tmp_path: Path) -> None:
    path = tmp_path / "scene.toml"
    path.write_bytes(b"\xef\xbb\xbftitle = 'x'\n")
    assert read_source(path).tables == {"title": "x"}


def test_other_encodings_are_named(tmp_path: Path) -> None:
    path = tmp_path / "scene.toml"
    assert "UTF-16" in refusal(path, "title = 1".encode("utf-16"))
    assert "UTF-32" in refusal(path, "title = 1".encode("utf-32"))
    message = refusal(path, "a = 1\ntitle = 'Кривошип'".encode("cp1251"))
    assert "scene.toml:2:10: expected text in UTF-8, but byte 15 is not" in message
    assert "not a text file" in refusal(path, b"PK\x03\x04\x00\x00\xff\xfe")
    assert "not a text file" in refusal(path, b"a = 1\n\x00")


def test_only_regular_files_are_read(tmp_path: Path) -> None:
    with pytest.raises(OSError, match="not a regular file"):
        read_source(tmp_path)
    with pytest.raises(FileNotFoundError):
        read_source(tmp_path / "no.toml")
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    with pytest.raises(OSError, match="not a regular file"):
        read_source(pipe)
    with pytest.raises(OSError, match="not a regular file"):
        read_source(Path("/dev/zero"))


HOSTILE = {
    "dotted key": ".".join("a" * 100_000) + " = 1",
    "dotted key of quoted parts": " . ".join(["'a'"] * 100_000) + " = 1",
    "dotted header": "[" + ".".join("a" * 100_000) + "]",
    "arrays": "a = " + "[" * 100_000,
    "inline tables": "a = " + "{b=" * 100_000,
    "integer": "a = " + "1" * 5_000,
    "open strings": '"""\\' * 200_000,
    "quotes": "'" * 1_000_000,
    "bare word": "a" * 1_000_000,
    "blanks": "a" + " " * 1_000_000 + ".",
    "brackets": "[]" * 500_000,
    "lines": "[[a]]\n" * 100_000 + "x",
    "commas": "a = [" + "1," * 500_000 + "]",
    "long line": "a = 1" + "\u2212" * 300_000,
    "equals": "=" * 1_000_000,
    "word and equals": "b = " + "a " * 400_000 + "'",
    "backslashes": 'a = "' + "\\" * 1_000_001,
    "duplicates": "a = 1\n" * 100_000,
}


@pytest.mark.parametrize("text", some(HOSTILE.values(), 6, HOSTILE))
def test_a_hostile_text_is_refused_at_once(text: str) -> None:
    began = time.perf_counter()
    with pytest.raises((SceneError, LimitError)):
        parse_source(text, "scene.toml")
    assert time.perf_counter() - began < 30  # a hang, not a speed: under a second on a quiet machine


def test_a_file_beyond_the_limit_is_not_read(tmp_path: Path) -> None:
    path = tmp_path / "scene.toml"
    path.write_bytes(b"#" * (source.SIZE_LIMIT + 1))
    with pytest.raises(LimitError, match="SIZE_LIMIT"):
        read_source(path)
    path.write_bytes(b"#" * source.SIZE_LIMIT)
    assert read_source(path).tables == {}
