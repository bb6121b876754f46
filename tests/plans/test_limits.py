"""Where links do not reach: by how much they miss, between which crank angles, and how the notch tells it is near."""

from __future__ import annotations

from dataclasses import replace
from math import hypot, sqrt

import pytest

from geometry.meet import EPS
from plans.model.mechanism import Way
from tests.plans import linkages
from tests.plans.studies import study_of, value

OUT = "out of reach"
ALMOST = 1e-12  # m: far above the rounding of a distance, far below any length


@pytest.mark.parametrize("miss", [ALMOST, 1e-6])
def test_a_hair_too_short_is_a_gap_and_a_hair_too_long_is_drawn(miss):
    slot = linkages.slotted_link(0.12, 0.35, 0.70)  # its pivot passes the slot at no less than |OC| - |OA|
    for shift, found in ((-miss, {0: ("positions", OUT)}), (miss, {})):
        for mechanism, first in (
            (linkages.four_bar(0.1, 0.3, 0.15 + shift, 0.35, sketch={"B": 0.3 + 0.14j}), 180),
            (linkages.slider_crank(0.06, 0.20, 0.14 - shift), 270),
            (replace(slot, slides=(slot.slides[0]._replace(on_owner=Way((0.23 - shift) * 1j, 1 + 0j)),)), 270),
        ):
            study = study_of(mechanism, first)
            motion = study.motion(0)
            assert {gap.position: (gap.plan, gap.reason) for gap in motion.gaps} == found, mechanism.title
            for gap in motion.gaps:
                assert gap.miss == pytest.approx(miss, abs=8 * EPS)


@pytest.mark.parametrize("margin", [1e-2, 1e-4, 1e-6, 1e-10])
def test_a_notch_beside_a_dead_centre_carries_its_condition(margin):
    """Coupler and rocker nearly in one line: kappa is 1/sin of their angle, by the cosine rule from the exact miss."""
    mechanism = linkages.four_bar(0.1, 0.3, 0.15 + margin, 0.35, sketch={"B": 0.3 + 0.14j})
    sharpness = value(study_of(mechanism, 180, 1).drafts().positions.point("B").sharpness).real
    b, c, base = 0.3, 0.15 + margin, 0.45
    perimeter = (b + c + base) * margin * (base + b - c) * (base + c - b)
    assert sharpness == pytest.approx(sqrt(perimeter) / (2 * b * c), rel=1e-5)
    assert hypot(sharpness, (b**2 + c**2 - base**2) / (2 * b * c)) == pytest.approx(1)
