"""Cyclograms to try: scenes of the gallery's linkages with a tool and its overrun (циклограммы)."""

from __future__ import annotations

import re

from plans.cyclogram.study import CYCLOGRAM, CyclogramStudy
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.gallery import GALLERY

SHOWN = re.compile(r"^(?:plans|position|forces|hodographs|reactions) = .*\n", re.MULTILINE)
OVERRUN = "overrun = 0.1\nbreaks = [0.5, 0.75]\n"


def scene_text(name: str, told: str = OVERRUN) -> str:
    """Give the text of a gallery's scene that asks for a cyclogram alone."""
    text = (GALLERY / f"{name}.toml").read_text("utf-8")
    text = re.sub(r"sheets = \[.*?\]", 'sheets = ["cyclogram"]', text, count=1)
    return f"{SHOWN.sub('', text)}\n[cyclogram]\n{told}"


def study_of(name: str, told: str = OVERRUN, old: str = "", new: str = "") -> Study:
    """Give the study of such a scene, a part of its text changed."""
    text = scene_text(name, told)
    assert old in text
    return Study(parse_scene(text.replace(old, new) if old else text))


def cyclogram_of(name: str, told: str = OVERRUN, old: str = "", new: str = "") -> CyclogramStudy:
    """Give the study of the cyclogram of such a scene."""
    found: CyclogramStudy = study_of(name, told, old, new)[CYCLOGRAM]
    return found
