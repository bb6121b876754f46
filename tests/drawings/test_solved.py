"""What solve, compare and explain print: every number by both roads, the verdict, the steps behind a mark."""

from __future__ import annotations

import json
import math
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from drawings.paper.strokes import Line
from drawings.paper.walk import groups
from drawings.sheets.documents import leaves_of
from plans.linkage import quantities as comparing
from plans.model.motion import Motion, PointMotion
from plans.scene.scene import read_scene
from plans.study import Study
from tests.drawings.conftest import Run
from tests.gallery import GALLERY
from tests.parts import first
from tests.rows import over

SHAPER = GALLERY / "shaper.toml"


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
        ("План скоростей", ["v"], ["omega"]),
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


# explain


@pytest.mark.parametrize("mark", ["B", "v_D", "a_D", "omega_3", "epsilon_4", "a3"])
def test_explain_tells_every_step_behind_a_mark_in_order(run: Run, mark: str) -> None:
    code, out, _ = run("explain", SHAPER, mark, "--position", 3, "--all")
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


def test_explain_tells_at_first_a_dozen_steps_the_vector_equation_and_the_length_on_the_sheet(run: Run) -> None:
    leaf = leaves_of(Study(read_scene(SHAPER)))["kinematics"][0]
    shown = leaf.metadata["plans"][0]
    out = run("explain", SHAPER, "v_D", "--position", shown)[1]
    key = {"plan": "velocities", "kind": "vector", "name": "p d", "position": str(shown)}
    vector = next(group.strokes[0] for group in groups(leaf.groups) if key.items() <= group.data.items())
    assert isinstance(vector, Line)
    told = re.search(r"v_D: (\S+) m/s, (\S+) mm on the sheet", out)
    assert told and float(told[2]) == pytest.approx(abs(vector.end - vector.start), rel=1e-4)
    assert "     v_D = v_B + v_DB\n" in out and "earlier steps are left out: --all tells them" in out
    assert len(re.findall(r"(?m)^ *\d+\. ", out)) == 12


@pytest.mark.parametrize(
    ("name", "link", "key", "unit"), [("omega_3", "3", "omega", "rad/s"), ("epsilon_4", "4", "epsilon", "rad/s²")]
)
def test_explain_ends_with_the_rate_that_is_read_off(run: Run, name: str, link: str, key: str, unit: str) -> None:
    _, out, _ = run("explain", SHAPER, name, "--position", "2")
    _, solved, _ = run("solve", SHAPER, "--by", "analysis")
    true = json.loads(solved)["links"][link][key][2]
    last = out.splitlines()[-1]
    found = re.search(rf"= (\S+) {unit}, (counter-clockwise|clockwise)$", last)
    assert found and float(found[1]) == pytest.approx(true, rel=1e-4), last
    assert (found[2] == "counter-clockwise") == (true > 0)


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
    assert code == 3 and "does not turn" in err
