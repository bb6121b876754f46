"""plandraft bench: every technique of any scene has its rows; how they are printed, kept and plotted; its command."""

from __future__ import annotations

import csv
import io
import json
import math
import subprocess
import sys
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import cache
from pathlib import Path
from xml.etree import ElementTree

import pytest

from drawings import VERSION
from drawings.bench import plain_pen, plot, report, session, sheet
from drawings.commands import bench as command
from drawings.commands import cli
from drawings.commands.parser import parser
from drawings.lettering.lettering import outline
from drawings.paper.strokes import Arc, Circle, Group, Leaf, Line, LineStyle, Polyline, Text
from plans.bench.motion import PLANS, REPLAY
from plans.bench.peers import PYLINKAGE
from plans.bench.quantities import ANALYSIS, CONSTRUCTION
from plans.bench.trial import NOT_INSTALLED, Bench, Computer, Demand, Errors, Goal, Ratio, Timed, Times
from plans.scene.scene import parse_scene, read_scene
from plans.study import Study
from plans.techniques import TECHNIQUES
from tests.drawings.mechanisms import TWO_ROCKERS
from tests.gallery import GALLERY, SCENES
from tests.parts import first

SVG = "{http://www.w3.org/2000/svg}"
ROUNDINGS = 1e-9  # shares: of what is no limit (energy by a slope) nothing is worse in any scene of the gallery
ONCE = Demand((12,), 1, startup=False)
SCENE = GALLERY / "slider-crank.toml"


@cache
def session_of(path: Path) -> Bench:
    """Run a short session on a scene; its errors are tested, its times are only there."""
    return session.session(read_scene(path), ONCE, lambda what: None)


def covering() -> Iterator[Path]:
    """Give scenes of the gallery that have all techniques together, each one that none before it has."""
    known: set[str] = set()
    for path in sorted(SCENES, key=lambda path: (path != SCENE, path.stat().st_size)):
        own = set(Study(read_scene(path)).techniques)
        if own - known:
            known |= own
            yield path
    assert known == set(TECHNIQUES) >= {*session.OTHERS, *session.SERIES, *sheet.HANDS}


@pytest.mark.parametrize("path", first([*covering()]), ids=lambda path: path.stem)
def test_every_technique_has_its_rows_by_both_roads_its_sheets_and_what_it_has_of_its_own(path: Path) -> None:
    found = session_of(path)
    rows = {row.technique: row for row in found.rows}
    for technique in Study(read_scene(path)).techniques:
        for name in (CONSTRUCTION.format(technique), ANALYSIS.format(technique)):
            assert rows[name].times is not None
            assert rows[name].errors is not None and rows[name].errors.worst < ROUNDINGS, name
            assert rows[name].errors.worst > 0 or technique == "structure", name  # whole numbers alone
    assert 0 < rows[sheet.MEASURED].errors.worst < 1e-4
    assert rows[sheet.NUMBERS].errors.typical < 1e-4
    assert not [row for row in found.rows if row.note.startswith("left out: ") and "four-bar" not in row.note]
    told = " ".join(found.words)
    assert all(word in told for word in ("error:", "accepted:", "time:", "median (quartiles)"))
    json.loads(report.json_text(found))
    assert len(lines(report.csv_bytes(found))) == len(found.rows)


def test_a_technique_that_no_table_of_the_bench_knows_has_its_rows(monkeypatch: pytest.MonkeyPatch) -> None:
    for table in (session.OTHERS, session.SERIES, sheet.HANDS):
        monkeypatch.setattr(session if table is not sheet.HANDS else sheet, name_of(table), {})
    rows = session.session(read_scene(GALLERY / "four-masses.toml"), ONCE, lambda what: None).rows
    assert [row.technique for row in rows if row.times and row.errors] == [
        CONSTRUCTION.format("rotor"), ANALYSIS.format("rotor"), sheet.MEASURED, sheet.NUMBERS,
    ]  # fmt: skip


def name_of(table: object) -> str:
    return next(name for module in (session, sheet) for name, own in vars(module).items() if own is table)


def test_errors_stand_in_the_order_of_their_roads() -> None:
    rows = session_of(SCENE).rows
    error = {row.technique: row.errors.worst for row in rows if row.errors and row.positions in (12, None)}
    hands = [sheet.BY_HAND.format("linkage", slip) for slip in sheet.SLIPS]
    ladder = [error[name] for name in (PLANS, "Newton to 1e-03", sheet.MEASURED, *hands)]
    assert ladder == sorted(ladder)
    assert error[hands[1]] == 2 * error[hands[0]]
    peers = {row.note for row in rows if row.technique == PYLINKAGE}
    assert len(peers) == 1 and "no four-bar" in peers.pop()


def test_what_will_take_too_long_is_left_out_and_says_why(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(session, "PATIENCE", 1e-9)
    rows = session.session(read_scene(GALLERY / "shaper.toml"), Demand((6, 12), 1, startup=False, drawn=0), print).rows
    late = [row for row in rows if row.positions == 12 and row.technique.startswith("linkage")]
    assert {CONSTRUCTION.format("linkage"), ANALYSIS.format("linkage")} == {row.technique for row in late}
    assert all(row.times is None and "would take" in row.note for row in late)


def test_a_sheet_that_is_refused_is_left_out_with_its_reason() -> None:
    text = (GALLERY / "shaper.toml").read_text("utf-8").replace("[sheet]", '[sheet]\napproved = "机构"')
    rows = {row.technique: row for row in session.session(parse_scene(text), ONCE, print).rows}
    assert all(rows[name].note.startswith("left out: ") for name in (sheet.MEASURED, sheet.NUMBERS))
    assert rows[PLANS].times is not None


def test_without_mpmath_the_replay_is_a_row_that_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("plans.bench.motion.find_spec", lambda library: None)
    found = session.session(read_scene(GALLERY / "shaper.toml"), replace(ONCE, drawn=0), print)
    assert next(row.note for row in found.rows if row.technique == REPLAY) == NOT_INSTALLED


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
    assert [line.get(name) for name in ("x1", "y1", "x2", "y2")] == ["1.0", "8.0", "3.0", "6.0"]
    assert line.get("stroke-dasharray") == "4,1.5"
    assert polygon.get("points") == "0.0,10.0 0.0,9.0 1.0,9.0"
    assert (circle.get("cx"), circle.get("cy"), circle.get("r")) == ("5.0", "5.0", "2.0")
    assert path.get("d").count("A") == 2
    letter = ElementTree.fromstring(plain_pen.svg(Leaf(20, 10, (Group((Text(0j, "A"),)),))))
    assert len(list(letter.iter(f"{SVG}polyline"))) == len(outline(Text(0j, "A")))


def test_the_program_of_the_start_up_is_plandraft() -> None:
    line = [sys.executable, "-c", sheet.DRAW, "--version"]
    told = subprocess.run(line, capture_output=True, text=True, check=True, timeout=60).stdout
    assert told == f"plandraft {VERSION}\n"


NAMES = [f"technique {k}" for k in range(26)]


def invented() -> Bench:
    """Give a bench of made-up numbers."""
    times = Times((1e-5, 2e-5, 3e-5))
    rows = [
        Timed(name, count, Errors(10.0**-k, 10.0**-k / 2, "v_B"), times)
        for k, name in enumerate(NAMES[:14])
        for count in (12, 360)
    ]
    rows += [Timed(PYLINKAGE, 10_000, note=NOT_INSTALLED), Timed("lost", None, Errors(math.inf, 0.5, "a_B"), times)]
    rows += [Timed(sheet.BY_HAND.format("linkage", slip), None, Errors(slip / 5, slip / 10)) for slip in sheet.SLIPS]
    reached = Ratio("this / that", 360, Times((9.0, 8.0, 7.0)), Times((1.0, 1.0, 1.0)), Goal(5.0))
    missed = Ratio("part / whole", 12, Times((9.0,)), Times((10.0,)), Goal(0.5, least=False))
    unknown = Ratio("peer / ours", 360, goal=Goal(2.0), note=NOT_INSTALLED)
    there = Computer("Abacus 9", 4, 0.5, "Linux x86_64", "3.11.7", "2.4.6")
    return Bench("Costs $5 and $6", there, tuple(rows), (reached, missed, unknown), ("error: so and so",), 1e-4)


def lines(content: bytes) -> list[dict[str, str]]:
    return list(csv.DictReader(io.StringIO(content.decode("utf-8"))))


def test_every_line_of_the_csv_has_its_error_its_times_and_its_machine() -> None:
    found = lines(report.csv_bytes(invented()))
    assert len(found) == len(invented().rows) and tuple(found[0]) == report.COLUMNS
    line = found[0]
    told = [line[name] for name in ("technique", "positions", "worst", "accepted", "repetitions")]
    assert told == [NAMES[0], "12", "v_B", "False", "3"]
    assert [float(line[name]) for name in ("error", "typical", "roundings")] == [1.0, 0.5, 2.0**52]
    times = [float(line[name]) for name in ("median_s", "least_s", "position_s")]
    assert times == pytest.approx([2e-5, 1e-5, 2e-5 / 12])
    assert {own["processor"] for own in found} == {"Abacus 9"}
    left_out = next(own for own in found if own["note"] == NOT_INSTALLED)
    assert (left_out["error"], left_out["median_s"], left_out["repetitions"]) == ("", "", "0")


def test_a_title_like_a_formula_is_written_as_text() -> None:
    for title in ('=HYPERLINK("http://x","y")', "+1", "-1", "@SUM(1)"):
        assert {line["scene"] for line in lines(report.csv_bytes(replace(invented(), title=title)))} == {f"'{title}"}
    assert lines(report.csv_bytes(invented()))[0]["scene"] == invented().title


def test_the_json_is_plain_and_whole_and_has_a_word_for_an_infinite_error() -> None:
    told = json.loads(report.json_text(invented()))
    assert told["machine"]["processor"] == "Abacus 9"
    assert [ratio["reached"] for ratio in told["ratios"]] == [True, False, None]
    assert (told["ratios"][0]["ratio"], told["ratios"][0]["goal"]) == (8.0, 5.0)
    lost = next(row for row in told["rows"] if row["technique"] == "lost")
    assert (lost["error"], lost["typical"], lost["accepted"]) == ("infinite", 0.5, False)


def test_the_table_tells_errors_goals_and_verdicts() -> None:
    text = report.written(invented())
    assert "Abacus 9, 4 cores" in text and "360 positions" in text and "any number of positions" in text
    told = {line[:6]: line for line in text.splitlines()}
    assert told["this /"].split()[-3:] == [">=", "5", "yes"]
    assert told["part /"].split()[-3:] == ["<=", "0.5", "no"]
    assert told["peer /"].endswith(NOT_INSTALLED)
    row = next(line for line in text.splitlines() if line.startswith(f"{NAMES[13]} "))
    assert row.split()[2:6] == ["1.0e-11", "5.0e-12", "450", "yes"] and row.endswith("worst in v_B")


@pytest.mark.rest
def test_the_plot_is_black_and_white_and_shows_every_technique() -> None:
    content = plot.svg(invented()).decode("utf-8")
    assert ElementTree.fromstring(content).tag == f"{SVG}svg"
    shades = {part[:6] for key in ("fill: #", "stroke: #") for part in content.split(key)[1:]}
    assert all(shade[:2] == shade[2:4] == shade[4:6] for shade in shades)
    for text in (*NAMES[:14], "accepted", "by hand, mm"):
        assert f"<!-- {text} -->" in content  # what matplotlib has drawn as outlines it says beside
    assert "Abacus 9" in content and "<dc:date>" not in content
    bare = replace(invented(), rows=(Timed(PYLINKAGE, 12, note=NOT_INSTALLED),))
    assert ElementTree.fromstring(plot.svg(bare)).tag == f"{SVG}svg"


def test_no_two_techniques_look_alike() -> None:
    assert len({(look.marker, look.filled) for look in plot.LOOKS}) == len(plot.LOOKS) >= 24


Run = Callable[..., tuple[int, str, str]]
SHORT = ("--positions", "12", "--repetitions", "1", "--no-startup")


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str]) -> Run:
    def told(*arguments: object) -> tuple[int, str, str]:
        try:
            code = cli.main(["bench", *map(str, arguments)])
        except SystemExit as end:
            code = int(end.code or 0)
        return code, *capsys.readouterr()

    return told


@pytest.mark.rest
def test_the_command_prints_and_keeps_a_bench(run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    quick = invented()
    monkeypatch.setattr(session, "session", lambda *_: quick)
    code, out, err = run(GALLERY / "shaper.toml", *SHORT, "-o", tmp_path)
    assert (code, err) == (0, "") and f"{quick.title}: error against run time" in out
    assert sorted(file.name for file in tmp_path.iterdir()) == ["shaper-bench.csv", "shaper-bench.svg"]
    code, out, err = run(GALLERY / "shaper.toml", *SHORT, "--json", "-o", tmp_path)
    assert code == 0 and json.loads(out)["scene"] == quick.title and "shaper-bench.csv" in err


def test_a_scene_with_gaps_is_measured_where_it_exists_and_says_so(run: Run, tmp_path: Path) -> None:
    file = tmp_path / "gapped.toml"
    file.write_text(TWO_ROCKERS, "utf-8")
    code, out, _ = run(file, *SHORT)
    assert code == 4
    (row,) = (line for line in out.splitlines() if line.startswith(PLANS))
    assert " yes " in row


def test_a_scene_that_cannot_be_assembled_is_not_measured(run: Run, tmp_path: Path) -> None:
    file = tmp_path / "apart.toml"
    file.write_text(TWO_ROCKERS.replace("C = [0.3, 0]", "C = [0.9, 0]"), "utf-8")
    code, out, err = run(file, *SHORT)
    assert (code, out) == (4, "") and "nothing to measure" in err


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


def test_what_could_not_be_written_is_told_before_anything_is_measured(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(session, "session", lambda *_: pytest.fail("measured"))
    (tmp_path / "file").write_text("", "utf-8")
    assert run(GALLERY / "shaper.toml", *SHORT, "-o", tmp_path / "file")[0] == 7
    monkeypatch.setattr(plot, "find_spec", lambda name: None)
    code, _, err = run(GALLERY / "shaper.toml", *SHORT, "-o", tmp_path)
    assert code == 7 and "Fix: python -m pip install '.[bench]'" in err


def test_words_of_the_command_line_go_before_those_of_quick() -> None:
    def order(*words: str) -> Demand:
        return command.order(parser().parse_args(["bench", "scene.toml", *words]))

    assert order() == Demand((12, 360, 10_000, 100_000), 15)
    assert order("--quick") == Demand((12, 360), 3, startup=False, drawn=12)
    assert order("--quick", "--positions", "500,24,24", "--startup").positions == (24, 500)
    assert order("--quick", "--startup").startup and not order("--no-startup").startup
    assert order("--accept", "0.02").accepted == 0.02
