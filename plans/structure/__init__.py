"""Structure: mobility, groups for each primary link, redundant constraints and their removal (структурный анализ)."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from plans.techniques import Technique

if TYPE_CHECKING:
    from plans.explanation import Explanation, NoMark
    from plans.quantity import Comparison
    from plans.scene.faults import Fault
    from plans.scene.scene import Meaning, Scene, Survey, TechniqueForm
    from plans.study import Made, Study


class StructureTechnique(Technique):
    """Structural analysis."""

    tables = ("structure",)
    plans = ("structure",)
    sheets = {"structure": ("structure",)}
    borrows = ("linkage",)
    scales = {"structure": ("", "Of the kinematic scheme of a structure.")}

    def form(self) -> type[TechniqueForm]:
        from plans.structure.reading import StructureForm

        return StructureForm

    def survey(self, meaning: Meaning) -> Survey:
        from plans.structure.reading import survey_of

        return survey_of(meaning)

    def notes(self, scene: Scene) -> Iterable[Fault]:
        from plans.structure.study import notes_of

        return notes_of(scene)

    def study(self, study: Study) -> Made:
        from plans.structure.study import StructureStudy

        return StructureStudy(study)

    def comparison(self, study: Study) -> Comparison:
        from plans.structure.quantities import compare_structure
        from plans.structure.study import StructureStudy

        return compare_structure(study.of(StructureStudy))

    def marks(self, study: Study, position: int, name: str) -> Explanation | NoMark:
        from plans.structure.marks import marks

        return marks(study, position, name)


TECHNIQUE = StructureTechnique()
