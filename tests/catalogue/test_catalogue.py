"""The catalogue of bad and odd scenes: one issue a row, with the exit code and the words that it must lead to."""

from __future__ import annotations

import re
import time
from pathlib import Path

import pytest

from geometry.errors import DraftError, LimitError
from plans.linkage.reading.linkage import mechanism_of
from plans.scene.faults import SceneError
from plans.scene.scene import read_scene
from tests.catalogue.scenes import COMMANDS, FAULTS, SOUND, Row, changed
from tests.rows import over


def outcome(path: Path) -> tuple[int, str]:
    try:
        scene = read_scene(path)
        if "linkage" in scene.techniques:
            mechanism_of(scene)
        if faults := scene.meaning.faults:
            raise SceneError(faults)
    except LimitError as error:
        return 8, str(error)
    except DraftError as error:
        assert all(re.search("[а-я]{3}", fault.worded("ru")) for fault in getattr(error, "faults", ()))
        return 3, str(error)
    return 0, ""


@over("row", FAULTS)
def test_a_scene_of_the_catalogue_ends_as_its_row_says(row: Row, tmp_path: Path) -> None:
    expected, wanted = row.given.get("code", 3), row.told("says")
    began = time.perf_counter()
    path = row.written(tmp_path)
    code, message = outcome(path)
    assert time.perf_counter() - began < 30  # a hang, not a speed: under a second on a quiet machine
    assert code == expected, message
    assert all(words in message for words in wanted), message
    # One issue a row: what follows from it is not said as well. Each is told in one line with file, line and column.
    assert len(message.splitlines()) == len(wanted), message
    for line in message.splitlines():
        assert re.match(re.escape(str(path)) + r":(\d+:\d+: .*expected .*\. Fix: \S.*|.*_LIMIT)", line), line


@over("name", SOUND)
def test_what_the_rows_are_made_of_is_sound(name: str, tmp_path: Path) -> None:
    (path := tmp_path / "scene.toml").write_text(SOUND[name], "utf-8")
    assert outcome(path) == (0, "")


def test_a_row_changes_what_stands_in_its_sound_scene_just_once() -> None:
    assert (
        changed("a\nb\n", {"replace": [["a", "c"]], "after": [["b", "d"]], "remove": ["c"], "add": "e"}) == "b\nd\ne\n"
    )
    for given in ({"replace": [["x", "y"]]}, {"remove": ["x"]}, {"after": [["x", "y"]]}):
        for text in ("", "x\nx\n"):
            with pytest.raises(ValueError, match="times in the sound scene"):
                changed(text, given)


def test_no_two_rows_have_one_name() -> None:
    names = [row.name for row in (*FAULTS, *COMMANDS)]
    assert len(names) == len(set(names)) > 340
