"""The generator of chains reaches what its relations are to be held for."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product

import pytest
from hypothesis import given, settings

from plans.model.dyad import NUMBERS, Dyad, decompose
from plans.model.mechanism import FRAME, Slide
from tests.plans.chains import Chain, chains

EXAMPLES = 200


def features(chain: Chain) -> Iterator[tuple[object, ...]]:
    """Tell what is particular to a chain: kinds and hosts, offsets of pins, which link owns a line, the drive."""
    mechanism = chain.mechanism
    yield "drive", mechanism.drive.omega > 0, mechanism.drive.epsilon != 0
    dyads = decompose(mechanism)
    yield "dyads", len(dyads)
    for dyad in dyads:
        hosts = tuple("frame" if host == FRAME else "moving" for host in dyad.hosts)
        yield dyad.kind, *hosts
        for end, joint in enumerate((*dyad.outer, dyad.inner)):
            if isinstance(joint, Slide):
                yield dyad.kind, "line", end, "slides" if joint.slider in dyad.links else "host slides"
                yield from _offsets(chain, dyad, end, joint)
    if any(len(owners) > 2 for owners in mechanism.hinges.values()):
        yield ("double hinge",)


def _offsets(chain: Chain, dyad: Dyad, end: int, slide: Slide) -> Iterator[tuple[object, ...]]:
    for number in (slide.slider, slide.owner):
        way, link = slide.way(number), chain.mechanism.links[number]
        pins = [name for name in link.points if name in chain.mechanism.hinges]
        for name in pins:
            left = ((link.points[name] - way.through) / way.direction).imag
            yield dyad.kind, "offset", end, "0" if abs(left) < 1e-12 else "left" if left > 0 else "right"


EVERY = {
    *product(("drive",), (True, False), (True, False)),
    *product(("dyads",), (1, 2, 3, 4)),
    *product(NUMBERS, ("moving",), ("frame",)),
    *product(NUMBERS, ("frame",), ("moving",)),
    *product(NUMBERS, ("moving",), ("moving",)),
    *((*line, way) for line in product(("PRP", "RRP", "RPP"), ("line",), (1,)) for way in ("slides", "host slides")),
    *product(("PRP",), ("line",), (0,), ("slides", "host slides")),
    *product(("RRP", "PRP"), ("offset",), (1,), ("0", "left", "right")),
    *product(("RPR", "RPP"), ("offset",), (2,), ("0", "left", "right")),
    ("double hinge",),
}


@pytest.mark.rest
def test_every_feature_is_reached():
    seen: set[tuple[object, ...]] = set()

    @settings(max_examples=EXAMPLES)
    @given(chains())
    def collect(chain: Chain) -> None:
        seen.update(features(chain))

    collect()
    assert seen >= EVERY
