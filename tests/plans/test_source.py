"""The source of a scene: bytes read safely, TOML's refusals explained, and every key found in the text."""

from __future__ import annotations

import time

import pytest
from hypothesis import given
from hypothesis import strategies as st

from geometry.errors import LimitError
from plans.scene import faults, source
from plans.scene.faults import SceneError
from plans.scene.guard import Places
from plans.scene.source import parse_source
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
