"""A study (исследование): a scene, and what each technique makes of it, made once, when it is first asked for."""

from __future__ import annotations

from typing import Any

from plans.scene.scene import Scene
from plans.techniques import TECHNIQUES, named


class Study:
    """The memo of a scene: study["linkage"] is the linkage's study, made on first demand."""

    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        self._made: dict[str, Any] = {}

    def __getitem__(self, technique: str) -> Any:
        """Give the study of a technique."""
        if technique not in self._made:
            self._made[technique] = named(TECHNIQUES[technique].study)(self)
        return self._made[technique]
