"""Admission of cams: their names can be lettered (допуск кулачков)."""

from __future__ import annotations

from drawings.sheets.documents import letter
from plans.cam.reading.form import CamForm
from plans.scene.scene import Scene


def of_cams(scene: Scene) -> None:
    """See that the names of a scene's cams can be lettered; whatever else is read of them can be shown."""
    letter(scene, [(("cam", k, "name"), one.name) for k, one in enumerate(scene.of(CamForm).cam)])
