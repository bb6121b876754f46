"""A scene is made of its techniques: each states its own tables, and a scene reads no form that it has no part in."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from plans.forces.reading.form import ForceForm
from plans.linkage.reading.form import LinkageForm
from plans.scene.faults import SceneError
from plans.scene.scene import kinds_of, parse_scene
from plans.scene.tables import holders_of
from tests.plans.scenes import scene
from tests.plans.wheel import WheelForm

ROOT = Path(__file__).parents[2]
LINKAGE = scene(
    frame="O = [0, 0]; C = [0.350, 0]", links="OA AB CB", lengths="OA = 0.100; AB = 0.400; CB = 0.300",
    sketch="B = [0.39, 0.30]", drive='link = 1; speed = "10 rad/s"',
)  # fmt: skip
ROTOR = 'sheets = ["rotor"]\nrotor.masses = [{ moment = 1, angle = 0 }]\n'
# The start of a program that knows a technique without a linkage, which stands in the table before a scene is read.
WHEELS = """
import sys
import types
from plans import techniques
class Wheel(techniques.Technique):
    tables, shares, plans, sheets = ("wheel",), {"sheet": ("spokes",)}, ("balance",), {"wheels": ("balance",)}
    study = comparison = numbers = marks = None
    def form(self):
        from tests.plans.wheel import WheelForm
        return WheelForm
    def survey(self, meaning):
        from tests.plans.wheel import Survey
        return Survey(meaning)
techniques.TECHNIQUES += ("wheel",)
sys.modules["plans.wheel"] = types.SimpleNamespace(TECHNIQUE=Wheel())
from plans.scene.scene import parse_scene
from plans.scene.schema import schema
from tests.plans.wheel import WheelForm
"""


def test_no_key_of_a_shared_table_is_stated_twice() -> None:
    for table in ("sheet", "drive"):
        holders = holders_of(kinds_of())[table]
        keys = [name for kind in holders for name in kind.keys[table].field.tables[0][1].keys]
        assert len(set(keys)) == len(keys)


def test_what_a_scene_says_of_a_technique_is_asked_by_its_form() -> None:
    scene = parse_scene(LINKAGE + "balancing = 'force'\n[sheet]\nplans = [1, 4]\nlanguage = 'ru'")
    assert scene.of(LinkageForm).sheet.plans == (1, 4)
    assert (scene.sheet.language, scene.of(ForceForm).drive.balancing) == ("ru", "force")
    assert scene.part("forces") is scene.of(ForceForm)
    plain = parse_scene(LINKAGE)
    assert plain.part("forces") is None
    assert plain.of(ForceForm) == ForceForm()
    with pytest.raises(SceneError, match=r"expected \[wheel\] in the file.* Fix: add \[wheel\] with radius = 1"):
        plain.of(WheelForm)


@pytest.mark.parametrize(
    ("text", "where", "tables"),
    [
        ("sheets = ['kinematics']", ("sheets",), "[mechanism], [drive]"),
        ("sheets = ['forces']\n[drive]\nlink = 1\nspeed = 1", ("sheets",), "[mechanism]"),
        ("[friction]\ncoefficient = 0.1\nradius = 0.01", ("friction",), "[mechanism], [drive]"),
        ("[sheet]\nplans = [1]", ("sheet", "plans"), "[mechanism], [drive]"),
        ("[drive]\nbalancing = 'force'\nlink = 1\nspeed = 1", ("drive",), "[mechanism]"),
    ],
)
def test_what_lacks_a_table_says_which(text: str, where: tuple[str, ...], tables: str) -> None:
    with pytest.raises(SceneError) as refused:
        parse_scene(text)
    (fault,) = refused.value.faults
    assert (fault.kind, fault.path, fault.details["tables"]) == ("needs", where, tables)
    assert "нужно [mechanism]" in fault.worded("ru")


def wheels(*lines: str) -> list[str]:
    """Run a program that knows a wheel, and give what it says."""
    program = WHEELS + "\n".join(lines)
    done = subprocess.run([sys.executable, "-c", program], cwd=ROOT, capture_output=True, text=True, check=False)
    return (done.stdout + done.stderr).splitlines()


def test_a_scene_of_a_technique_without_a_linkage_imports_none() -> None:
    assert wheels(
        "scene = parse_scene('[wheel]\\nradius = 2\\n[sheet]\\nspokes = false')",
        "print(scene.techniques, scene.sheets, scene.of(WheelForm).wheel.radius, scene.of(WheelForm).sheet.spokes)",
        "print(scene.meaning.faults)",
        "print([name for name in sys.modules if name.startswith(('plans.linkage.', 'plans.forces.'))])",
    ) == ["('wheel',) ('wheels',) 2 False", "[]", "[]"]


def test_a_scene_without_forces_imports_nothing_of_them() -> None:
    assert wheels(
        f"scene = parse_scene({LINKAGE!r})",
        "print(scene.meaning.faults, scene.meaning['linkage'].mechanism.mobility)",
        "print([name for name in sys.modules if name.startswith(('plans.forces.', 'plans.rotor.'))])",
    ) == ["[] 1", "[]"]


def test_a_technique_says_itself_what_its_part_lacks_and_means() -> None:
    said = wheels(
        "key = '[wheel]\\nradius = '",
        "for text in ('sheets = [\\'wheels\\']', '[wheel]', f'{key}7', f'{key}2\\nplans = 1', ''):",
        "    try:",
        "        print(*parse_scene(text).meaning.faults)",
        "    except ValueError as error:",
        "        print(error)",
    )
    for line, part in zip(
        said,
        (
            "sheets = ['wheels']: expected [wheel] in the file, which this needs. Fix: add [wheel] with radius = 1",
            "wheel.radius: expected this radius. Fix: add it: radius = 1",
            "wheel.radius = 7: expected",
            "wheel.plans = 1: expected a key of [wheel]: radius. Fix: it belongs to [sheet]",
            ", [wheel]. Fix: start from",
        ),
        strict=True,
    ):
        assert part in line


def test_editors_know_its_tables_and_what_they_need() -> None:
    form, needed, wheel = wheels(
        "form = schema()",
        "print(*form['properties'])",
        "print(form['dependentRequired']['wheel'], {'required': ['wheel']} in form['anyOf'])",
        "print(form['properties']['wheel']['required'], 'spokes' in form['properties']['sheet']['properties'])",
    )
    assert form.split()[-1] == "wheel"
    assert needed == "['wheel'] True"
    assert wheel == "['radius'] True"


def test_a_scale_that_names_no_figure_says_how_it_is_written() -> None:
    with pytest.raises(SceneError) as refused:
        parse_scene(ROTOR + '[sheet]\nscale = "1:2"\n')
    assert 'write scale = { length = "1:2" }' in str(refused.value)
