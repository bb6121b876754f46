"""What a scene gives of a technique that its sheets do not ask for, without importing that technique (не нужное)."""

from __future__ import annotations

from plans.scene.scene import Scene
from plans.words.words import word


def of_forces(scene: Scene) -> list[str]:
    """Say what a scene gives of forces that its sheets do not need."""
    given = scene.has(("masses",)) or scene.has(("loads",))
    return [word(scene.sheet.language, "report.idle_loads" if given else "report.no_loads")]


def of_dynamics(scene: Scene) -> list[str]:
    """Say that a scene's motion under its loads is not shown by the sheets that it asks for."""
    return [word(scene.sheet.language, "report.idle_dynamics")] if scene.has(("dynamics",)) else []


def nothing(scene: Scene) -> list[str]:
    """Say nothing: a scene without it has nothing of it to leave out."""
    return []
