"""Structure: the crank and its groups found whatever the order of the tables, and what is no dyad refused (6.4.4)."""

from __future__ import annotations

from dataclasses import replace
from itertools import permutations

import pytest

from plans.linkage.study import LinkageStudy
from plans.model.dyad import NUMBERS, decompose, formula, mechanism_class
from plans.model.mechanism import FRAME, Drive, Mechanism, Slide, StructureError, Way
from plans.scene.scene import parse_scene
from tests.plans import linkages

TABLES = {
    "frame": "[mechanism.frame]\nO = [0, 0]\nC = [0, -0.350]\n",
    "links": '[mechanism.links]\n1 = "OA"\n2 = "A"\n3 = "CB"\n4 = "BD"\n5 = "D"\n',
    "lengths": "[mechanism.lengths]\nOA = 0.110\nCB = 0.620\nBD = 0.200\n",
    "sketch": "[mechanism.sketch]\nB = [0.2, 0.24]\nD = [0.4, 0.25]\n",
    "drive": '[drive]\nlink = 1\nspeed = "60 rpm"\nstart = 20\n',
}
SLOT = '[[mechanism.slides]]\nlink = 2\nalong = "CB"\n'
GUIDE = "[[mechanism.slides]]\nlink = 5\nalong = { through = [0, 0.250], angle = 0 }\n"
SHAPER = "I(0,1) -> II3(2,3) -> II2(4,5)"


@pytest.mark.parametrize("order", [*permutations(TABLES)][::17], ids="-".join)
@pytest.mark.parametrize("slides", [SLOT + GUIDE, GUIDE + SLOT], ids=["slot first", "guide first"])
def test_formula_of_the_shaper_for_any_order_of_tables(order, slides):
    lines = "".join(TABLES[name] for name in order) + slides
    study = LinkageStudy(parse_scene(lines))
    assert formula(study.mechanism, study.groups) == SHAPER
    assert mechanism_class(study.groups) == "II"


# Each dyad, links 2 and 3: where its outer leads hang on the crank 1 and on the frame, or on the moving link 4.

AXIS, ACROSS = Way(0j, 1 + 0j), Way(0j, 1j)


def hung(kind: str, host: int, swapped: bool) -> Mechanism:
    """Hang a dyad of links 2 and 3 on the crank and on a host: the frame, or a link that the crank moves by itself."""
    links: dict[int, dict[str, complex]] = {
        FRAME: {"O": 0j, "F": 3 + 0j},
        1: {"O": 0j, "A": 1 + 0j},
        2: {},
        3: {},
        4: {"A": 0j, "G": 1 + 0j},
        5: {"F": 0j, "G": 1 + 0j},
    }
    slides = []
    ends = ((kind[0], 2, 1, "P"), (kind[1], 2, 3, "Q"), (kind[2], 3, host, "R"))
    for letter, one, other, point in ends:
        if letter == "R":
            links[one][point] = links[other][point] = complex(len(links[one]))
        else:
            first, second = (other, one) if swapped else (one, other)
            line = ACROSS if point == "Q" else AXIS  # a slot that crosses the guide
            slides.append(Slide(first, second, line, line, "", ""))
    for number in (2, 3):
        links[number].setdefault(f"S{number}", 0j)
    drive = Drive(1, "O", "A", 1.0, 0.0)
    return linkages.mechanism("dyad", links, tuple(slides), drive, {}, None)


@pytest.mark.parametrize("swapped", [False, True], ids=["lead slides", "host slides"])
@pytest.mark.parametrize("host", [FRAME, 4], ids=["frame", "moving"])
@pytest.mark.parametrize("kind", NUMBERS)
def test_every_kind_is_recognised(kind, host, swapped):
    mechanism = hung(kind, host, swapped)
    assert mechanism.mobility == 1
    found = {dyad.links if dyad.links[0] < dyad.links[1] else dyad.links[::-1]: dyad for dyad in decompose(mechanism)}
    dyad = found[2, 3]
    assert (dyad.kind, set(dyad.hosts)) == (kind, {1, host})
    assert dyad.label.startswith(f"II{NUMBERS[kind]}(")
    if kind[0] != kind[2]:
        assert isinstance(dyad.outer[0], str)  # the hinge's lead comes first
    last = decompose(mechanism)[-1]
    assert set(last.links) == ({2, 3} if host == 4 else {4, 5})


def test_three_sliding_pairs_are_no_group():
    with pytest.raises(StructureError, match="three sliding pairs") as caught:
        decompose(hung("PPP", FRAME, False))
    assert set(caught.value.links) == {2, 3}


def test_double_hinges_hold_two_groups():
    """Three links in one pin: the second group hangs on it whichever of its links has the lower number."""
    base = linkages.four_bar(0.1, 0.4, 0.3, 0.35, sketch={"B": 0.4 + 0.3j})
    for rod, slider in ((4, 5), (5, 4)):
        links = dict(base.links)
        links[rod] = base.links[2]._replace(number=rod, points={"B": 0j, "D": 0.5 + 0j})
        links[slider] = base.links[2]._replace(number=slider, points={"D": 0j})
        guide = Slide(slider, FRAME, AXIS, Way(0.2j, 1 + 0j), "D", "")
        mechanism = replace(base, links=links, slides=(guide,))
        assert mechanism.mobility == 1
        assert formula(mechanism, decompose(mechanism)) == f"I(0,1) -> II1(2,3) -> II2({rod},{slider})"


def test_a_triad_is_refused_by_name():
    with pytest.raises(StructureError, match="class III") as caught:
        decompose(linkages.triad())
    assert caught.value.links == (2, 3, 4, 5)
