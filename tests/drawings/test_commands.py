"""The command: what it prints, what it writes, and how it ends; its exit codes are a contract."""

from __future__ import annotations

import errno
import json
import math
import os
import re
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import redirect_stderr, redirect_stdout
from io import StringIO
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest

from drawings.commands import cli
from drawings.commands import draw as draw_command
from drawings.commands import solve as solve_command
from drawings.files import atomic_files
from drawings.paper.limits import QUANTUM
from plans.linkage import quantities as comparing
from plans.model.motion import Motion, PointMotion
from tests.drawings.conftest import Run
from tests.drawings.mechanisms import TWO_ROCKERS
from tests.gallery import LINKAGES
from tests.parts import first
from tests.rows import over

ROOT = Path(__file__).parent.parent.parent
SHAPER = ROOT / "drawings/gallery/shaper.toml"
PLAIN = ROOT / "tests/catalogue/plain.toml"


def process(
    *arguments: object, cwd: Path = ROOT, options: tuple[str, ...] = (), **environment: str
) -> subprocess.CompletedProcess[bytes]:
    """Run the command in a process of its own."""
    command = [sys.executable, *options, "-m", "drawings.commands.process", *map(str, arguments)]
    known = {**os.environ, "PYTHONPATH": str(ROOT), **environment}
    return subprocess.run(command, cwd=cwd, env=known, capture_output=True, check=False, timeout=120)


@pytest.fixture
def gapped(tmp_path: Path) -> Path:
    scene = tmp_path / "rockers.toml"
    scene.write_text(TWO_ROCKERS, "utf-8")
    return scene


def edited(tmp_path: Path, old: str, new: str) -> Path:
    """Give the shaper's scene with one thing changed."""
    text = SHAPER.read_text("utf-8")
    assert old in text
    scene = tmp_path / "shaper.toml"
    scene.write_text(text.replace(old, new), "utf-8")
    return scene


# draw


class Done(NamedTuple):
    folder: Path
    code: int
    out: str
    err: str


@pytest.fixture(scope="module")
def shaper(tmp_path_factory: pytest.TempPathFactory) -> Done:
    """Draw the shaper once, by the command, for all that is asked of it; nothing is changed in its folder."""
    return drawn_in(tmp_path_factory.mktemp("shaper") / "not/made/yet")


def drawn_in(folder: Path, scene: Path = SHAPER) -> Done:
    """Draw a scene, or the shaper, by the command."""
    with redirect_stdout(StringIO()) as out, redirect_stderr(StringIO()) as err:
        code = cli.main(["draw", str(scene), "-o", str(folder)])
    return Done(folder, code, out.getvalue(), err.getvalue())


@pytest.fixture(scope="module")
def over_older(tmp_path_factory: pytest.TempPathFactory) -> Done:
    """Draw a four-bar linkage once where two sheets of earlier runs lie."""
    folder = tmp_path_factory.mktemp("older")
    for name in ("plain-kinematics.svg", "plain-kinematics-2.svg"):
        (folder / name).write_text("old", "utf-8")
    return drawn_in(folder, PLAIN)


def test_draw_writes_the_sheet_and_the_report_and_prints_the_comparison(shaper: Done) -> None:
    folder, code, out, err = shaper
    assert (code, err) == (0, "")
    sheet, beside = folder / "shaper-kinematics.svg", folder / "shaper-report.md"
    assert {file.name for file in folder.iterdir()} == {
        sheet.name,
        beside.name,
        "shaper-manifest.json",
    }
    lines = out.splitlines()
    assert lines[-2:] == [str(sheet), str(beside)]
    assert [line.split()[0] for line in lines[1:4]] == ["positions", "velocities", "accelerations"]
    assert all(0 <= float(line.split()[4]) <= 1 for line in lines[1:4])
    assert beside.read_text("utf-8").startswith("# Crank shaper: kinematics\n")


@pytest.mark.rest
def test_the_output_is_told_and_who_chose_it(run: Run, shaper: Done, tmp_path: Path) -> None:
    report = (shaper.folder / "shaper-report.md").read_text("utf-8")
    chosen = "utput: link 5 by its point D, the last link on the frame; [output] names another\n"
    assert f"\no{chosen}" in shaper.out
    assert f"\n- O{chosen}" in report
    named = tmp_path / "plain.toml"
    named.write_text(PLAIN.read_text("utf-8") + "positions = 2\n[output]\nlink = 3\n", "utf-8")
    assert "\noutput: link 3, as [output] names it\n" in run("draw", named, "-o", tmp_path)[1]


@pytest.mark.rest
def test_a_following_sheet_of_an_earlier_run_is_named(over_older: Done) -> None:
    left = over_older.folder / "plain-kinematics-2.svg"
    assert over_older.code == 0
    assert over_older.err.startswith(f"{left}: left by an earlier run with more sheets")
    assert left.read_text("utf-8") == "old"


@pytest.mark.rest
def test_a_sheet_with_gaps_is_drawn_and_each_gap_is_told_with_its_reason(
    run: Run, gapped: Path, tmp_path: Path
) -> None:
    code, out, err = run("draw", gapped, "-o", tmp_path / "out")
    assert code == 4
    assert (tmp_path / "out/rockers-kinematics.svg").exists()
    assert len(err.splitlines()) == 1  # one reason, one line
    told = re.match(r"positions ([\d, -]+): positions: out of reach at B, in position \d: A and C are ", err)
    gaps = [gap["position"] for gap in json.loads(run("solve", gapped)[1])["gaps"]]
    assert told
    assert told[1] == f"{gaps[0]}-{gaps[-1]}"
    assert "m apart" in err and "reach from" in err
    assert "miss each other by" not in out


# solve


def test_solve_prints_every_number_of_the_scene(run: Run) -> None:
    code, out, err = run("solve", SHAPER, "--by", "construction", "--json")
    assert (code, err) == (0, "")
    data = json.loads(out)
    assert list(data)[:6] == ["scene", "by", "phi", "gaps", "points", "links"]
    assert (data["scene"], data["by"], data["gaps"]) == ("Crank shaper", "construction", [])
    assert len(data["phi"]) == 12
    assert np.diff(data["phi"]) == pytest.approx([math.tau / 12] * 11)
    assert set(data["points"]) == {"O", "C", "A", "B", "D"}
    assert set(data["links"]) == {"1", "2", "3", "4", "5"}
    for point in data["points"].values():
        assert list(point) == ["r", "v", "a"]
        assert all(np.shape(values) == (12, 2) for values in point.values())
    for link in data["links"].values():
        assert list(link) == ["angle", "omega", "epsilon"]
        assert all(np.shape(values) == (12,) for values in link.values())
    assert np.hypot(*np.transpose(data["points"]["A"]["v"])) == pytest.approx([1.2] * 12)
    assert data["links"]["1"]["omega"] == pytest.approx([10] * 12)
    assert data["links"]["1"]["epsilon"] == pytest.approx([5] * 12)


@pytest.mark.parametrize(
    ("only", "points", "links"),
    [
        ("positions", ["r"], ["angle"]),
        ("velocities", ["v"], ["omega"]),
        ("accelerations,positions", ["r", "a"], ["angle", "epsilon"]),
    ],
)
@pytest.mark.parametrize("by", ["construction", "analysis"])
def test_only_what_is_named_is_printed(run: Run, by: str, only: str, points: list[str], links: list[str]) -> None:
    code, out, _ = run("solve", SHAPER, "--by", by, "--only", only)
    data = json.loads(out)
    assert code == 0
    assert all(sorted(point) == sorted(points) for point in data["points"].values())
    assert all(sorted(link) == sorted(links) for link in data["links"].values())


def largest(data: dict[str, Any], key: str) -> float:
    return max(math.hypot(*pair) for point in data["points"].values() for pair in point[key] if pair)


@pytest.mark.parametrize("scene", first(LINKAGES), ids=lambda scene: scene.stem)
def test_both_roads_print_the_same_numbers(run: Run, scene: Path) -> None:
    ours, theirs = (json.loads(run("solve", scene, "--by", by)[1]) for by in ("construction", "analysis"))
    assert theirs["by"] == "analysis"
    assert {key: list(ours[key]) for key in ("points", "links")} == {k: list(theirs[k]) for k in ("points", "links")}
    assert ours["phi"] == pytest.approx(theirs["phi"], abs=1e-9)
    assert [gap["position"] for gap in ours["gaps"]] == [gap["position"] for gap in theirs["gaps"]]
    for name, point in ours["points"].items():
        for key, values in point.items():
            assert np.array(values) == pytest.approx(
                np.array(theirs["points"][name][key]), abs=1e-9 * largest(ours, key), nan_ok=True
            )
    for number, link in ours["links"].items():
        turn = np.subtract(link["angle"], theirs["links"][number]["angle"])
        assert np.abs(np.angle(np.exp(1j * turn))).max() < 1e-9
        for key in link.keys() - {"angle"}:
            assert link[key] == pytest.approx(theirs["links"][number][key], rel=1e-8, abs=1e-8)
    assert ours.get("extremes", {}).keys() == theirs.get("extremes", {}).keys()
    for key, value in ours.get("extremes", {}).items():
        assert value == pytest.approx(theirs["extremes"][key], abs=1e-9), key


@pytest.mark.parametrize("by", first(["construction", "analysis"]))
def test_a_gap_is_null_in_every_number_and_named_with_its_reason(run: Run, gapped: Path, by: str) -> None:
    code, out, _ = run("solve", gapped, "--by", by)
    data = json.loads(out)
    assert code == 4
    lost = {gap["position"] for gap in data["gaps"]}
    assert {2, 3, 4} <= lost < set(range(12))
    for gap in data["gaps"]:
        assert gap["phi"] == data["phi"][gap["position"]]
        assert gap["reason"]
        assert gap["advice"]
    for values in (*data["points"]["B"].values(), *data["links"]["3"].values()):
        assert {k for k, value in enumerate(values) if value is None} == lost
    assert not {"NaN", "Infinity", "-0.0,"} & set(re.findall(r"NaN|Infinity|-0\.0,", out))


# compare


def test_compare_prints_each_quantity_and_the_verdict(run: Run) -> None:
    code, out, _ = run("compare", SHAPER)
    assert code == 0
    assert {"r_D", "v_D", "a_D", "φ_3", "ω_3", "ε_3"} <= {line.split()[1] for line in out.splitlines()}
    assert out.splitlines()[-1].startswith("construction and analysis agree: worst 0.0")
    code, out, _ = run("compare", SHAPER, "--json")
    findings = json.loads(out)["findings"]
    assert all(0 <= finding["of_allowed"] <= 1 for finding in findings)
    assert {finding["unit"] for finding in findings} == {"m", "rad", "m/s", "rad/s", "m/s2", "rad/s2"}


def test_compare_ends_with_4_where_there_are_gaps(run: Run, gapped: Path) -> None:
    code, out, _ = run("compare", gapped)
    assert code == 4
    assert "agree" in out


def mislead(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let the analytic solver be wrong by a millionth in the velocity of D."""
    solve = comparing.Analysis.motion

    def wrong(*arguments: Any) -> Motion:
        motion = solve(*arguments)
        r, v, a = motion.points["D"]
        return motion._replace(points={**motion.points, "D": PointMotion((r, v * (1 + 1e-6), a))})

    monkeypatch.setattr(comparing.Analysis, "motion", wrong)


def test_compare_ends_with_5_where_the_roads_differ_by_a_millionth(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    mislead(monkeypatch)
    code, out, _ = run("compare", SHAPER)
    assert code == 5
    assert "construction and analysis DIFFER" in out


# The self-check


@pytest.fixture(scope="module")
def good(shaper: Done) -> dict[str, bytes]:
    """Give the files of a good sheet, drawn once."""
    return {file.name: file.read_bytes() for file in shaper.folder.iterdir()}


def copied(files: dict[str, bytes], folder: Path) -> Path:
    """Put the files of a drawn set into another folder; give the sheet."""
    for name, content in files.items():
        (folder / name).write_bytes(content)
    return folder / "shaper-kinematics.svg"


@pytest.fixture
def before(good: dict[str, bytes], tmp_path: Path) -> Iterator[Path]:
    """A folder with a good sheet, which must be left as it is; and nothing beside it."""
    assert len(good) == 3
    copied(good, tmp_path)
    yield tmp_path
    assert {file.name: file.read_bytes() for file in tmp_path.iterdir()} == good


def test_a_sheet_that_the_analysis_does_not_confirm_is_withheld(
    run: Run, before: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    mislead(monkeypatch)
    code, out, err = run("draw", SHAPER, "-o", before)
    assert (code, out) == (5, "")
    assert "construction and analysis differ in v_D" in err
    assert "withheld" in err


# explain


@pytest.mark.parametrize("mark", ["B", "v_D", "a_D", "omega_3", "epsilon_4", "a3"])
def test_explain_tells_every_step_behind_a_mark_in_order(run: Run, mark: str) -> None:
    code, out, _ = run("explain", SHAPER, mark, "--position", 3)
    lines = [line for line in out.splitlines() if not line.startswith("     ")]  # the rate that is read off comes last
    assert code == 0
    assert re.fullmatch(rf"{mark} in position 3 \(φ = 429\.949\d°\), {len(lines) - 1} steps", lines[0])
    assert [int(line.split(".")[0]) for line in lines[1:]] == list(range(1, len(lines)))
    code, out, _ = run("explain", SHAPER, mark, "--position", 3, "--json")
    steps = json.loads(out)
    assert len(steps) == len(lines) - 1
    seen: set[str] = set()
    for step in steps:
        assert set(step["from"]) <= seen
        seen.add(step["name"])
    assert any(step["why"] for step in steps)


@pytest.mark.parametrize(
    ("name", "link", "key", "unit"), [("omega_3", "3", "omega", "rad/s"), ("epsilon_4", "4", "epsilon", "rad/s2")]
)
def test_explain_ends_with_the_rate_that_is_read_off(run: Run, name: str, link: str, key: str, unit: str) -> None:
    _, out, _ = run("explain", SHAPER, name, "--position", "2")
    _, solved, _ = run("solve", SHAPER, "--by", "analysis")
    true = json.loads(solved)["links"][link][key][2]
    last = out.splitlines()[-1]
    found = re.search(rf"= (\S+) {unit}, (counter-clockwise|clockwise)$", last)
    assert found and float(found[1]) == pytest.approx(true, rel=1e-9), last
    assert (found[2] == "counter-clockwise") == (true > 0)


def test_a_letter_may_be_asked_for_as_the_sheet_writes_it(run: Run) -> None:
    written, plain = run("explain", SHAPER, "a_3")[1], run("explain", SHAPER, "a3")[1]
    assert written.splitlines()[1:] == plain.splitlines()[1:] and len(plain.splitlines()) > 5


def test_what_is_carried_to_another_plan_keeps_its_unit(run: Run) -> None:
    _, out, _ = run("explain", SHAPER, "v_D")
    carried = [line for line in out.splitlines() if ": transfer (" in line]
    assert carried and all(line.split(" = ")[1].split(". ")[0].endswith(") m") for line in carried)


def test_explain_tells_where_the_mark_is(run: Run) -> None:
    solved = json.loads(run("solve", SHAPER)[1])["points"]["B"]["r"][3]
    last = run("explain", SHAPER, "B", "--position", 3)[1].splitlines()[-1]
    found = re.search(r"B: \S+ .* = \((\S+), (\S+)\) m", last)
    assert found
    assert [float(found[1]), float(found[2])] == pytest.approx(solved, rel=1e-9)


def test_a_velocity_rests_on_the_positions_that_it_needs_and_on_no_others(run: Run) -> None:
    steps = json.loads(run("explain", SHAPER, "v_B", "--json")[1])
    assert {step["plan"] for step in steps} == {"positions", "velocities"}
    assert "D" not in {step["name"] for step in steps}


def test_an_unknown_mark_is_answered_with_the_nearest_one(run: Run) -> None:
    code, out, err = run("explain", SHAPER, "v_DD")
    assert (code, out) == (3, "")
    assert "did you mean v_D?" in err


@over("position", [-1, 12, 999999999999])
def test_a_position_out_of_range_is_answered_with_the_range(run: Run, position: int) -> None:
    code, out, err = run("explain", SHAPER, "B", f"--position={position}")
    assert (code, out) == (3, "")
    assert "0 to 11" in err


def test_a_gap_has_nothing_to_explain_but_its_reason(run: Run, gapped: Path) -> None:
    code, out, err = run("explain", gapped, "B", "--position", 3)
    assert (code, out) == (3, "")
    assert "position 3 is a gap: " in err


def test_a_link_that_does_not_turn_has_no_steps_behind_its_rate(run: Run) -> None:
    code, _, err = run("explain", SHAPER, "omega_5")
    assert code == 3
    assert "does not turn" in err


# measure


def test_measure_prints_the_vectors_of_a_drawn_sheet_in_true_units(run: Run, shaper: Done) -> None:
    sheet = shaper.folder / "shaper-kinematics.svg"
    code, out, err = run("measure", sheet)
    assert (code, err) == (0, "")
    assert "DIFFERS" not in out
    data = json.loads(run("measure", sheet, "--json")[1])
    solved = json.loads(run("solve", SHAPER)[1])
    found = [vector for vector in data["vectors"] if vector["name"] == "p b"]
    assert found
    for vector in found:
        true = solved["points"]["B"]["v"][vector["position"]]
        assert vector["unit"] == "m/s"
        assert math.dist(vector["value"], true) <= 2 * QUANTUM * vector["scale"]


def test_measure_says_of_a_foreign_drawing_that_it_is_none_of_ours(run: Run, tmp_path: Path) -> None:
    foreign = tmp_path / "foreign.svg"
    foreign.write_text('<svg xmlns="http://www.w3.org/2000/svg" width="9mm" height="9mm" viewBox="0 0 9 9"/>', "utf-8")
    code, out, err = run("measure", foreign)
    assert (code, out) == (3, "")
    assert err.startswith(f"{foreign}: this SVG has no vectors or points of a plandraft sheet")


def test_measure_ends_with_8_where_a_sheet_exceeds_a_limit(run: Run, tmp_path: Path) -> None:
    deep = tmp_path / "deep.svg"
    body = "<g>" * 300 + "</g>" * 300
    deep.write_text(f'<svg xmlns="http://www.w3.org/2000/svg" width="9mm" height="9mm">{body}</svg>', "utf-8")
    code, out, err = run("measure", deep)
    assert (code, out) == (8, "")
    assert err.startswith(f"{deep}: elements are nested over 256 deep")


def test_measure_tells_which_vector_of_an_edited_sheet_differs(
    run: Run, good: dict[str, bytes], tmp_path: Path
) -> None:
    sheet = copied(good, tmp_path)
    text = sheet.read_text("utf-8")
    line = re.search(r"<line[^>]*data-name=\"p b\"[^>]*>", text)
    assert line
    moved = re.sub(r'x2="([\d.]+)"', lambda found: f'x2="{float(found[1]) + 0.01:.4f}"', line[0])
    sheet.write_text(text.replace(line[0], moved, 1), "utf-8")
    code, out, _ = run("measure", sheet)
    assert code == 5
    assert [row.split()[2:4] for row in out.splitlines() if "DIFFERS" in row] == [["p", "b"]]


# Exit codes


@pytest.mark.parametrize(
    "arguments",
    [
        [],
        ["paint", SHAPER],
        ["draw"],
        ["draw", SHAPER, "--fast"],
        ["solve", SHAPER, "--by", "magic"],
        ["solve", SHAPER, "--only", "moments"],
        ["solve", SHAPER, "--only", ""],
        ["explain", SHAPER],
        ["explain", SHAPER, "B", "--position", "two"],
        ["measure"],
    ],
    ids=lambda arguments: " ".join(str(getattr(part, "name", part)) for part in arguments) or "nothing",
)
def test_a_wrong_command_line_ends_with_2_and_the_usage(run: Run, arguments: list[object]) -> None:
    code, out, err = run(*arguments)
    assert (code, out) == (2, "")
    assert err.startswith("usage: plandraft")


def test_a_misspelt_key_ends_with_3_and_the_right_spelling(run: Run, tmp_path: Path) -> None:
    scene = edited(tmp_path, "CB = 0.700", "CB = 0.700\n[mechanism.skecth]")
    for command, *more in (["draw", "-o", tmp_path / "out"], ["solve"], ["compare"], ["explain", "B"]):
        code, out, err = run(command, scene, *more)
        assert (code, out) == (3, "")
        assert f"{scene}:" in err
        assert "sketch" in err
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("lettering", ["strokes", "text"])
def test_a_letter_that_cannot_be_drawn_ends_with_3_before_anything_is_made(
    run: Run, tmp_path: Path, lettering: str
) -> None:
    scene = tmp_path / "snow.toml"
    words = f'[sheet]\nlettering = "{lettering}"\napproved = "雪 Ivanov"\n'
    scene.write_text(SHAPER.read_text("utf-8").replace("[sheet]\n", words), "utf-8")
    code, out, err = run("draw", scene, "-o", tmp_path / "out")
    assert (code, out) == (3, "")
    where, _, told = err.partition(": sheet.approved: ")
    assert re.fullmatch(rf"{re.escape(str(scene))}:\d+:1", where)
    assert told == "lettering '雪 Ivanov': the alphabet lacks '雪' (U+96EA); write it in other letters\n"
    assert not (tmp_path / "out").exists()


@pytest.mark.rest
def test_texts_are_left_to_the_viewer_where_the_scene_says_so(run: Run, tmp_path: Path) -> None:
    scene = tmp_path / "plain.toml"
    scene.write_text(PLAIN.read_text("utf-8") + 'positions = 2\n[sheet]\nlettering = "text"\n', "utf-8")
    assert run("draw", scene, "-o", tmp_path)[0] == 0
    sheet = (tmp_path / "plain-kinematics.svg").read_text("utf-8")
    assert ">Plan of positions</text>" in sheet
    # A text of several levels is a group of one for each.
    assert sheet.count("<text ") > sheet.count("data-text=") == sheet.count("aria-label=") > 100


def test_a_group_without_a_sketch_ends_with_3_and_what_to_add(run: Run, tmp_path: Path) -> None:
    scene = edited(tmp_path, "B = [0.20, 0.32]\nD = [0.40, 0.33]\n", "")
    code, out, err = run("solve", scene)
    assert (code, out) == (3, "")
    assert "sketch" in err


def test_more_positions_than_a_sheet_can_show_end_with_8_but_can_be_solved(run: Run, tmp_path: Path) -> None:
    scene = edited(tmp_path, "positions = 12", "positions = 361")
    code, out, err = run("draw", scene, "-o", tmp_path / "out")
    assert (code, out) == (8, "")
    assert "361" in err
    assert "360" in err
    assert not (tmp_path / "out").exists()
    assert run("solve", scene, "--only", "positions")[0] == 0


def test_a_scene_of_megabytes_ends_with_8(run: Run, tmp_path: Path) -> None:
    scene = tmp_path / "huge.toml"
    scene.write_bytes(b"#" * (1 << 20) + b"\n" + SHAPER.read_bytes())
    assert run("solve", scene)[0] == 8


@pytest.mark.parametrize(
    "command", [["draw"], ["solve"], ["compare"], ["explain", "B"], ["measure"]], ids=lambda c: c[0]
)
def test_a_file_that_cannot_be_read_ends_with_7_and_its_name(run: Run, tmp_path: Path, command: list[str]) -> None:
    for path in (tmp_path / "nowhere.toml", tmp_path):
        code, out, err = run(command[0], path, *command[1:])
        assert (code, out) == (7, "")
        assert str(path) in err
        assert len(err.splitlines()) == 1


@pytest.mark.parametrize("folder", ["taken", "taken/below"])
def test_a_folder_that_cannot_be_made_ends_with_7(run: Run, tmp_path: Path, folder: str) -> None:
    (tmp_path / "taken").write_text("a file")
    code, out, err = run("draw", SHAPER, "-o", tmp_path / folder)
    assert (code, out) == (7, "")
    assert str(tmp_path / folder) in err
    assert (tmp_path / "taken").read_text() == "a file"


@pytest.mark.rest
def test_a_full_disk_ends_with_7_and_leaves_the_old_sheet(
    run: Run, before: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_: object) -> int:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(atomic_files.os, "write", full)
    code, _, err = run("draw", SHAPER, "-o", before)
    monkeypatch.undo()
    assert code == 7
    assert "No space left on device" in err


def test_a_bug_of_ours_is_called_one_and_its_traceback_is_kept(
    run: Run, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    def broken(_: object) -> int:
        raise ZeroDivisionError("a slip of the pen")

    monkeypatch.setattr(solve_command, "run", broken)
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    code, out, err = run("solve", SHAPER)
    assert (code, out) == (1, "")
    assert len(err.splitlines()) == 1
    assert "a bug of plandraft" in err
    (kept,) = tmp_path.glob("plandraft-bug-*.txt")
    assert str(kept) in err
    assert "ZeroDivisionError: a slip of the pen" in kept.read_text("utf-8")


def test_a_user_who_stops_it_gets_130(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    def stopped(_: object) -> int:
        raise KeyboardInterrupt

    monkeypatch.setattr(draw_command, "run", stopped)
    assert run("draw", SHAPER) == (130, "", "")


@pytest.mark.parametrize("arguments", [["--help"], ["draw", "--help"], ["--version"]], ids=" ".join)
def test_help_and_version_end_with_0(run: Run, arguments: list[str]) -> None:
    code, out, err = run(*arguments)
    assert (code, err) == (0, "")
    assert "plandraft" in out


def test_the_help_names_every_exit_code(run: Run) -> None:
    told = run("--help")[1]
    assert set(re.findall(r"\b(\d) [a-z]", told.partition("exit codes:")[2])) == set("01234578")


# By a real process


def test_a_reader_that_leaves_early_ends_the_command_quietly(tmp_path: Path) -> None:
    scene = edited(tmp_path, "positions = 12", "positions = 3000")
    command = [sys.executable, "-m", "drawings.commands.process", "solve", str(scene)]
    with subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as running:
        assert running.stdout is not None
        assert running.stderr is not None
        assert running.stdout.read(8) == b'{"scene"'
        running.stdout.close()
        err = running.stderr.read()
        assert running.wait(60) == 7
    assert err == b""


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="this system has no full device")
def test_a_full_stdout_ends_with_7_and_one_line() -> None:
    with Path("/dev/full").open("wb") as full:
        command = [sys.executable, "-m", "drawings.commands.process", "solve", str(SHAPER)]
        done = subprocess.run(command, cwd=ROOT, stdout=full, stderr=subprocess.PIPE, check=False)
    assert done.returncode == 7
    assert len(done.stderr.splitlines()) == 1


@pytest.mark.skipif(os.name != "posix", reason="closes a stream by the shell")
def test_a_closed_stdout_ends_with_7_and_one_line() -> None:
    command = f"'{sys.executable}' -m drawings.commands.process compare '{SHAPER}' >&-"
    done = subprocess.run(["sh", "-c", command], cwd=ROOT, stderr=subprocess.PIPE, check=False)
    assert done.returncode == 7
    assert len(done.stderr.splitlines()) == 1


def test_a_terminal_without_greek_letters_ends_no_command() -> None:
    done = process("explain", PLAIN, "a_B", "--json", PYTHONIOENCODING="ascii")
    assert "π" in {step["name"] for step in json.loads(done.stdout)}
