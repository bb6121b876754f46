"""Workings beside figures are held to the analysis, faults of tests/cases/working_faults.toml among them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import cache

import pytest
from drawings.checks.balance import verify_balancing
from drawings.checks.rotor import verify_rotor

from drawings.checks import verify_forces, verify_kinematics
from drawings.checks.dynamics import verify_dynamics
from drawings.figures.workings.working import LENGTHS, MASSES, READING, SCALES, SEGMENTS, TANGENTS
from drawings.lettering.lettering import lettered
from drawings.measure.measure import Measured, measure
from drawings.page.page import Field
from drawings.paper.strokes import Group, Leaf
from drawings.pens.svg import svg
from drawings.sheets import balancing, dynamics, forces, kinematics, rotor
from drawings.sheets.draft import Caption, Draft
from drawings.sheets.leaves import compositions
from plans.scene.scene import Scene, parse_scene
from plans.study import Study
from tests.drawings.planting import ROOT, DrawingFault, drawing_faults, planted
from tests.parts import first

FAULTS = drawing_faults(ROOT / "tests" / "cases" / "working_faults.toml")
SHEETS = {
    "kinematics": (kinematics, verify_kinematics),
    "forces": (forces, verify_forces),
    "dynamics": (dynamics, verify_dynamics),
    "balancing": (balancing, verify_balancing),
    "rotor": (rotor, verify_rotor),
}
KINDS = (READING, LENGTHS, MASSES, SEGMENTS, SCALES, TANGENTS)
BOX = Field(100.0, 100.0, 300.0, 300.0)


@cache
def study_of(scene: str, notation: str = "mu") -> Study:
    path = ROOT / "drawings" / "gallery" / f"{scene}.toml"
    own = parse_scene(path.read_text(encoding="utf-8"), str(path))
    return Study(own.changed(sheet=own.sheet.changed(notation=notation)))


def drafts(study: Study, kind: str, patch: pytest.MonkeyPatch) -> list[Draft]:
    """Give what the sheets of a kind show."""
    found: list[Draft] = []
    with patch.context() as context:
        context.setattr(SHEETS[kind][0], "lay_out", lambda scene, own: found.extend(own) or ())
        SHEETS[kind][0].leaves(study)
    return found


def written(scene: Scene, draft: Draft, leaf: Leaf) -> Iterator[Group]:
    """Write all workings of the figures of the first sheet of a draft that it has not."""
    known = {group.name for group in leaf.groups}
    spots = compositions(scene, draft)[0].spots
    for one in draft.shows:
        if isinstance(one, Caption) and one.working and one.of in spots and one.panel.item.name not in known:
            yield one.write(BOX, spots[one.of])


@cache
def plain_leaf(scene: str, kind: str, notation: str = "mu") -> tuple[Leaf, Measured]:
    """Give the first sheet of a kind without its workings, and its marks as measured."""
    study = study_of(scene, notation)
    leaf = SHEETS[kind][0].leaves(study)[0]
    leaf = replace(leaf, groups=tuple(one for one in leaf.groups if not _is_working(one)))
    return leaf, measure(svg(lettered(leaf)))


def _is_working(one: object) -> bool:
    kind, _, figure = one.name.partition("-") if isinstance(one, Group) else ("", "", "")
    return kind in KINDS and not figure.isdigit()  # else a table


def told(scene: str, kind: str, patch: pytest.MonkeyPatch, notation: str = "mu") -> list[str]:
    """Give what the self-check has against the workings of a scene that it has not against its sheet."""
    study, (leaf, measured) = study_of(scene, notation), plain_leaf(scene, kind, notation)
    own = replace(leaf, groups=(*leaf.groups, *written(study.scene, drafts(study, kind, patch)[0], leaf)))
    assert any(map(_is_working, own.groups))
    before, after = ([str(one) for one in SHEETS[kind][1].faults(measured, one, study)] for one in (leaf, own))
    return [one for one in after if one not in before]


@pytest.mark.parametrize(
    ("scene", "kind", "notation"),
    [
        pytest.param("crank-rocker", "kinematics", "mu", marks=pytest.mark.rest),
        pytest.param("crank-rocker", "kinematics", "K", marks=pytest.mark.rest),
        pytest.param("slider-crank", "forces", "mu", marks=pytest.mark.rest),
        ("fan", "rotor", "mu"),
        pytest.param("four-bar-balance", "balancing", "K", marks=pytest.mark.rest),
        pytest.param("planer", "dynamics", "mu", marks=pytest.mark.rest),
        pytest.param("planer", "dynamics", "K", marks=pytest.mark.rest),
    ],
)
def test_workings_agree_with_the_analysis(
    scene: str, kind: str, notation: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert told(scene, kind, monkeypatch, notation) == []


@pytest.mark.parametrize("fault", first(FAULTS), ids=lambda fault: fault.name)
def test_a_fault_planted_into_a_working_is_told(fault: DrawingFault, monkeypatch: pytest.MonkeyPatch) -> None:
    plain_leaf(fault.scene, fault.sheet)
    with planted(fault):
        assert any(fault.says in one for one in told(fault.scene, fault.sheet, monkeypatch))
