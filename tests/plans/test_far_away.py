"""A mechanism far from the origin of its scene: every plan is the same to the bit, for places count from the datum."""

from __future__ import annotations

from decimal import Decimal

import numpy as np
import pytest

from plans.linkage.reading.form import LinkageForm
from plans.linkage.reading.linkage import mechanism_of
from plans.linkage.study import LinkageStudy
from plans.scene.scene import parse_scene
from tests.plans.scenes import scene

ORIGIN = (Decimal(0), Decimal(0))
FAR = [
    (Decimal("100000000.35"), Decimal("-100000000.2")),
    (Decimal("-123456789.012345678"), Decimal("1e8")),
    (Decimal("0.1"), Decimal("1e-9")),
]

FOUR_BAR = scene(
    frame="O = {0,0}; C = {0.35,-0.04}",
    links="OA ABE CB",
    lengths="OA = 0.1; AB = 0.4; CB = 0.3; AE = 0.22; BE = 0.25",
    sketch="B = {0.4,0.28}; E = {0.1,0.25}",
    drive="link = 1; speed = 10; acceleration = 5; start = 37; positions = 24",
)
SHAPER = scene(
    frame="O = {0,0}; C = {0,-0.35}",
    links="OA A CB BD D",
    lengths="OA = 0.12; CB = 0.7; BD = 0.2",
    slides=['link = 2; along = "CB"; offset = 0.01', "link = 5; along = { through = {0.7,0.33}, angle = 3 }"],
    sketch="B = {0.1,0.32}; D = {0.3,0.33}",
    drive='link = 1; speed = "-60 rpm"; start = "extreme"; positions = 24',
)
RAIL = scene(
    frame="O = {0,0}; K = {0.1,0.05}; L = {0.7,0.12}",
    links="OA AB B",
    lengths="OA = 0.06; AB = 0.2",
    slides=['link = 3; along = "KL"; offset = -0.01'],
    sketch="B = {0.25,0.05}",
    drive="link = 1; speed = 7; positions = 24",
)


def study_at(text: str, origin: tuple[Decimal, Decimal]) -> LinkageStudy:
    """Read a scene whose places in braces are moved by `origin`, written out in full."""
    moved = ""
    for part in text.split("{"):
        place, brace, rest = part.partition("}")
        numbers = place.split(",")
        if brace and len(numbers) == 2 and "=" not in place:
            shifted = (Decimal(number) + far for number, far in zip(numbers, origin, strict=True))
            moved += f"[{', '.join(format(number, 'f') for number in shifted)}]{rest}"
        else:
            moved += ("{" if moved else "") + part
    return LinkageStudy(parse_scene(moved))


@pytest.mark.parametrize("origin", FAR, ids=["100000000.35", "-123456789.012345678", "0.1"])
@pytest.mark.parametrize("text", [FOUR_BAR, SHAPER, RAIL], ids=["four-bar", "shaper", "rail"])
def test_a_far_frame_changes_no_bit(text, origin):
    near, far = study_at(text, ORIGIN), study_at(text, origin)
    assert mechanism_of(far.scene).datum == origin
    first, second = near.motion(), far.motion()
    assert not first.gaps and np.array_equal(first.phi, second.phi)
    for name, point in first.points.items():
        other = second.points[name]
        for one, same in ((point.r, other.r), (point.v, other.v), (point.a, other.a)):
            assert one is not None and same is not None and one.tobytes() == same.tobytes(), name
    for number, link in first.links.items():
        turned = second.links[number]
        pairs = ((link.angle, turned.angle), (link.omega, turned.omega), (link.epsilon, turned.epsilon))
        assert all(one is not None and same is not None and one.tobytes() == same.tobytes() for one, same in pairs)
    if near.form.drive.start == "extreme":
        assert near.extreme_positions is not None and far.extreme_positions is not None
        assert near.extreme_positions.extremes == far.extreme_positions.extremes


def test_the_braces_are_moved():
    scene = study_at(SHAPER, FAR[0]).scene
    assert scene.of(LinkageForm).mechanism.frame["C"] == (Decimal("100000000.35"), Decimal("-100000000.55"))
    assert scene.of(LinkageForm).mechanism.sketch["B"] == (Decimal("100000000.45"), Decimal("-99999999.88"))
