"""The JSON Schema for editors: itself valid, and of one mind with the reader of scenes on every scene we have."""

from __future__ import annotations

import json
import re
import tomllib
from decimal import Decimal
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from jsonschema import Draft202012Validator

from drawings.commands import cli
from geometry.errors import LimitError
from plans.scene import units
from plans.scene.faults import SceneError
from plans.scene.forms import techniques_of, text_with_unit
from plans.scene.readers import Refused
from plans.scene.scene import kinds_of
from plans.scene.schema import schema
from plans.scene.source import parse_source
from plans.scene.tables import holders_of, read_parts, tables_of
from plans.scene.units import UnitKind
from tests import parts
from tests.catalogue.scenes import SOUND, TEXTS
from tests.plans.test_scene_techniques import LINKAGE as PLAIN
from tests.rows import over

ROOT = Path(__file__).parent.parent.parent
FORM = schema()
EDITOR = Draft202012Validator(FORM)
SCENES = {path.stem: path.read_text("utf-8") for path in sorted((ROOT / "drawings/gallery").glob("*.toml"))}
SCENES |= SOUND | TEXTS
# What no schema can see: that angles are a turn apart, how a letter is coded, that equal letters are no line, which
# signs cannot be seen, that travel rises, that a number is none, that two places or links are one, that one length is
# more than another, that an order is one of a list.
UNSEEN = {
    "a14_decimal_comma_in_text",
    "b04_nan", "b21_repeated_position", "b_diagram_of_unequal_lists", "c01_point_twice_in_a_link",
    "c02_two_codings_of_a_letter", "c03_hidden_sign_in_a_title", "d13_guide_of_equal_points",
    "g08_diagram_of_travel_that_falls", "g08_diagram_that_covers_a_part_of_the_stroke", "j03_planes_coincide",
    "j_bank_compensator_of_another_order", "j_bank_member_twice", "j_bank_with_a_short_rod",
    "j_bank_with_rod_like_crank", "j_counterweight_twice", "k02_scale",
}  # fmt: skip


@cache
def readable(text: str) -> dict[str, Any] | None:
    """Give the tables of a scene that is TOML at all."""
    try:
        parse_source(text, "scene.toml")
        return tomllib.loads(text)
    except (SceneError, LimitError, tomllib.TOMLDecodeError):  # keys in Cyrillic are the reader's alone
        return None


@cache
def taken(text: str) -> bool:
    """Tell whether the reader takes the scene's form, whatever it means."""
    try:
        read_parts(kinds_of(techniques_of(tables := parse_source(text, "scene.toml").tables)), tables)
    except (Refused, LimitError):
        return False
    return bool(techniques_of(tables))


def test_the_schema_is_one() -> None:
    Draft202012Validator.check_schema(FORM)
    assert FORM["$schema"] == "https://json-schema.org/draft/2020-12/schema"


@pytest.mark.part
@over("name", [*SCENES] if parts.whole else [*SCENES][::8])
def test_an_editor_says_of_a_scene_what_its_reader_says(name: str) -> None:
    if tables := readable(SCENES[name]):
        marked = [error.message for error in EDITOR.iter_errors(tables)]
        assert not marked if taken(SCENES[name]) or name in UNSEEN else marked


BY_POINT, BETWEEN = 'on = 2\npoint = "B"\n', 'between = ["O", { on = 3, point = "B" }]\n'


@pytest.mark.parametrize(
    ("force", "right"),
    [
        (BY_POINT + "value = [1, 0]\n", True),
        (BY_POINT + 'value = 1\ndirection = "AB"\n', True),
        (BY_POINT + 'value = 1\ndirection = ["A", "B"]\n', True),
        (BY_POINT + 'value = 1\ndirection = "ABC"\n', False),
        (BY_POINT + 'value = 1\ndirection = "AB"\nagainst = "motion"\n', False),
        (BY_POINT + "value = 1\n", False),
        (BETWEEN + "value = 1\n", True),
        (BETWEEN + 'value = 1\ndirection = "AB"\nagainst = "motion"\n', True),
        (BETWEEN + "value = 1\ndirection = 90\n", False),
        (BETWEEN + "value = [1, 0]\n", False),
        (BETWEEN + "on = 2\nvalue = 1\n", False),
        ('on = 2\nvalue = 1\nagainst = "motion"\n', False),
        ("value = 1\n", False),
        (BETWEEN + 'pressure = "1 MPa"\nbore = 0.1\n', True),
        (BETWEEN + 'pressure = "1 MPa"\n', False),
        (BETWEEN + "value = 1\nbore = 0.1\n", False),
        (BETWEEN + "value = 1\npressure = 1\nbore = 0.1\n", False),
        (BETWEEN + 'diagram = { travel = [0, "5 %", 1], pressure = [0, "1 bar", 1] }\nbore = 0.1\n', True),
        (BETWEEN + 'diagram = { travel = [0, "5 mm"], force = [0, 1], back = [1, "3 N"] }\n', True),
        (BETWEEN + 'diagram = { travel = [0, "5 mm"], force = [0, 1] }\nrod = 0.1\n', False),
        (BETWEEN + 'diagram = { travel = [0, "5 kg"], force = [0, 1] }\n', False),
        (BETWEEN + "diagram = { travel = [0, 1], force = [0, 1], pressure = [0, 1] }\nbore = 1\n", False),
        (BETWEEN + "diagram = { travel = [0, 1] }\n", False),
        (BETWEEN + 'value = 1\nduring = "working direction"\nworking = "apart"\n', True),
        (BETWEEN + 'value = 1\nworking = "apart"\n', False),
        (BY_POINT + 'value = [1, 0]\nduring = "idle stroke"\nworking = "up"\n', False),
        (BY_POINT + 'value = [1, 0]\nduring = "idle stroke"\nstroke = "B"\nworking = "up"\n', True),
    ],
)
def test_an_editor_and_the_reader_are_of_one_mind_about_a_force(force: str, right: bool) -> None:
    text = PLAIN + "[[loads.forces]]\n" + force
    assert (not list(EDITOR.iter_errors(tomllib.loads(text)))) == right
    tables = tomllib.loads(text, parse_float=Decimal)
    try:
        read_parts(kinds_of(techniques_of(tables)), tables)
        reads = True
    except Refused:
        reads = False
    assert reads == right


KINDS = (units.LENGTH, units.ANGLE, units.SPEED, units.ANGULAR_ACCELERATION, units.ACCELERATION)
KINDS += (units.MASS, units.INERTIA, units.FORCE, units.MOMENT, units.STIFFNESS, units.PRESSURE)


@over("kind", KINDS)
@over("form", ["{n} {unit}", "{n}{unit}", " {n}  {unit} ", "{n}", "{n} {unit}x", "x {n} {unit}"])
@over("n", ["1", "-0.5", "+1e-3", "1.5E6", ".5", "5.", "1,5", "0x10", "1_000"])
def test_a_quantity_is_marked_where_the_reader_refuses_it(kind: UnitKind, form: str, n: str) -> None:
    pattern = re.compile(text_with_unit(kind))
    spelt = [*kind.listed, *units.Spelt(kind.listed).worded("ru").split(", ")]
    for unit in (*spelt, "turn", "kg·m²", "kg * m^2", "kg m2", "N m", "m/s**2", "КН", "с⁻¹", "МПА", "кгс/см2"):
        text = form.format(n=n, unit=unit)
        try:
            units.quantity(text, kind)
            reads = True
        except Exception:  # whatever the reader raises for a wrong value
            reads = False
        assert bool(pattern.search(text)) == reads, text


def test_every_key_is_described_in_the_words_of_the_trade() -> None:
    for path, kinds in tables_of(kinds_of()).items():
        for name, holders in holders_of(kinds).items():
            text = holders[0].keys[name].meaning
            assert text[:1].isupper(), (*path, name)
            assert text.endswith("."), (*path, name)


def test_the_command_prints_the_schema_or_writes_it(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["schema"]) == 0
    out, err = capsys.readouterr()
    assert (json.loads(out), err) == (FORM, "")
    assert cli.main(["schema", "-o", str(tmp_path / "scene.json")]) == 0
    assert json.loads((tmp_path / "scene.json").read_text("utf-8")) == FORM
    assert capsys.readouterr().out == f"{tmp_path / 'scene.json'}\n"
    assert cli.main(["schema", "-o", str(tmp_path / "no/where.json")]) == 7
