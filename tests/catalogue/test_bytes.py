"""The catalogue's rows that no scene file can hold: odd bytes, odd files, hostile sizes; each made here and refused."""

from __future__ import annotations

import os
import time
import tomllib
import tracemalloc
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from drawings.commands import cli
from geometry.errors import LimitError
from plans.scene import source
from plans.scene.faults import SceneError
from plans.scene.scene import parse_scene
from plans.scene.source import language_of, parse_source

PLAIN = (Path(__file__).parent / "plain.toml").read_text("utf-8")
Solve = Callable[[bytes], tuple[int, str]]


def changed(old: str, new: str) -> str:
    assert old in PLAIN
    return PLAIN.replace(old, new, 1)


@pytest.fixture
def solve(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> Solve:
    """Solve a scene of some bytes: exit code and stderr."""

    def command(data: bytes) -> tuple[int, str]:
        path = tmp_path / "scene.toml"
        path.write_bytes(data)
        code = cli.main(["solve", str(path)])
        return code, capsys.readouterr().err.replace(f"{path}:", "")

    return command


# Row of the catalogue and what it is; the bytes, or what makes them if they are many; exit code; what stderr says.
BYTES: dict[str, tuple[str | bytes | Callable[[], bytes], int, str]] = {
    "A2 only comments": (b"# one\n# two\n", 3, "say what to draw: [mechanism], [drive]"),
    "A2 only a mark": (b"\xef\xbb\xbf", 3, "say what to draw: [mechanism], [drive]"),
    "A3 a mark at the start": ("\ufeff" + PLAIN, 0, "byte order mark (BOM); it was left aside"),
    "A4 a mark in the middle": (changed("[drive]", "\ufeff[drive]"), 3, "15:1: expected only visible characters"),
    "A5 CRLF": (PLAIN.replace("\n", "\r\n"), 0, ""),
    "A6 bare CR": (changed("0.100\n", "0.100\r"), 3, "10:11: expected lines that end with LF or CRLF. Fix: save"),
    "A7 UTF-16 with a mark": (PLAIN.encode("utf-16"), 3, "1:1: expected text in UTF-8, but the file is in UTF-16"),
    "A7 UTF-16 without": (PLAIN.encode("utf-16-le"), 3, "1:1: expected text in UTF-8, but the file is in UTF-16"),
    "A7 UTF-16 from the other end": (PLAIN.encode("utf-16-be"), 3, "but the file is in UTF-16"),
    "A7 UTF-32": (PLAIN.encode("utf-32"), 3, "1:1: expected text in UTF-8, but the file is in UTF-32"),
    "A8 cp1251": (b"\n# " + "Кривошип".encode("cp1251"), 3, "2:3: expected text in UTF-8, but byte 3 is not"),
    "A8 latin-1": (changed("start = 0", 'start = "45°"').encode("latin-1"), 3, "save the file as UTF-8"),
    "A9 a NUL": (PLAIN.encode() + b"\0", 3, "19:1: expected a scene in TOML, but this is not a text file"),
    "A9 a control byte": (changed("0.100", "\x010.100"), 3, "10:6: expected only visible characters, but found U+0001"),
    "A9 a bell in a title": (changed("Crank", "\aCrank"), 3, "1:10: expected only visible characters"),
    "A16 hexadecimal with a unit": (changed("0.100", '"0x10 mm"'), 3, "expected a unit of length"),
    "A16 underscores with a unit": (changed("0.100", '"1_00 mm"'), 3, "expected a number with a unit"),
    "A19 an integer of 5,000 digits": (changed("0.100", "1" * 5000), 3, "10:6: expected a number of reas"),
    "A19 a number of 5,000 digits": (changed("0.100", "0.1" + "0" * 5000), 0, ""),
    "A20 50 MB of text": (lambda: PLAIN.encode() + b"# " + b"x" * 50_000_000, 8, "SIZE_LIMIT = 1048576"),
    "A20 a million keys": (lambda: b"".join(map(b"k%d=1\n".__mod__, range(1_000_000))), 8, "SIZE_LIMIT = 1048576"),
    "A20 as many keys as fit": (lambda: b"".join(b"k%d=1\n" % k for k in range(100_000)), 3, "and 99981 more"),
    "A21 a ZIP": (b"PK\x03\x04" + bytes(range(256)) * 8, 3, "this is not a text file"),
    "A21 a PNG": (b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR" + bytes(range(256)), 3, "this is not a text file"),
    "A23 a JSON list": (b'[\n  {"title": "x"}\n]\n', 3, "this looks like JSON"),
    "A23 YAML": (b"mechanism:\n  frame:\n    O: [0, 0]\n", 3, "1:1: expected a scene in TOML, but this looks"),
    "A23 YAML with a head": (b"---\ntitle: x\n", 3, "this looks like YAML"),
    "B2 a length in [drive]": ((PLAIN + "\nOA = 3\n"), 3, "it belongs to [mechanism.lengths]"),
    "B2 a key of [drive] at the top": (("speed = 3\n" + PLAIN), 3, "it belongs to [drive]"),
    "B4 nan in quotes": (changed('"10 rad/s"', '"nan rad/s"'), 3, "expected a number with a unit (angular"),
    "B5 1e999 in quotes": (changed('"10 rad/s"', '"1e999 rad/s"'), 3, 'drive.speed = "1e999 rad/s": expected'),
    "B13 two speeds": (changed("start = 0", 'n = "900 rpm"'), 3, "18:1: drive.n = \"900 rpm\": expected a key"),
    "B13 the speed twice": (changed("start = 0", 'speed = "900 rpm"'), 3, "18:1: expected each name once"),
    "B15 less than nothing": (changed("start = 0", "start = -30"), 0, ""),
    "B15 a million degrees": (changed("start = 0", "start = 1e6"), 0, ""),
    "B19 a length a trillion times another": (
        changed("0.100", "1e-6").replace("0.400", "1e6"), 3, "a ratio of the longest to the shortest length",
    ),
    "B20 negative": ((PLAIN + "\npositions = -3"), 3, "a whole number from 1"),
    "B20 text": ((PLAIN + '\npositions = "12"'), 3, "but found text. Fix: write it as positions = 12"),
    "B21 a turn more": (changed("start = 0", "positions = [0, 90, 360]"), 3, "360 deg is repeated"),
    "B23 an empty list of slides": ("mechanism.slides = []\n" + PLAIN, 0, ""),
    "B23 an empty list of positions": ((changed("start = 0", "positions = []")), 3, "at least one entry"),
    "B25 a program": (changed("0.100", '"__import__(\'os\').getcwd()"'), 3, "expected a number with a unit"),
    "B25 a product": (changed("0.100", '"2*3 mm"'), 3, "expected a number with a unit"),
    "C1 a point twice": (changed("O = [0, 0]", "O = [0, 0]\nO = [1, 1]"), 3, "it is written here and on line 3"),
    "C2 the sign of kelvin": (changed("O = [0, 0]", 'O = [0, 0]\n"\u212a" = [0, 2]'), 3, "the name of a point"),
    "C3 only an accent": (changed("O = [0, 0]", 'O = [0, 0]\n"\u0301" = [0, 0]'), 3, "the name of a point"),
    "C6 a control character": (changed('"Crank', '"\\u0000Crank'), 3, "expected visible text, but found U+0000"),
    "C6 half a character": (changed('"Crank', '"\\ud800Crank'), 3, "not a Unicode scalar value"),
    "C7 10,000 letters": (changed("Crank", "w" * 10_000), 3, "text of at most 1000 characters"),
    "C13 no name": (changed('"AB"', '["A", ""]'), 3, "the name of a point"),
    "C13 a number": (changed('"AB"', '["A", "7"]'), 3, "the name of a point"),
    "C13 no letters": (changed('"AB"', '""'), 3, "letters of points"),
    "D9 no frame": (changed("O = [0, 0]\nC = [0.350, 0]", ""), 3, "mechanism.frame: expected at least one entry"),
}  # fmt: skip


# Left to the whole run: a reader of many keys is asked every day in tests/plans/test_scene.py.
LONG = "A20 as many keys as fit"


@pytest.mark.parametrize(
    ("data", "code", "says"),
    [pytest.param(*row, id=name, marks=pytest.mark.rest if name == LONG else ()) for name, row in BYTES.items()],
)
def test_odd_bytes_end_the_command_with_one_code_and_one_message(
    solve: Solve, data: str | bytes | Callable[[], bytes], code: int, says: str
) -> None:
    data = data() if callable(data) else data
    ended, err = solve(data.encode() if isinstance(data, str) else data)
    assert ended == code, err
    assert says in err
    assert "Traceback" not in err


@pytest.mark.parametrize("kind", ["folder", "pipe", "zeros", "missing"])
@pytest.mark.skipif(os.name != "posix", reason="pipes and devices")
def test_a21_only_a_regular_file_is_a_scene(kind: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    paths = {"folder": tmp_path, "pipe": tmp_path / "pipe", "zeros": Path("/dev/zero"), "missing": tmp_path / "no"}
    os.mkfifo(paths["pipe"])
    assert cli.main(["solve", str(paths[kind])]) == 7
    out, err = capsys.readouterr()
    assert (out, len(err.splitlines())) == ("", 1)
    assert err.startswith(f"{paths[kind]}: ")
    assert language_of(paths[kind]) == "en"


def test_a22_a_scene_is_read_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path, opened = tmp_path / "scene.toml", []
    path.write_text(PLAIN, "utf-8")
    real = os.open
    monkeypatch.setattr(os, "open", lambda *given: opened.append(given) or real(*given))
    source.read_source(path)
    assert len(opened) == 1


def test_a22_a_file_that_vanishes_ends_with_7(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "scene.toml"
    path.write_text(PLAIN, "utf-8")
    assert path.exists()
    path.unlink()  # between the moment in which it was seen and that in which it is read
    assert cli.main(["solve", str(path)]) == 7


# What a pre-scan must refuse before tomllib sees it, with the limit that it names.
HOSTILE: dict[str, tuple[str, str]] = {
    "A17 10,000 parts": (".".join("a" * 10_000) + " = 1", "PARTS_LIMIT"),
    "A17 100,000 parts": (".".join("a" * 100_000) + " = 1", "PARTS_LIMIT"),
    "A17 100,000 parts in quotes": (" . ".join(["'a'"] * 100_000) + " = 1", "PARTS_LIMIT"),
    "A17 a header of 100,000 parts": ("[" + ".".join("a" * 100_000) + "]", "PARTS_LIMIT"),
    "A17 in an inline table": ("b = { " + ".".join("a" * 100_000) + " = 1 }", "PARTS_LIMIT"),
    "A18 1,000 lists": ("a = " + "[" * 1_000, "NESTING_LIMIT"),
    "A18 100,000 lists": ("a = " + "[" * 100_000 + "]" * 100_000, "NESTING_LIMIT"),
    "A18 100,000 inline tables": ("a = " + "{b=" * 100_000, "MARKS_LIMIT"),
    "A18 1,000 inline tables": ("a = " + "{b=" * 1_000 + "1" + "}" * 1_000, "NESTING_LIMIT"),
    "A20 a million commas": ("a = [" + "1," * 500_000 + "]", "MARKS_LIMIT"),
}
# Processor seconds for what takes a few hundredths; the parser would need minutes and gigabytes for most of them.
SECONDS, BYTES_USED = 0.25, 50_000_000


@pytest.mark.parametrize(("text", "limit"), HOSTILE.values(), ids=HOSTILE.keys())
def test_a_hostile_text_is_refused_before_it_is_parsed(text: str, limit: str, monkeypatch: pytest.MonkeyPatch) -> None:
    def parsed(*_: Any, **__: Any) -> None:
        raise AssertionError("tomllib was asked")

    monkeypatch.setattr(tomllib, "loads", parsed)
    took = []
    for _ in range(3):
        began = time.process_time()
        with pytest.raises(LimitError, match=limit):
            parse_source(text, "scene.toml")
        took.append(time.process_time() - began)
    assert min(took) < SECONDS
    tracemalloc.start()
    with pytest.raises(LimitError):
        parse_source(text, "scene.toml")
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < BYTES_USED


def test_what_is_just_within_the_limits_is_parsed() -> None:
    parse_source(".".join("a" * 16) + " = 1", "scene.toml")
    parse_source("a = " + "[" * 32 + "]" * 32, "scene.toml")
    with pytest.raises(LimitError):
        parse_source(".".join("a" * 17) + " = 1", "scene.toml")
    with pytest.raises(LimitError):
        parse_source("a = " + "[" * 33 + "]" * 33, "scene.toml")


def test_b20_ten_million_positions_are_refused_before_they_are_made() -> None:
    tracemalloc.start()
    with pytest.raises(LimitError, match="POSITIONS_LIMIT"):
        parse_scene(PLAIN + "\npositions = 10_000_000")
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 1_000_000


def test_b24_twenty_wrong_fields_are_told_once_each() -> None:
    wrong = "".join(f"{link} = {{ mass = -1, inertai = 3 }}\n" for link in range(1, 11))
    with pytest.raises(SceneError) as refused:
        parse_scene(PLAIN.replace('3 = "CB"', '3 = "CB"\n' + "".join(f'{k} = "C"\n' for k in range(4, 11)))
                    + "\n[masses]\n" + wrong)  # fmt: skip
    masses = [fault for fault in refused.value.faults if fault.path[0] == "masses"]
    assert len(masses) == len({fault.path for fault in masses}) == 20
    assert sum("masses." in line for line in str(refused.value).splitlines()) == 20


LANGUAGES = {
    "in its table": '[sheet]\nlanguage = "ru"\n',
    "in a faulty file": '[sheet]\nlanguage = "ru"\n[drive\nlink = =',
    "after a list": '[sheet]\nplans = [2, 8]\nlanguage="ru" # по-русски\n',
    "by a dotted key": 'sheet.language = "ru"\n[drive]\n',
    "in an inline table": "sheet = { format = 'A1', language = 'ru' }\n",
    "without quotes": "[sheet]\nlanguage = ru\n",
    "English": '[sheet]\nlanguage = "en"\n',
    "none": "[sheet]\n",
    "in another table": '[drive]\nlanguage = "ru"\n',
    "in a comment": '[sheet]\n# language = "ru"\n',
}


@pytest.mark.parametrize("where", LANGUAGES)
def test_the_language_is_found_in_any_file(where: str, tmp_path: Path) -> None:
    path = tmp_path / "scene.toml"
    expected = "en" if where in ("English", "none", "in another table", "in a comment") else "ru"
    for encoding in ("utf-8", "cp1251", "utf-16"):
        path.write_bytes(LANGUAGES[where].encode(encoding))
        assert language_of(path) == expected, encoding
