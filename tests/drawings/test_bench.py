"""plandraft bench: what it measures on paper, prints, keeps and plots. No test asks how long anything takes."""

from __future__ import annotations

import json
import math
import subprocess
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest

from drawings import VERSION
from drawings.bench import hands, plain_pen, plot, sessions, sheet
from drawings.bench.hands import FORCES_BY_HAND
from drawings.bench.sheet import DRAW
from drawings.commands import bench as command
from drawings.commands import cli
from drawings.commands.parser import parser
from drawings.lettering.lettering import outline
from drawings.paper.limits import QUANTUM
from drawings.paper.strokes import Arc, Circle, Group, Leaf, Line, LineStyle, Polyline, Text
from plans.bench import roads as forces
from plans.bench.error import SLIPS, sizes
from plans.bench.peers import PYLINKAGE
from plans.bench.roads import CONSTRUCTION, Ground, ground, newton, prepared
from plans.bench.trial import Bench, Goal, Order
from plans.scene.scene import Scene, parse_scene, read_scene
from tests.drawings.test_bench_report import TECHNIQUES, lines
from tests.drawings.test_commands import GAPPED

GALLERY = Path(__file__).parent.parent.parent / "drawings/gallery"
SVG = "{http://www.w3.org/2000/svg}"


def scene(name: str = "shaper") -> Scene:
    return read_scene(GALLERY / f"{name}.toml")


@pytest.fixture(scope="module")
def quick() -> Bench:
    """Run a short session on the shaper; its errors are tested, its times are only there."""
    return sessions.session(scene(), Order((12,), 1, startup=False), lambda what: None)


def test_a_session_has_a_row_for_every_technique(quick: Bench) -> None:
    rows = {row.technique: row for row in quick.rows}
    assert set(TECHNIQUES) <= set(rows)
    assert {hands.BY_HAND.format(slip) for slip in SLIPS} <= set(rows)
    assert all(rows[name].times and len(rows[name].times.seconds) == 1 for name in TECHNIQUES)
    assert "no four-bar" in rows[PYLINKAGE].note


def test_errors_stand_in_the_order_of_their_roads(quick: Bench) -> None:
    error = {row.technique: row.error for row in quick.rows if row.error is not None}
    ladder = [CONSTRUCTION[2], newton(1e-3), sheet.MEASURED, sheet.PRINTED, hands.BY_HAND.format(0.1)]
    assert [error[name] for name in ladder] == sorted(error[name] for name in ladder)
    assert error[hands.BY_HAND.format(0.2)] == pytest.approx(2 * error[hands.BY_HAND.format(0.1)], rel=0.05)


def test_a_session_says_what_its_numbers_mean(quick: Bench) -> None:
    told = " ".join(quick.words)
    for word in (
        "error:",
        "truth:",
        "50 digits",
        "accepted:",
        "time:",
        "median (quartiles)",
        "largest of its own plan",
    ):
        assert word in told
    assert "real hands" in told


@pytest.fixture(scope="module")
def paper() -> tuple[Ground, sheet.DrawnSheets]:
    """Draw the shaper's sheet by the bench's own road, once."""
    found = ground(scene(), 12, 24, sizes(prepared(scene(), 360)))
    return found, sheet.road(found).run()


@pytest.mark.rest
def test_what_is_measured_back_is_out_by_no_more_than_the_paper(paper: tuple[Ground, sheet.DrawnSheets]) -> None:
    """The ends of a vector are rounded to the sheet's last decimal: its error is a quantum times the plan's scale."""
    found, drawn = paper
    scales = {k: max(m.scale for m in drawn.measured.marks if m.quantity == k) for k in "rva"}
    errors = sheet.by_ruler(found.fresh(), drawn, found.truth, found.largest)
    for kind in "rva":
        assert 0 < errors.kinds[kind] <= 1.01 * QUANTUM * scales[kind] / found.largest[kind]
    assert set(errors.kinds) == set("rva")


def test_the_table_is_out_by_no_more_than_half_its_last_digit(quick: Bench) -> None:
    (row,) = (row for row in quick.rows if row.technique == sheet.PRINTED)
    largest = sizes(prepared(scene(), 360))
    assert row.errors is not None
    assert set(row.errors.kinds) == {"v", "a", "omega", "epsilon"}
    for kind, error in row.errors.kinds.items():
        last = 10.0 ** (math.floor(math.log10(largest[kind])) - 4)  # five digits of the largest
        assert 0 < error <= 0.51 * last / largest[kind]


@pytest.mark.parametrize("language", ["en", pytest.param("ru", marks=pytest.mark.rest)])
def test_a_spoilt_sheet_is_seen(language: str) -> None:
    """A vector drawn a millimetre too long and a number with a wrong first digit are errors of that size."""
    text = (GALLERY / "shaper.toml").read_text("utf-8").replace("[sheet]", f'[sheet]\nlanguage = "{language}"')
    wanted = parse_scene(text)
    found = ground(wanted, 12, 24, sizes(prepared(wanted, 360)))
    drawn = sheet.road(found).run()
    assert sheet.by_table(found.fresh(), drawn, found.truth, found.largest).largest < 1e-4
    place = next(k for k, v in enumerate(drawn.measured.vectors) if v.name == "p b")
    longer = drawn.measured.vectors[place]
    spoilt = replace(longer, value=longer.value * (1 + longer.scale / abs(longer.value)))
    vectors = (*drawn.measured.vectors[:place], spoilt, *drawn.measured.vectors[place + 1 :])
    seen = replace(drawn, measured=drawn.measured._replace(vectors=vectors))
    errors = sheet.by_ruler(found.fresh(), seen, found.truth, found.largest)
    assert errors.worst == "v_B"
    assert errors.largest == pytest.approx(longer.scale / found.largest["v"], rel=1e-3)


def test_the_plain_pen_draws_the_same_strokes() -> None:
    strokes = (
        Line(1 + 2j, 3 + 4j, LineStyle(0.5, (4, 1.5))),
        Polyline((0j, 1j, 1 + 1j), closed=True),
        Circle(5 + 5j, 2.0),
        Arc(5 + 5j, 2.0, 0.0, 2 * math.pi),
        Group((Line(0j, 1 + 0j),), "inner", {"kind": "anything"}),
    )
    root = ElementTree.fromstring(plain_pen.svg(Leaf(20, 10, (Group(strokes, "all"),))))
    line, polygon, circle, path = (root.find(f".//{SVG}{tag}") for tag in ("line", "polygon", "circle", "path"))
    assert line is not None and [line.get(name) for name in ("x1", "y1", "x2", "y2")] == ["1.0", "8.0", "3.0", "6.0"]
    assert line.get("stroke-dasharray") == "4,1.5"
    assert polygon is not None and polygon.get("points") == "0.0,10.0 0.0,9.0 1.0,9.0"
    assert circle is not None and (circle.get("cx"), circle.get("cy"), circle.get("r")) == ("5.0", "5.0", "2.0")
    assert path is not None and (path.get("d") or "").count("A") == 2
    letter = ElementTree.fromstring(plain_pen.svg(Leaf(20, 10, (Group((Text(0j, "A"),)),))))
    assert len(list(letter.iter(f"{SVG}polyline"))) == len(outline(Text(0j, "A")))


def test_a_sheet_that_is_refused_is_left_out_with_its_reason() -> None:
    text = (GALLERY / "shaper.toml").read_text("utf-8").replace("[sheet]", '[sheet]\napproved = "机构"')
    found = sessions.session(parse_scene(text), Order((12,), 1, startup=False), lambda what: None)
    rows = {row.technique: row for row in found.rows}
    for name in (sheet.MEASURED, sheet.PRINTED, hands.BY_HAND.format(0.1)):
        assert rows[name].times is None
        assert rows[name].note.startswith("left out: ")
    assert rows[CONSTRUCTION[2]].times is not None


def test_the_program_of_the_start_up_is_plandraft() -> None:
    line = [sys.executable, "-c", DRAW, "--version"]
    told = subprocess.run(line, capture_output=True, text=True, check=True, timeout=60).stdout
    assert told == f"plandraft {VERSION}\n"


@pytest.fixture(scope="module")
def loaded() -> Bench:
    """Run a short session on a shaper whose forces are asked for."""
    return sessions.session(of_forces(), Order((12, 360), 1, startup=False, drawn=12), lambda what: None)


def of_forces() -> Scene:
    return read_scene(GALLERY.parent.parent / "tests/cases/forces/shaper.toml")


@pytest.mark.rest
def test_a_scene_of_forces_has_rows_for_them(loaded: Bench) -> None:
    for count in (12, 360):
        rows = {row.technique: row for row in loaded.rows if row.positions == count}
        assert set(forces.TECHNIQUES) <= set(rows)
        assert all(rows[name].times and rows[name].error is not None for name in forces.TECHNIQUES)
        assert rows[forces.FORCES_CONSTRUCTED].error < 1e-14
    hands = {row.technique: row for row in loaded.rows if row.positions is None}
    one, two = (hands[FORCES_BY_HAND.format(slip)] for slip in SLIPS)
    assert one.error is not None and two.error == pytest.approx(2 * one.error, rel=0.1)
    assert 1e-4 < one.error < one.often < 0.05


@pytest.mark.rest
def test_forces_are_held_against_the_motion_they_rest_on(loaded: Bench) -> None:
    (ratio,) = (r for r in loaded.ratios if r.name.startswith("construction: forces") and r.positions == 360)
    assert ratio.goal == Goal(3.0, least=False)
    assert ratio.times is not None
    told = " ".join(loaded.words)
    assert "largest reaction" in told and "coarsest scale" in told


def test_a_scene_of_motion_alone_says_nothing_of_forces(quick: Bench) -> None:
    assert not [row.technique for row in quick.rows if "forces" in row.technique or "check" in row.technique]
    assert not [ratio.name for ratio in quick.ratios if "forces" in ratio.name]
    assert "reaction" not in " ".join(quick.words)


Run = Callable[..., tuple[int, str, str]]


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str]) -> Run:
    def told(*arguments: object) -> tuple[int, str, str]:
        try:
            code = cli.main(["bench", *map(str, arguments)])
        except SystemExit as end:
            code = int(end.code or 0)
        return code, *capsys.readouterr()

    return told


SHORT = ("--positions", "12", "--repetitions", "1", "--no-startup")


@pytest.mark.rest
def test_the_command_prints_and_keeps_a_bench(run: Run, tmp_path: Path) -> None:
    code, out, err = run(GALLERY / "crank-rocker.toml", *SHORT, "-o", tmp_path)
    assert (code, err) == (0, "")
    assert "Crank-rocker: error against run time" in out
    assert sorted(file.name for file in tmp_path.iterdir()) == ["crank-rocker-bench.csv", "crank-rocker-bench.svg"]
    assert len(lines((tmp_path / "crank-rocker-bench.csv").read_bytes())) > len(TECHNIQUES)


@pytest.mark.rest
def test_json_alone_stands_on_stdout(run: Run, tmp_path: Path, quick: Bench, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sessions, "session", lambda *_: quick)
    code, out, err = run(GALLERY / "shaper.toml", *SHORT, "--json", "-o", tmp_path)
    assert code == 0
    assert json.loads(out)["scene"] == quick.title
    assert "shaper-bench.csv" in err


@pytest.mark.rest
def test_a_scene_with_gaps_is_measured_where_it_exists_and_says_so(run: Run, tmp_path: Path) -> None:
    file = tmp_path / "gapped.toml"
    file.write_text(GAPPED, "utf-8")
    code, out, _ = run(file, *SHORT)
    assert code == 4
    (row,) = (line for line in out.splitlines() if line.startswith(CONSTRUCTION[2]))
    assert " yes " in row


def test_a_scene_that_cannot_be_assembled_is_not_measured(run: Run, tmp_path: Path) -> None:
    file = tmp_path / "apart.toml"
    file.write_text(GAPPED.replace("C = [0.3, 0]", "C = [0.9, 0]"), "utf-8")
    code, out, err = run(file, *SHORT)
    assert (code, out) == (4, "")
    assert "nothing to measure" in err


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        (("--positions", "0"), 2),
        (("--positions", "12,x"), 2),
        (("--repetitions", "-1"), 2),
        (("--accept", "nan"), 2),
        (("--accept", "2"), 2),
        (("--positions", "100001"), 8),
    ],
)
def test_what_cannot_be_ordered_is_refused(run: Run, arguments: tuple[str, ...], code: int) -> None:
    assert run(GALLERY / "shaper.toml", *arguments)[0] == code


def test_without_matplotlib_a_plot_is_refused_before_anything_is_measured(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(plot, "find_spec", lambda name: None)
    monkeypatch.setattr(sessions, "session", lambda *_: pytest.fail("measured"))
    code, _, err = run(GALLERY / "shaper.toml", *SHORT, "-o", tmp_path)
    assert code == 7
    assert "Fix: python -m pip install '.[bench]'" in err


def test_a_folder_that_cannot_be_written_is_told_before_anything_is_measured(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sessions, "session", lambda *_: pytest.fail("measured"))
    (tmp_path / "file").write_text("", "utf-8")
    assert run(GALLERY / "shaper.toml", *SHORT, "-o", tmp_path / "file")[0] == 7


def order(*words: str) -> Order:
    return command.order(parser().parse_args(["bench", "scene.toml", *words]))


def test_words_of_the_command_line_go_before_those_of_quick() -> None:
    assert order() == Order((12, 360, 10_000, 100_000), 15)
    assert order("--quick") == Order((12, 360), 3, startup=False, drawn=12)
    assert order("--quick", "--positions", "500,24,24", "--startup").positions == (24, 500)
    assert order("--quick", "--startup").startup
    assert not order("--no-startup").startup
    assert order("--accept", "0.02").accepted == 0.02


def test_a_hand_is_held_against_the_books(quick: Bench) -> None:
    told: Any = [word for word in quick.words if word.startswith("  by hand")]
    assert len(told) == len(SLIPS)
    medians = [float(word.split(": ")[1].partition("%")[0]) for word in told]
    assert medians[1] / medians[0] == pytest.approx(2.0, rel=0.05)
    assert np.all(np.array(medians) < hands.BOOKS_MEDIAN)  # books are smaller than this sheet
