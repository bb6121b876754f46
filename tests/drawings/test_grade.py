"""The command grade: a class is answered for file by file, by its exit code, in text, JSON and CSV, and on feedback."""

from __future__ import annotations

import base64
import csv
import io
import json
import re
import time
import tomllib
from functools import partial
from hashlib import sha256
from pathlib import Path

import pytest

from drawings.commands import cli
from drawings.commands import grade as commanded
from drawings.commands.grade import write_feedback
from drawings.grading import asked, class_list
from drawings.grading.allowance import Allowances
from drawings.grading.feedback import feedback, gathered, row
from drawings.grading.graded import FAIL, OURS, PASS, UNREAD, Graded, SheetTask, grade, idle_keys
from drawings.grading.verdict import OF_QUANTITIES, Marking, MarkingError, Verdict, points_of, read_marking
from tests.drawings.students import TABLED, task
from tests.drawings.test_grading import MISTAKES, made
from tests.gallery import GALLERY
from tests.parts import first

Capture = pytest.CaptureFixture[str]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A class of four: one is right, one has a mistake, one hands in a page of the web, one the same again."""
    own, where = task("shaper"), tmp_path_factory.mktemp("class")
    (where / "ann.svg").write_bytes(own.originals.drawn(own.originals.sheets[0]))
    (where / "bob.svg").write_bytes(made(own, MISTAKES[0], TABLED))
    (where / "cid.svg").write_bytes(b"<html><body>log in</body></html>")
    (where / "dan.svg").write_bytes((where / "bob.svg").read_bytes())
    return where


def test_a_class_is_graded_to_the_last_file(folder: Path, capsys: Capture) -> None:
    sheets = [str(folder / f"{name}.svg") for name in ("ann", "bob", "cid", "dan", "eve")]
    code = cli.main(["grade", str(GALLERY / "shaper.toml"), *sheets, "--json", "-o", str(folder / "back")])
    said = capsys.readouterr()
    told = json.loads(said.out)["sheets"]
    assert [one["outcome"] for one in told] == [PASS, FAIL, UNREAD, FAIL, UNREAD]
    assert (code, told[0]["points"]) == (5, told[0]["of"])
    assert told[1]["of"] - told[1]["points"] == 1
    assert "bob.svg" in said.err and "dan.svg" in said.err  # one file twice
    assert sorted(path.name for path in (folder / "back").iterdir()) == [
        "ann-feedback.svg", "bob-feedback.svg", "dan-feedback.svg",
    ]  # fmt: skip


def test_feedback_tells_no_value(folder: Path) -> None:
    own, path = task("shaper"), folder / "bob.svg"
    graded = grade(path.read_bytes(), SheetTask(own.plans), Allowances())
    text = feedback(path, path.read_bytes(), graded, {}, "en").decode()
    picture = re.search(r"base64,([^\"]+)", text)
    assert picture is not None and base64.b64decode(picture[1]) == path.read_bytes()
    notes = re.findall(r"<text[^>]*>([^<]*)</text>", text)
    assert "Coriolis part is turned" in " ".join(" ".join(notes).split())
    assert not re.search(r"\d[.,]\d", " ".join(notes))
    assert text.count('id="wrong-') == 1


def broken(source: bytes) -> Graded:
    if source == b"bug":
        raise KeyError("a bug")
    if source == b"memory":
        bytearray(128 * 2**20)  # with what it shares with ours it would have more than 150 megabytes
    while source == b"time":
        pass
    return Graded(PASS)


HALTED = {"bug": (OURS, "grade.bug"), "memory": (UNREAD, "grade.memory"), "time": (UNREAD, "grade.late")}


@pytest.mark.parametrize("names", first([("bug", "memory"), ("time",)]), ids=" ".join)  # a second of work goes by
def test_a_bug_of_ours_is_told_as_one_and_stops_nobody(
    names: tuple[str, ...], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(class_list, "SECONDS", 0.0)  # of work, rounded up to one
    paths = [tmp_path / name for name in (*names, "good")]
    for path in paths:
        path.write_bytes(path.name.encode())
    graded = [one for _, one in class_list.grade_all(paths, broken)]
    told = [(one.outcome, one.reason and one.reason.key) for one in graded]
    assert told == [*map(HALTED.__getitem__, names), (PASS, None)]


def waits(source: bytes) -> Graded:
    """Wait beside others, where a sheet says so for ever; one that has waited before is graded at once."""
    before = Path(source.decode())
    if before.suffix == ".never" or not before.exists():
        before.touch()
        time.sleep(600)
    return Graded(PASS)


@pytest.mark.rest  # the seconds of patience go by in it, though nothing works
def test_a_sheet_that_had_to_wait_is_tried_once_more_alone(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(class_list, "PATIENCE", 2.0)
    paths = [tmp_path / name for name in ("busy.svg", "never.svg", "again.svg")]
    for path, before in zip(paths, ("one.busy", "two.never", "three.busy"), strict=True):
        path.write_bytes(str(tmp_path / before).encode())
    graded = [one for _, one in class_list.grade_all(paths, waits, workers=3)]
    assert [one.outcome for one in graded] == [PASS, UNREAD, PASS]
    assert graded[1].reason is not None and graded[1].reason.key == "grade.late"


def test_each_sheet_has_a_feedback_sheet_of_its_own(tmp_path: Path, capsys: Capture) -> None:
    (sheet,) = task("shaper").originals.sheets
    source, names = task("shaper").originals.drawn(sheet), ("a/x.svg", "b/x.svg", "c/x-2.svg", "d/X.svg")
    for name in names:
        (tmp_path / name).parent.mkdir()
        (tmp_path / name).write_bytes(source)
    graded = [(tmp_path / name, Graded(PASS, digest=sha256(source).hexdigest())) for name in names]
    (tmp_path / "e.svg").write_bytes(b"<svg/>")
    gone = [(tmp_path / name, graded[0][1]) for name in ("e.svg", "f.svg")]
    write_feedback(tmp_path / "back", [*graded, *gone], {}, "en")
    back = [path.name.removesuffix("-feedback.svg") for path in (tmp_path / "back").iterdir()]
    assert sorted(back) == ["X-3", "x", "x-2", "x-2-2"]
    said = capsys.readouterr().err
    assert "e.svg: another file" in said and "f.svg: another file" in said


def test_a_scene_that_asks_for_nothing_says_so(monkeypatch: pytest.MonkeyPatch, capsys: Capture) -> None:
    monkeypatch.setattr(commanded, "sheet_task", lambda _: SheetTask())
    assert cli.main(["grade", str(GALLERY / "fan.toml"), "any.svg", "--language", "en"]) == 5
    assert "fan.toml: none of its sheets is graded" in capsys.readouterr().err


def test_points_are_those_of_the_table(tmp_path: Path, folder: Path) -> None:
    own, table = task("shaper"), tmp_path / "marks.toml"
    table.write_text('[points]\ndefault = 1\n"a^k" = 3\n[keeps]\ncoriolis = 0.5\n', encoding="utf-8")
    graded = grade((folder / "bob.svg").read_bytes(), SheetTask(own.plans), Allowances())
    won, most = points_of(graded.verdicts, read_marking(table))
    assert most - won == 1.5
    assert most == points_of(graded.verdicts, Marking())[1] + 4  # two positions


def test_a_cell_of_a_table_has_a_quarter_of_what_else_has_points() -> None:
    vector, cell = (Verdict(plan, 2, "v_B", "right") for plan in ("velocities", "table values"))
    tables = {"default = 2": 0.5, "table = 1": 1.0, '"table v_B" = 3': 3.0, "v_B = 5": 0.25}
    assert (Marking().most(vector), Marking().most(cell)) == (1.0, 0.25)
    for text, points in tables.items():
        assert Marking(tomllib.loads(text)).most(cell) == points, text


def test_an_empty_table_is_told_once_and_an_empty_plan_in_its_position() -> None:
    empty = [Verdict("table output", k, name, "missing") for k in range(12) for name in ("S", "v")]
    plans = [Verdict("velocities", k, "v_B", "missing") for k in (2, 9)]
    told = [(one.plan, one.position, one.name) for one in gathered([*empty, *plans])]
    assert told == [("table output", None, ""), ("velocities", 2, ""), ("velocities", 9, "")]
    assert len(list(gathered([empty[0]._replace(kind="right"), *empty[1:]]))) == 13


def test_a_row_names_each_mistake_though_a_whole_column_is_told_as_one() -> None:
    lacking = [Verdict("table output", k, name, "missing") for k in range(3) for name in ("S", "v")]
    there = [Verdict("table output", k, "a", kind) for k, kind in enumerate(("sign", "right", "wrong"))]
    told = row(Path("own.svg"), Graded("mistakes", (*lacking, *there)), Marking(), "en")[-1].split("; ")
    assert [any(f" {name}" in one for one in told) for name in ("S", "v")] == [True, True]
    assert len(told) == 4


@pytest.mark.parametrize(
    "text",
    [
        "[pionts]\n", "[costs]\nbad = 1\n", "[points]\nv_B = -1\n", "[points]\nv_B = nan\n", "]",
        f"[points]\nv_B = {'9' * 400}\n", f"[points]\nv_B = {'9' * 5000}\n", "[points]\ndefault = 1e308\n",
        "[keeps]\nreversed = 1.01\n", "[costs]\nbranch = 1\n",
        *(f"[keeps]\n{kind} = 0.5\n" for kind in ("scale", "unscaled", "right", "follows", "dead", "untabled")),
    ],
)  # fmt: skip
def test_a_wrong_table_is_refused(tmp_path: Path, text: str) -> None:
    table = tmp_path / "marks.toml"
    table.write_text(text, encoding="utf-8")
    with pytest.raises(MarkingError, match=r"marks\.toml"):
        read_marking(table)


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("[keeps]\nsign = 1\n\n[pionts]\n", 4),
        ("[points]\nv = 1\nv_B = -1\n", 3),
        ('[tolerance]\n# of the drawing\nv_B = "2 kg"\n', 3),
    ],
)
def test_a_wrong_table_is_told_with_its_line(tmp_path: Path, text: str, line: int) -> None:
    (table := tmp_path / "marks.toml").write_text(text, "utf-8")
    with pytest.raises(MarkingError, match=rf"marks\.toml:{line}: "):
        read_marking(table)


def test_a_share_may_be_kept_of_each_quantity_that_is_wrong(tmp_path: Path) -> None:
    table = tmp_path / "marks.toml"
    table.write_text("[keeps]\n" + "".join(f"{kind} = 1\n" for kind in OF_QUANTITIES), encoding="utf-8")
    assert {"wrong", "missing", "branch", "sign"} <= read_marking(table).keeps.keys()


def test_keys_that_change_nothing_are_told() -> None:
    own = task("shaper")
    good = Marking({"default": 1, "v": 2, "v_B": 1, "a^k": 1}, tolerance={"v_B": "1 mm"})
    idle = Marking({"v_Q": 1, "table": 1}, tolerance={"a^q": "1 mm"})
    assert idle_keys(good, SheetTask(own.plans)) == ()
    assert idle_keys(idle, SheetTask(own.plans)) == ("points.v_Q", "points.table", "tolerance.a^q")


def test_a_row_holds_no_formula(folder: Path) -> None:
    own = task("shaper")
    graded = partial(grade, task=SheetTask(own.plans), by=Allowances())((folder / "bob.svg").read_bytes())
    text = io.StringIO()
    csv.writer(text).writerow(row(Path("=cmd()\x1b.svg"), graded, Marking(), "en"))
    assert text.getvalue().startswith("'=cmd()\N{REPLACEMENT CHARACTER}.svg,mistakes,")


def test_plans_of_which_grading_knows_nothing_are_asked_for_as_others_are(monkeypatch: pytest.MonkeyPatch) -> None:
    known = {plan.plan: plan for plan in asked.plans_asked(task("fan").originals)}
    monkeypatch.setattr(asked, "RECORDS", {})
    plain = {plan.plan: plan for plan in asked.plans_asked(task("fan").originals)}
    assert plain.keys() == known.keys() | {"across"}
    for name, plan in known.items():
        assert plain[name].scales[name] == plan.scales[name]
        assert [one[:4] for one in plain[name].vectors] == [one[:4] for one in plan.vectors]
        corners = [one.corners for one in plan.vectors]
        assert [one.corners for one in plain[name].vectors] == corners and all(corners) == (name != "along")


@pytest.mark.rest
def test_a_sheet_of_another_task_is_rejected(folder: Path, capsys: Capture) -> None:
    assert cli.main(["grade", str(GALLERY / "feed-cam.toml"), str(folder / "ann.svg")]) == 5
    assert "plandraft form" in capsys.readouterr().out


def test_a_figure_loses_no_more_than_its_cap() -> None:
    wrong = [Verdict("velocities", 2, name, "wrong") for name in ("v_A", "v_B", "v_S2")]
    right = [Verdict("forces-2-3", 2, "G_2", "right"), Verdict("table values", None, "v_B", "missing")]
    for caps, won in (({}, 1.0), ({"velocities": 1}, 3.0), ({"velocities": 1, "table values": 0}, 3.25)):
        assert points_of([*wrong, *right], Marking(caps=caps)) == (won, 4.25)


def test_a_balancing_whose_crank_has_no_mass_is_graded(tmp_path: Path) -> None:
    """Its main-point vectors lie beside crank and rod in lanes of both, so that their ends do not meet on paper."""
    text = (GALLERY / "four-bar-balance.toml").read_text("utf-8")
    (tmp_path / "scene.toml").write_text(re.sub(r"\n1 = \{ mass.*", "", text, count=1), "utf-8")
    assert cli.main(["draw", str(tmp_path / "scene.toml"), "-o", str(tmp_path)]) == 0
    assert cli.main(["grade", str(tmp_path / "scene.toml"), str(tmp_path / "scene-balancing.svg")]) == 0
