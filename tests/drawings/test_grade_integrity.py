"""Marks won fairly: neither all arrows at once nor another's sheet nor what is hidden is taken for an answer."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import pytest

from drawings.commands import cli
from drawings.grading.allowance import Allowances
from drawings.grading.feedback import feedback
from drawings.grading.graded import UNREAD, SheetTask, grade
from tests.drawings.form_students import form_leaf, on_form, polygon_on_form
from tests.drawings.students import Task, task
from tests.gallery import GALLERY

HAND = Allowances()


@pytest.fixture(scope="module")
def own() -> Task:
    return task("slider-crank")


def of(own: Task) -> str:
    return own.originals.drawn(own.originals.sheets[0]).decode()


@pytest.mark.parametrize(
    "how",
    [lambda path: path + back(path), lambda path: path.replace("marker-end", "marker-start:url(#head);marker-end")],
    ids=["a second arrow back", "heads at both ends"],
)
@pytest.mark.parametrize(("scene", "name"), [("slider-crank", "velocities"), ("fan", "couples")])
def test_arrows_that_go_both_ways_answer_nothing(scene: str, name: str, how: Callable[[str], str]) -> None:
    own, leaf = task(scene), form_leaf(scene)
    plan = next(plan for plan in own.plans if plan.plan == name)
    free = bool(plan.vectors[0].letter)
    source = (polygon_on_form(leaf, plan, 0.8) if free else on_form(leaf, [plan], plan.scales[name])).decode()
    path = re.search(r"<path [^>]*marker-end[^>]*>", source)
    assert path is not None
    both = (source, source.replace(path[0], how(path[0])))
    first, again = (grade(text.encode(), SheetTask(own.plans), HAND) for text in both)
    assert "doubled" not in {one.kind for one in first.verdicts}
    told = [(one.kind, one.of) for one in again.verdicts if (one.plan, one.position) == plan.place]
    assert told == [("doubled", " ".join(filter(None, plan.vectors[0].letters)))]  # and nothing of it is right
    assert b"twice" in feedback(Path("ann.svg"), b"", again, {}, "en")


def back(path: str) -> str:
    """Draw an arrow's way back."""
    by = re.search(r'd="m (\S+),(\S+) (\S+),(\S+)"', path)
    if by is None:
        return re.sub(r'd="M (\S+) L ([^"]+)"', r'd="M \2 L \1"', path)
    x, y, wide, high = map(float, by.groups())
    return path.replace(by[0], f'd="m {x + wide:.4f},{y + high:.4f} {-wide:.4f},{-high:.4f}"')


def test_a_right_plan_that_is_hidden_counts_for_nothing(own: Task) -> None:
    text = of(own)
    start, end = text.index("<g "), text.rindex("</svg>")
    for how in ('style="display:none"', 'opacity="0"'):
        source = f"{text[:start]}<g {how}>{text[start:end]}</g>{text[end:]}".encode()
        graded = grade(source, SheetTask(own.plans), HAND)
        assert graded.outcome == UNREAD, how


@pytest.mark.rest
def test_a_fan_of_marks_of_one_name_is_rejected(own: Task) -> None:
    text = of(own)
    mark = re.search(r'<line [^>]*data-kind="vector"[^>]*/>', text)
    assert mark is not None
    graded = grade(text.replace(mark[0], mark[0] * 1000).encode(), SheetTask(own.plans), HAND)
    assert (graded.outcome, "on the sheet twice" in str(graded.reason)) == (UNREAD, True)


def test_the_sheet_of_another_scene_is_told(own: Task, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    scene = tmp_path / "variant.toml"
    scene.write_text((GALLERY / "slider-crank.toml").read_text("utf-8") + "\n# of Bob\n", encoding="utf-8")
    sheet = tmp_path / "ann.svg"
    sheet.write_text(of(own), encoding="utf-8")
    assert cli.main(["grade", str(scene), str(sheet)]) == 0  # its numbers are the same
    assert "by their data of another scene" in capsys.readouterr().err
    graded = grade(sheet.read_bytes(), SheetTask(own.plans), HAND)
    assert graded.scene == own.originals.digest


@pytest.mark.parametrize(
    ("source", "what"),
    [
        (b"  0\r\nSECTION\r\n  2\r\nHEADER\r\n", "a DXF drawing"),
        (b"AC1032\0\0", "a DWG drawing"),
        (b"%PDF-1.7\n", "a PDF"),
        (b"\xff\xd8\xff\xe0JFIF", "a JPEG"),
        (b"%!PS-Adobe-3.0", "a PostScript file"),
    ],
)
def test_what_is_no_svg_is_told_what_it_is(own: Task, source: bytes, what: str) -> None:
    graded = grade(source, SheetTask(own.plans), HAND)
    assert (graded.outcome, f"this is {what}, not an SVG sheet" in str(graded.reason)) == (UNREAD, True)
