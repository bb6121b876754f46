"""Linkages: positions, velocities, accelerations by construction, and how far they reach (рычажный механизм)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plans.techniques import MOTION, Technique, late

if TYPE_CHECKING:
    from plans.study import Made, Study


class LinkageTechnique(Technique):
    """Linkages."""

    tables = ("mechanism", "drive", "output")
    shares = {"sheet": ("plans", "position")}
    plans = MOTION
    sheets = {"kinematics": (*MOTION, "diagrams"), "positions": ("positions",)}
    scales = {
        "length": ("", "Of the plan of positions."),
        "velocity": ("m/s", "Of all velocity plans."),
        "acceleration": ("m/s2", "Of all acceleration plans."),
    }
    form = late("reading.form:LinkageForm")
    survey = late("reading.linkage:survey_of")
    notes = late("reading.survey:notes_of")
    comparison = late("quantities:comparison_of")
    quantities = late("parts:quantities_of")
    numbers = late("quantities:numbers")
    marks = late("marks:marks")

    def study(self, study: Study) -> Made:
        from plans.linkage.study import LinkageStudy

        return LinkageStudy(study.scene, study.plans, study.pace)


TECHNIQUE = LinkageTechnique()
