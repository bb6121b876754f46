"""The command form: blank sheets with all that a task gives, and nothing of its answer."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from drawings.checks.verify import SelfCheckFailed
from drawings.files.atomic_files import json_text
from drawings.form import laid
from drawings.form.blank_file import blank_file, see_blank
from drawings.form.form import form_of
from drawings.form.laid import given
from drawings.layout.picture import Place
from drawings.page.page import BLOCK, Scale
from drawings.paper.strokes import GIVEN, PLAIN, Arc, Circle, Group, Leaf, Line, Polyline, Text
from drawings.paper.walk import flat, groups, texts
from drawings.pens.svg import svg
from drawings.reading.sheet import see, ungiven
from drawings.rotor.sheet import SHEETS as ROTOR
from drawings.sheets.documents import leaves_of
from drawings.sheets.kind import PLAN, sheet_kind
from drawings.symbols.figure import Subject, point, vector
from plans.scene.forms import SHEETS
from plans.scene.scene import parse_scene, read_scene
from plans.study import Study
from tests.drawings.conftest import Run
from tests.gallery import GALLERY, SCENES
from tests.parts import first
from tests.rows import over

IN_TURN = sorted(SCENES, key=lambda path: path.stem != "crank-rocker")  # the first every day, all with --whole
ROUNDED = range(3, 8)  # digits that a result may be written with
NEARLY = (("18.57", "18.75"), ("20.46", "20.64"), ("21.34", "21.43"))  # of the same digits: of one width in writing
STATED = """
[sheet.scale]
length = 0.002
velocity = 0.02
acceleration = 0.2
"""


@cache
def form(path: Path) -> tuple[Study, tuple[Leaf, ...]]:
    study = Study(read_scene(path))
    return study, tuple(leaf for own in form_of(study).values() for leaf in own)


def results(value: Any) -> Iterator[float]:
    match value:
        case bool() | None | str():
            return
        case int() | float():
            yield abs(float(value))
        case dict():
            yield from (number for one in value.values() for number in results(one))
        case list() | tuple():
            yield from (number for one in value for number in results(one))


def written(source: bytes) -> Iterator[str]:
    """Give all that is written into a form, or beside its strokes: lettering, data, titles, description."""
    seen = see(source)
    yield from (one.plain for one in flat(seen.written.groups) if isinstance(one, Text))
    text = source.decode("utf-8")
    marks = re.sub(r'<[^>]*data-kind="corner"[^>]*>', "", text)  # of the frame
    yield from re.findall(r'data-[a-z]+="([^"]*)"', marks)
    yield from re.findall(r"<(?:title|desc|metadata)[^>]*>([^<]*)<", text)


@pytest.mark.rest
@pytest.mark.parametrize("path", first(IN_TURN))
def test_no_result_is_written_on_a_form(path: Path) -> None:
    study, leaves = form(path)
    known = given(study.scene)
    answers = {
        spelling
        for technique in study.techniques
        for road in ("construction", "analysis")
        for number in results(json.loads(json_text(study.numbers(technique, road).plain())))
        for scale in (1.0, 57.29577951308232)
        for spelling in (
            f"{(number * scale):.{digits - 1}e}".split("e")[0].replace(".", "").rstrip("0") for digits in ROUNDED
        )
        if len(spelling) > 2
    }
    assert leaves and len(answers) > 10
    for leaf in leaves:
        page = flat(group for group in leaf.groups if group.name in ("frame", BLOCK))
        for text in set(written(blank_file(leaf))) - {one.plain for one in page if isinstance(one, Text)}:
            for numeral in re.findall(r"\d+(?:[.,]\d+)?", text):
                bare = numeral.replace(".", "").replace(",", "").strip("0")
                assert bare not in answers or known.says(text), text


def speedy(speed: str, lettering: str = "text") -> bytes:
    """Draw the form of a linkage whose scales are stated, at a speed of its crank."""
    text = (GALLERY / "crank-rocker.toml").read_text("utf-8")
    text = re.sub(r"(?m)^speed *=.*$", f'speed = "{speed} rad/s"', text)
    head, sheet, rest = text.partition("[sheet]\n")
    scene = parse_scene(f'{head}{sheet}lettering = "{lettering}"\n{rest}{STATED}', "speedy.toml")
    return b"".join(blank_file(leaf) for leaf in form_of(Study(scene))["kinematics"])


@pytest.mark.rest
def test_scenes_that_differ_in_what_is_sought_have_one_form() -> None:
    # A place that is known to a quarter of its size may change with the speed, but not with each of these.
    assert any(speedy(slow) == speedy(fast).replace(fast.encode(), slow.encode()) for slow, fast in NEARLY)


def test_every_kind_of_sheet_says_what_of_it_is_the_task() -> None:
    assert [sheet for sheet in SHEETS if not sheet_kind(sheet).figures] == []
    assert [sheet for sheet in SHEETS if not sheet_kind(sheet).tables] == ["positions"]


@pytest.mark.rest
def test_a_figure_that_nobody_knows_is_left_out(monkeypatch: pytest.MonkeyPatch) -> None:
    study, _ = form(GALLERY / "fan.toml")
    (leaf,) = leaves_of(study)["rotor"]
    whole = {one.name for one in laid.figures(leaf, "rotor", given(study.scene))}
    monkeypatch.setitem(ROTOR, "rotor", ROTOR["rotor"]._replace(figures={"across": PLAN}))
    assert {one.name for one in laid.figures(leaf, "rotor", given(study.scene))} == {"across"} < whole


def test_a_form_has_places_poles_and_the_heads_of_its_tables() -> None:
    _, (leaf,) = form(GALLERY / "crank-rocker.toml")
    seen = see(blank_file(leaf))
    assert not seen.measured.vectors
    poles = re.findall(r'data-kind="pole"[^>]*data-plan="(\w+)"', blank_file(leaf).decode("utf-8"))
    assert set(poles) == {"positions", "velocities", "accelerations"}
    assert [one.name for one in seen.measured.points] == ["C"]
    lettering = [one.plain for one in flat(seen.written.groups) if isinstance(one, Text)]
    assert {"p", "π", "by plan", "by analysis"} < set(lettering)


def test_the_poles_of_a_train_stand_by_the_three_scales_of_its_form_apart() -> None:
    _, (leaf,) = form(GALLERY / "planetary-reducer.toml")
    at = {group.data["name"]: group.strokes[0].centre for group in groups(leaf.groups) if "name" in group.data}
    told = " ".join(text.plain for text in texts(leaf.groups)).replace(",", ".")
    v, length, omega = (float(re.findall(rf"μ{letter} = ([\d.]+)", told)[0]) for letter in "vlω")
    assert at["0"] - at["P"] == pytest.approx(1j * v / length / omega, abs=1e-6)


def test_a_form_gives_the_scheme_of_its_mechanism_of_which_no_line_is_graded() -> None:
    _, (leaf,) = form(GALLERY / "crank-rocker.toml")
    (scheme,) = (group for group in leaf.groups if group.name == GIVEN)
    assert {"O", "A", "B", "C", "E", "0", "1", "2", "3", "ω1"} <= {text.plain for text in texts((scheme,))}
    whole = see(blank_file(leaf)).leaf
    read = [{text.plain for text in texts(part.groups)} for part in (whole, ungiven(whole))]
    assert ["E" in every for every in read] == [True, False]
    assert "Velocity plan, position 4; position 10: ab" in leaf.description
    _, (structure,) = form(GALLERY / "spatial-rocker.toml")
    assert GIVEN in {group.name for group in structure.groups}


def planted(leaf: Leaf, *strokes: Any) -> bytes:
    return blank_file(leaf._replace(groups=(*leaf.groups, Group(strokes))))


@pytest.mark.rest
@over("path", IN_TURN)
def test_a_form_has_nothing_of_its_answer(path: Path) -> None:
    study, leaves = form(path)
    for leaf in leaves:
        see_blank(blank_file(leaf), study)


def test_a_form_with_anything_of_its_answer_is_withheld() -> None:
    study, (leaf,) = form(GALLERY / "crank-rocker.toml")
    see_blank(blank_file(leaf), study)
    place = Place(300 + 300j, 0j, Scale(0.02, "v", "m/s"))
    arrow = vector(Subject("velocities", "v", 0), "p b", (0j, 1 + 1j), place, PLAIN)
    dot = point(Subject("positions", "r", 0), "B", 0.1234 + 0.2j, place, Circle(290 + 290j, 1.0))
    said = (Text(300 + 300j, text) for text in ("v_{B} = 1.2345 m/s", "v_{B} = 0.28 m/s", "R = 215 N"))
    bare = (Arc(300 + 300j, 50.0, 0.0, 1.0), Polyline((300 + 300j, 310 + 300j, 310 + 310j)), Line(300j, 310j))
    for stroke in (arrow, dot, *said, *bare):
        with pytest.raises(SelfCheckFailed):
            see_blank(planted(leaf, stroke), study)


def test_the_sheet_itself_is_no_form() -> None:
    study, _ = form(GALLERY / "fan.toml")
    (leaf,) = leaves_of(study)["rotor"]
    with pytest.raises(SelfCheckFailed):
        see_blank(svg(leaf), study)


def test_the_command_writes_a_set_beside_the_sheets(tmp_path: Path, run: Run) -> None:
    scene = GALLERY / "fan.toml"
    code, out, err = run("form", scene, "-o", tmp_path, "--language", "en")
    assert (code, err) == (0, "")
    (sheet,) = out.split()
    assert sorted(path.name for path in tmp_path.iterdir()) == ["fan-form-manifest.json", "fan-form-rotor.svg"]
    assert Path(sheet) == tmp_path / "fan-form-rotor.svg"
    manifest = json.loads((tmp_path / "fan-form-manifest.json").read_text("utf-8"))
    assert manifest["scene"]["name"] == "fan.toml" and [one.keys() for one in manifest["files"]] == [{"name", "sha256"}]
    before = Path(sheet).read_bytes()
    assert b"Polygon of moments" in before and b"seal" not in before
    assert run("form", scene, "-o", tmp_path, "--language", "en")[0] == 0 and Path(sheet).read_bytes() == before


def test_a_scene_with_faults_gets_no_form(tmp_path: Path, run: Run) -> None:
    scene = tmp_path / "wrong.toml"
    scene.write_text("[rotor]\nspeed = 'quick'\n", "utf-8")
    code, out, err = run("form", scene, "-o", tmp_path / "out")
    assert (code, out) == (3, "") and "wrong.toml:2" in err and not (tmp_path / "out").exists()
