"""The worked force analyses, as scenes beside their numbers, and scenes made of them."""

from __future__ import annotations

import json
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

from plans.forces.quantities import ForceComparison, compare_forces
from plans.forces.statics import Statics
from plans.linkage.quantities import compare
from plans.linkage.study import LinkageStudy
from plans.model.kinetostatics import Kinetostatics
from plans.quantity import Quantity
from plans.scene.scene import parse_scene
from tests.plans.scenes import changed

CASES = Path(__file__).parents[1] / "cases"
WORKED: Mapping[str, Any] = json.loads((CASES / "forces.json").read_text(encoding="utf-8"))
DYADS = ("kind-1", "kind-2", "kind-3", "kind-4", "kind-5")
ROADS = ("construction", "analysis")


def text_of(name: str, *changes: tuple[str, str]) -> str:
    """Give the text of a worked scene with some of its words changed; each must be there."""
    return changed((CASES / "forces" / f"{name}.toml").read_text(encoding="utf-8"), *changes)


def statics_of(text: str) -> Statics:
    """Give the statics of a scene's text."""
    return Statics(LinkageStudy(parse_scene(text)))


@cache
def worked(name: str) -> tuple[Statics, ForceComparison]:
    """Give a worked scene's statics, and its forces by both roads."""
    statics = statics_of(text_of(name))
    return statics, compare_forces(statics, compare(statics.study))


def compared(text: str) -> ForceComparison:
    """Give the forces of a scene's text by both roads."""
    statics = statics_of(text)
    return compare_forces(statics, compare(statics.study))


def of_road(comparison: ForceComparison, road: str) -> Kinetostatics:
    """Give the forces by one road."""
    return (comparison.construction, comparison.analysis)[ROADS.index(road)]


def finding(comparison: ForceComparison, name: str) -> Quantity:
    """Give the finding of a name."""
    (found,) = (one for one in comparison.findings if one.name == name)
    return found
