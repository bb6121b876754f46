"""What report and sheet say of loads: the working stroke in words, forces between two links at both their ends."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from drawings.commands import cli
from plans.linkage.study import LinkageStudy
from plans.model.machine import ways
from plans.scene.scene import parse_scene
from tests.plans.test_loading import ENGINE, ROCKER

CASES = Path(__file__).parents[1] / "cases/loads"


def written(tmp_path: Path, name: str, *changes: tuple[str, str]) -> tuple[str, str]:
    """Draw a scene; give its report and its first sheet of forces."""
    text = (CASES / f"{name}.toml").read_text("utf-8")
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    scene = tmp_path / f"{name}.toml"
    scene.write_text(text, "utf-8")
    assert cli.main(["draw", str(scene), "-o", str(tmp_path)]) == 0
    return tuple((tmp_path / f"{name}{end}").read_text("utf-8") for end in ("-report.md", "-forces.svg"))  # type: ignore[return-value]


@pytest.mark.rest
def test_a_report_says_which_way_the_working_stroke_goes(tmp_path: Path) -> None:
    report, _ = written(tmp_path, "pumping-jack", ('language = "ru"', 'language = "en"'))
    line = (
        "Working stroke: counter-clockwise, up, the faster of the two; "
        "the crank turns 163.8029° over it, 196.1971° over the idle stroke"
    )
    assert f"\n- {line}\n" in report
    assert f"\n- Pш over the stroke. {line}\n" in report
    assert "K = 1.19776298 of the slower, idle stroke over the faster, working one" in report


@pytest.mark.rest
def test_without_a_choice_only_the_loads_tell_the_working_stroke(tmp_path: Path) -> None:
    report, _ = written(tmp_path, "pumping-jack", ('working = "up"\n', ""))
    assert "\n- Рабочий ход" not in report
    assert "- Pш по ходу. Рабочий ход: по часовой стрелке, вниз, более медленный из двух; кривошип" in report
    assert "быстрее" not in report


@pytest.mark.rest
def test_a_force_between_two_links_stands_on_the_sheet_at_both_ends(tmp_path: Path) -> None:
    report, sheet = written(tmp_path, "pump", ('language = "ru"', 'language = "en"\nlettering = "text"'))
    assert "- P between B of link 2 and C of link 3, always" in report
    letters = re.findall(r">(P′?)<", sheet)
    assert letters.count("P") >= 2  # the scheme and the polygon
    assert letters.count("P′") >= 2
    assert "P = 3000" in sheet
    assert "between B and C, along AB" in re.sub(r"<[^>]*>", "", sheet).replace("\N{NO-BREAK SPACE}", " ")


@pytest.mark.parametrize(
    ("text", "named"),
    [
        (ENGINE, ("left",)),
        (ENGINE.replace("[0, 0] }", "[0, 0], angle = 90 }").replace("B = [0.5, 0]", "B = [0, 0.5]"), ("down",)),
        (
            ENGINE.replace("[0, 0] }", "[0, 0], angle = 30 }").replace("B = [0.5, 0]", "B = [0.4, 0.3]"),
            ("left", "down"),
        ),
        (ENGINE.replace("[0, 0] }", "[0, 0], angle = 8 }"), ("left",)),
        (ROCKER, ("clockwise",)),
        (ROCKER + '[output]\npoint = "B"\n', ("clockwise", "right", "up")),
    ],
)
def test_the_way_of_a_stroke_in_words(text: str, named: tuple[str, ...]) -> None:
    """From the outer dead centre the slider goes in; the rocker's end above C from 0.3 to 0.5 from O, to the right."""
    study = LinkageStudy(parse_scene(text))
    low, high = (0.5, 0.3) if "AB" in text and "CB" not in text else (2.5, 1.5)
    assert ways(study.mechanism, study.output, low, high) == named


@pytest.mark.rest
def test_a_load_that_rests_on_a_reversal_is_told(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    said = "its point reverses 4 times in a turn, at 19.96°, 151.1°, 204.8°, 259.3°. If it should act"
    english = ('language = "ru"', 'language = "en"')
    report, _ = written(tmp_path, "press", english, ('during = "working direction"\n', ""))
    out = capsys.readouterr().out
    assert said in out
    assert said in report
    assert 'write during = "working direction"' in out


@pytest.mark.rest
def test_a_load_that_follows_its_stroke_rests_on_no_reversal(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    said, english = "its point reverses", ('language = "ru"', 'language = "en"')
    report, _ = written(tmp_path, "press", english)
    assert said not in capsys.readouterr().out + report
    assert "F_us at G of link 7, wherever it goes as on the working stroke" in report
