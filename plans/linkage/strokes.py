"""The strokes of the sliders on the frame besides the output: compressors and presses have several (ходы ползунов)."""

from __future__ import annotations

from plans.linkage.extreme import ExtremePositions, extremes
from plans.linkage.study import LinkageStudy
from plans.linkage.travel import frame_slide
from plans.model.mechanism import FRAME, Mechanism, Output, Slide


def other_sliders(mechanism: Mechanism, output: Output) -> list[Slide]:
    """List the slides of links on the frame but for the output's and the primary link's."""
    known = {frame_slide(mechanism, link) for link in (output.link, mechanism.drive.link)}
    return [slide for slide in mechanism.slides if slide.owner == FRAME and slide not in known]


def other_strokes(study: LinkageStudy) -> dict[Slide, ExtremePositions]:
    """Find the extreme positions of each such slider, of which it has any."""
    outputs = {slide: Output(slide.slider, slide.point) for slide in other_sliders(study.mechanism, study.output)}
    found = {slide: extremes(study.sweep, out) for slide, out in outputs.items()} if study.mechanism.drive.turns else {}
    return {slide: one for slide, one in found.items() if one is not None}
