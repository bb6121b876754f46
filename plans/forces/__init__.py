"""Forces: loads, force plans group after group, the lever, friction (силовой расчёт)."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from plans.techniques import MOTION, Technique, late
from plans.words.words import Message, message

if TYPE_CHECKING:
    from plans.scene.scene import Scene


class ForcesTechnique(Technique):
    """Forces."""

    tables = ("masses", "loads", "friction")
    shares = {"drive": ("balancing", "gear"), "sheet": ("forces", "reactions", "hodographs")}
    plans = ("forces", "friction")
    sheets = {"forces": (*MOTION, "forces", "friction")}
    needs = ("linkage",)
    scales = {
        "scheme": ("", "Of loading schemes, and of schemes of a balanced machine."),
        "force": ("N", "Of force plans, and of the hodograph of shaking forces."),
        "lever": ("m/s", "Of Zhukovsky's lever."),
        "moment": ("N*m", "Of the graph of the balancing moment, and of the moments of a bank of cylinders."),
        "way": ("m", "Of the way of load diagrams; of a link that swings, degrees a mm."),
    }
    form = late("reading.form:ForceForm")
    survey = late("reading.references:survey_of")
    notes = late("reading.references:notes_of")
    study = late("statics:Statics", "linkage.study:LinkageStudy")
    comparison = late("quantities:compare_forces", "forces.statics:Statics", "linkage.quantities:MotionComparison")
    numbers = late("quantities:numbers")
    marks = late("marks:marks")

    def idle(self, scene: Scene) -> Iterable[Message]:
        given = scene.has(("masses",)) or scene.has(("loads",))
        return [message("report.idle_loads" if given else "report.no_loads")]


TECHNIQUE = ForcesTechnique()
