"""The catalogue of bad and odd scenes: one issue a file, with the exit code and the words that it must lead to."""

from __future__ import annotations

import re
import time
from pathlib import Path

from geometry.errors import DraftError, LimitError
from plans.linkage.reading.linkage import mechanism_of
from plans.scene.scene import read_scene
from tests.rows import over

SCENES = sorted(Path(__file__).parent.glob("*.toml"))
EXPECTED = re.compile(r"# expect (\d+)(?:: (.*))?")


def outcome(path: Path) -> tuple[int, str]:
    try:
        scene = read_scene(path)
        if "linkage" in scene.techniques:
            mechanism_of(scene)
    except LimitError as error:
        return 8, str(error)
    except DraftError as error:
        return 3, str(error)
    return 0, ""


@over("path", SCENES)
def test_a_scene_of_the_catalogue_ends_as_its_header_says(path: Path) -> None:
    expected = [match for line in path.read_text().splitlines() if (match := EXPECTED.fullmatch(line))]
    began = time.perf_counter()
    code, message = outcome(path)
    assert time.perf_counter() - began < 30  # a hang, not a speed: under a second on a quiet machine
    assert expected
    for match in expected:
        assert code == int(match[1]), message
        assert (match[2] or "") in message
    # One issue a file: what follows from it is not said as well.
    assert len(message.splitlines()) == (len(expected) if code else 0), message


def test_each_fault_is_one_line_with_file_line_and_column() -> None:
    for path in SCENES:
        for line in outcome(path)[1].splitlines():
            assert re.match(re.escape(str(path)) + r":(\d+:\d+: .*expected .*\. Fix: \S.*|.*_LIMIT)", line), line
