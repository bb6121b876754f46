"""What balancing refuses: asked for, but no counterweight that the scene allows does it (отказ)."""

from __future__ import annotations

from plans.model.balance.linkage import Task
from plans.scene.faults import SceneError
from plans.scene.scene import Scene

NEEDED, FREE, CARRIED, NEGATIVE, OFF, NO_SHARE, IDLE, NO_MASS = (
    "needs_counterweight",
    "slides_on_frame",
    "slides_on_link",
    "negative_counterweight",
    "counterweight_off_line",
    "no_reciprocating",
    "idle_counterweight",
    "rod_without_mass",
)
AIMED = (FREE, CARRIED, NO_SHARE)  # kinds that the aim is at fault for


class Refused(Exception):  # noqa: N818  (it says what was done)
    """A balance that cannot be: the kind of fault, the link whose counterweight it is about, its key and details."""

    def __init__(self, kind: str, at: int | None = None, key: str = "on", **details: object) -> None:
        super().__init__(kind)
        self.kind, self.at, self.key, self.details = kind, at, key, details

    def fault(self, scene: Scene, task: Task) -> SceneError:
        """Say it at the key of the scene that is to be changed."""
        index = next((k for k, place in enumerate(task.places) if place.link == self.at), None)
        if index is not None:
            return SceneError([scene.fault(("balance", "counterweights", index, self.key), self.kind, **self.details)])
        key = "aim" if self.kind in AIMED else "counterweights"
        path = ("balance", key) if scene.has(("balance", key)) else ("balance",)
        return SceneError([scene.fault(path, self.kind, **self.details)])
