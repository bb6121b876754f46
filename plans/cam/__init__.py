"""Cams by construction: laws, main sizes by tangents, profile by inversion (кулачковые механизмы)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plans.techniques import Technique, late

if TYPE_CHECKING:
    from plans.quantity import Comparison
    from plans.study import Made, Study


class CamTechnique(Technique):
    """Cams by construction."""

    tables = ("cam",)
    plans = ("laws", "sizes", "profile")
    sheets = {"cam": ("laws", "sizes", "profile"), "profile": ("profile",)}
    scales = {"cam": ("", "Of a cam's profile and of the figure of its sizes.")}
    form = late("reading.form:CamForm")
    survey = late("reading.cams:survey_of")
    notes = late("reading.notes:notes_of")
    asks = late("reading.cams:asked_of")
    quantities = late("quantities:quantities_of")
    numbers = late("numbers:numbers")
    marks = late("marks:marks")

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


TECHNIQUE = CamTechnique()
