"""What a scene gives of a technique that its sheets do not ask for, without importing that technique (не нужное)."""

from __future__ import annotations

from plans.scene.scene import Scene


def of_forces(scene: Scene) -> list[str]:
    """Say what a scene gives of forces that its sheets do not need."""
    if not scene.has(("masses",)) and not scene.has(("loads",)):
        return ["- Masses and loads: the sheet does not need them and the scene gives none."]
    return ["- Masses and loads of the scene: a kinematics sheet does not need them."]


def nothing(scene: Scene) -> list[str]:
    """Say nothing: a scene without it has nothing of it to leave out."""
    return []
