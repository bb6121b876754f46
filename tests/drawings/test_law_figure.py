"""The figure of a law's diagrams: poles and scales in line, smoothing told, a law that is level."""

from __future__ import annotations

import math
from functools import cache

import numpy as np
import pytest

from drawings.cam import law_diagrams
from drawings.cam.law_diagrams import LawFrame
from drawings.cam.law_frame import LawPlate
from drawings.cam.notes import ACCELERATION, TRAVEL, VELOCITY, CamNotes
from drawings.layout.picture import Spot
from drawings.page.page import Field
from drawings.page.scale import Drafting, Scale
from drawings.paper.hand import hand_of
from plans.cam.diagrams import LawDiagrams
from plans.cam.diagrams import law_diagrams as diagrams_of
from plans.cam.tables import smoothing
from plans.model.cam import DWELL, POINTED, RETURN, RISE, ROCKING, Follower, Law
from plans.model.cam_motion import CamFound, Contour, Sizes
from tests.plans.law_cams import RULER, SMOOTH, STEADY, law_cam, usual

CAMS = {
    "smooth": usual(Law("sine"), Law("3-4-5")),
    "soft": usual(STEADY, Law("cosine")),
    "no dwell": law_cam((RISE, 180, Law("cosine")), (RETURN, 180, Law("cosine")), divisions=12),
    "rocker": usual(Law("sine"), lift=math.radians(25), follower=Follower(ROCKING, POINTED, 0.12)),
    "level": law_cam((DWELL, 360, None)),
}


@cache
def found(name: str) -> LawDiagrams:
    return diagrams_of(CAMS[name])


def framed(name: str, size: str = "A1") -> LawFrame:
    plate = LawPlate(found(name), Drafting(hand_of(size)))
    room = law_diagrams.measure(found(name), plate.drafting)
    scale = Scale(0.02, "φ", "rad")
    return LawFrame(plate, Spot(Field(0, 0, *room.size(scale)), scale))


@pytest.mark.parametrize("name", ["smooth", "soft", "no dwell", "rocker"])
def test_the_scale_of_an_integral_follows_from_its_pole(name: str) -> None:
    """mu_S' = mu_S'' mu_phi H1 and mu_S = mu_S' mu_phi H2; both poles have room beside the graph."""
    frame = framed(name)
    own = {row.key: row for row in frame.plate.rows}
    for key, below in ((ACCELERATION, VELOCITY), (VELOCITY, TRAVEL)):
        distance = frame.distance(own[below])
        assert distance is not None
        assert frame.scales[below].mu == pytest.approx(frame.scales[key].mu * frame.spot.scale.mu * distance)
        size, (least, most) = frame.plate.hand.letter, frame.plate.proportions.pole
        assert least * size <= distance <= most * size


@pytest.mark.parametrize(("language", "said"), [("en", "off its points by"), ("ru", "отступает не более чем на")])
def test_smoothing_is_never_silent(language: str, said: str) -> None:
    """Of a table that may be smoothed it is said by how much it is, and what was allowed: 0.01 of 30 mm."""
    cam, drafting = usual(Law("sine"), SMOOTH), Drafting(hand_of("A3"), language)
    contour = Contour(*(np.zeros(0),) * 9)  # type: ignore[arg-type]
    (told,) = CamNotes(CamFound(cam, Sizes(0.05), 0.0, contour), drafting).smoothed()
    off = drafting.number(30 * smoothing(SMOOTH)[0])
    assert f"{said} {off}" in told and drafting.number(0.3) in told
    plain = usual(Law("sine"), RULER)
    assert not list(CamNotes(CamFound(plain, Sizes(0.05), 0.0, contour), drafting).smoothed())
