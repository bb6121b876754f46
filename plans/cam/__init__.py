"""Cams by construction: laws, main sizes by tangents, profile by inversion (кулачковые механизмы)."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from plans.techniques import Technique

if TYPE_CHECKING:
    from plans.explanation import Explanation, NoMark
    from plans.quantity import Comparison, Quantity, Stated
    from plans.scene.faults import Fault
    from plans.scene.scene import Meaning, Scene, Survey, TechniqueForm
    from plans.study import Made, Study


class CamTechnique(Technique):
    """Cams by construction."""

    tables = ("cam",)
    plans = ("laws", "sizes", "profile")
    sheets = {"cam": ("laws", "sizes", "profile"), "profile": ("profile",)}
    scales = {"cam": ("", "Of a cam's profile and of the figure of its sizes.")}

    def form(self) -> type[TechniqueForm]:
        from plans.cam.reading.form import CamForm

        return CamForm

    def survey(self, meaning: Meaning) -> Survey:
        from plans.cam.reading.cams import survey_of

        return survey_of(meaning)

    def notes(self, scene: Scene) -> Iterable[Fault]:
        from plans.cam.reading.notes import notes_of

        return notes_of(scene)

    def asks(self, scene: Scene) -> Iterable[str]:
        from plans.cam.reading.cams import asked_of

        return asked_of(scene)

    def study(self, study: Study) -> Made:
        from plans.cam.reading.cams import CamSurvey
        from plans.cam.study import study_of
        from plans.cyclogram.study import CyclogramStudy

        waits = study.scene.meaning.of(CamSurvey).waiting
        return study_of(study.scene, study.of(CyclogramStudy).window if waits else None)

    def comparison(self, study: Study) -> Comparison:
        from plans.cam.quantities import compare_cams
        from plans.cam.study import CamStudy

        return compare_cams(study.of(CamStudy), frozenset(study.plans))

    def quantities(self, study: Study) -> Sequence[Quantity]:
        from plans.cam.quantities import quantities_of

        return quantities_of(study)

    def numbers(self, study: Study, by: str) -> Stated:
        from plans.cam.numbers import numbers

        return numbers(study, by)

    def marks(self, study: Study, position: int, name: str) -> Explanation | NoMark:
        from plans.cam.marks import marks

        return marks(study, position, name)


TECHNIQUE = CamTechnique()
