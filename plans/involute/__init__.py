"""The involute pair: profiles, line of action, generation by a rack, what is measured (эвольвентная передача)."""

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


class InvoluteTechnique(Technique):
    """The geometry of an involute pair."""

    tables = ("involute",)
    plans = ("involute", "generation")
    sheets = {"involute": ("involute", "generation")}
    scales = {"mesh": ("", "Of teeth in mesh."), "generation": ("", "Of a tooth as the rack cuts it.")}

    def form(self) -> type[TechniqueForm]:
        from plans.involute.reading import InvoluteForm

        return InvoluteForm

    def survey(self, meaning: Meaning) -> Survey:
        from plans.involute.reading import survey_of

        return survey_of(meaning)

    def notes(self, scene: Scene) -> Iterable[Fault]:
        from plans.involute.reading import notes_of

        return notes_of(scene)

    def study(self, study: Study) -> Made:
        from plans.involute.reading import pair_of
        from plans.involute.study import InvoluteStudy

        return InvoluteStudy(pair_of(study.scene))

    def comparison(self, study: Study) -> Comparison:
        from plans.involute.quantities import compare_pair
        from plans.involute.study import InvoluteStudy

        return compare_pair(study.of(InvoluteStudy))

    def marks(self, study: Study, position: int, name: str) -> Explanation | NoMark:
        from plans.involute.quantities import marks

        return marks(study, position, name)


TECHNIQUE = InvoluteTechnique()
