"""An edition (издание): the sheets of a scene laid out, each signed with the scene that it is of and the version."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from drawings import VERSION
from drawings.measure.seal import digest
from drawings.paper.strokes import Leaf
from drawings.sheets.documents import bind
from drawings.sheets.table import SHEETS
from plans.scene.scene import Scene
from plans.study import Study
from plans.techniques import named


def leaves_of(study: Study) -> Mapping[str, Sequence[Leaf]]:
    """Lay out the sheets of a study, by kind; the data of each say of which scene it is, and of which version."""
    scene = study.scene
    leaves = bind({kind: named(SHEETS[kind].leaves)(study) for kind in scene.sheets}, scene)
    return {kind: tuple(_signed(leaf, scene) for leaf in own) for kind, own in leaves.items()}


def _signed(leaf: Leaf, scene: Scene) -> Leaf:
    return leaf._replace(metadata={**leaf.metadata, "scene": digest(scene.content), "plandraft": VERSION})
