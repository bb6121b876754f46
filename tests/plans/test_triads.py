"""Triads: the worked values of M3.10, all digits; triads drawn by chance, held to closure equations in 60 digits."""

from __future__ import annotations

import cmath
from fractions import Fraction
from math import radians

import numpy as np
import pytest

from drawings.forces.report_equations import CutEquations
from drawings.page.page import drafting_of
from drawings.report.formula import Formula
from geometry.branch import AssemblyBranch
from geometry.errors import DraftError
from geometry.three_leads import BodyPose
from plans.analytic.assembly import never
from plans.analytic.kinematics import solve
from plans.linkage.dyads import KINDS
from plans.linkage.plan import Plan, rate
from plans.linkage.quantities import compare
from plans.linkage.study import LinkageStudy
from plans.model.decomposition import decompose
from plans.model.mechanism import FRAME, Drive, Mechanism, Slide, Way
from plans.model.triad import Triad, TriadLead
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.plans import linkages
from tests.plans.digits import printed
from tests.plans.force_cases import ROADS, compared, of_road, statics_of
from tests.plans.replays import Replay
from tests.plans.scenes import changed, scene
from tests.plans.studies import shown, study_of, value
from tests.plans.test_dyads import GUIDES, direction, guided
from tests.trials.judge import MP, case
from tests.trials.judgement import BORNE, errors

# Leads 2, 3, 4 of the basis link 5 hang on hinges of link 6, which does nothing else, and on guide 7 of M3.7.
PLACES = {"A1": 0j, "A2": 0.5 + 0j, "A3": 0.55 + 0.5j}
MOTION = {"A1": (0.3 - 0.5j, 2 - 4j), "A2": (-0.1 + 0.2j, 1 + 0.5j), "A3": (0.4j, -1 + 1.5j)}
B1, B2, B3 = 0.08 + 0.22j, 0.42 + 0.18j, 0.30 + 0.40j
RODS = Triad(5, tuple(TriadLead(k + 1, 6, f"A{k}", f"B{k}") for k in (1, 2, 3)))  # type: ignore[arg-type]


def drawn(triad: Triad, mechanism: Mechanism, places: dict[str, complex], out: int) -> list[Plan]:
    """Draw the three plans of a triad whose basis link lies as its own frame does."""
    plans: list[Plan] = []
    first = triad.leads[0]
    start = places[first.hinge]
    pose = BodyPose(np.array([mechanism.links[5].points[first.pin] - start]), np.array([1 + 0j]))
    branch = AssemblyBranch(1 + 0j, 0j, np.zeros(1), pose, out)
    for order, subject in enumerate(("positions", "velocities", "accelerations")):
        plan = Plan(subject, mechanism, tuple(plans))
        plan.board.given("φ", np.ones(1, complex))
        for point, place in places.items():
            plan.name(point, plan.board.given(plan.letter(point), (place, *MOTION[point])[order]))
        guided(plan, order, 7)
        plans.append(plan)
    kind = KINDS["triad"]
    kind.positions(plans[0], triad, branch)
    kind.velocities(plans[1], triad)
    kind.accelerations(plans[2], triad)
    return plans


def rods() -> list[Plan]:
    links = {k + 1: {f"A{k}": 0j, f"B{k}": abs(b - PLACES[f"A{k}"]) + 0j} for k, b in enumerate((B1, B2, B3), 1)}
    links |= {0: {}, 5: {"B1": B1, "B2": B2, "B3": B3}, 6: {**PLACES}, 7: {}}
    return drawn(RODS, linkages.mechanism("triad", links, (), Drive(6, "A1", "A1", 1, 0), {}, None), PLACES, 2)


def slid() -> list[Plan]:
    """Lead 2 slides on guide 7 with B1, lead 3 is a stone at A2 in the basis link's slot, lead 4 a rod A3 B3."""
    b1, places = GUIDES[7][0] + 0.05 * direction(7), {"A2": 0.48 + 0.08j, "A3": 0.62 + 0.42j}
    guide = Slide(2, 7, linkages.ALONG_X, linkages.ALONG_X, "B1", "")
    slot = Slide(3, 5, linkages.ALONG_X, Way(places["A2"], cmath.exp(1j * radians(80))), "A2", "")
    rod = 0.40 + 0.30j
    links = {0: {}, 2: {"B1": 0j}, 3: {"A2": 0j}, 4: {"A3": 0j, "B3": abs(rod - places["A3"]) + 0j}}
    links |= {5: {"B1": b1, "B3": rod}, 6: places, 7: {}}
    mechanism = linkages.mechanism("triad", links, (guide, slot), Drive(6, "A2", "A2", 1, 0), {}, None)
    leads = TriadLead(4, 6, "A3", "B3"), TriadLead(2, 7, guide, "B1"), TriadLead(3, 6, "A2", slot)
    return drawn(Triad(5, leads), mechanism, places, 0)


def test_rods():
    positions, velocities, accelerations = rods()
    assert printed(*(abs(shown(positions, f"A{k}B{k}")) for k in (1, 2, 3))) == (
        0.2340939982,
        0.196977156,
        0.2692582404,
    )
    assert printed(shown(positions, "S23")) == (0.225 + 0.61875j,)
    sharp = positions.images[5].origin.sharpness
    assert np.degrees(np.arcsin(sharp)) == pytest.approx(87.12323493, abs=5e-9)
    assert printed(shown(velocities, "s23"), *(shown(velocities, f"b{k}") for k in (3, 1, 2))) == (
        -0.78625 - 0.105j, 0.08281407035 + 0.1929648241j, 0.7979296482 - 0.6810653266j, 0.9568442211 + 0.6697085427j,
    )  # fmt: skip
    assert printed(*(value(rate(velocities, link)).real for link in (5, 2, 3, 4))) == (
        3.972864322, -2.263316583, -5.871356784, 0.8281407035,
    )  # fmt: skip
    assert printed(*(shown(accelerations, name) for name in ("s23", "b3", "b1", "b2"))) == (
        4.942039538 - 13.47178581j, 3.800710769 - 10.00455958j, 7.308040184 - 7.206190008j, 1.949360252 - 6.508872237j,
    )  # fmt: skip
    assert printed(value(rate(accelerations, 5)).real) == (0.1940345144,)


def test_all_assemblies_are_told():
    found = [np.asarray(pose.reach) for pose in KINDS["triad"].sides(rods()[0], RODS) if isinstance(pose, BodyPose)]
    angles = sorted(np.degrees(np.angle(reach[0])) for reach in found if np.isfinite(reach[0]))
    assert angles == pytest.approx([18.71762972, 70.01689348], abs=5e-9)


def test_leads_that_slide():
    positions, velocities, accelerations = slid()
    assert printed(shown(positions, "S23"), shown(velocities, "s23"), shown(velocities, "b3")) == (
        0.2038848941 + 0.1286865429j, -0.0907579668 + 0.2524141749j, 0.3652306282 - 0.2695894851j,
    )  # fmt: skip
    assert printed(value(rate(velocities, 5)).real, shown(velocities, "b1")) == (
        -2.661720818, -0.531926456 + 0.1342034345j,
    )  # fmt: skip
    assert printed(shown(accelerations, "s23"), value(rate(accelerations, 5)).real, shown(accelerations, "b1")) == (
        -1.501732104 - 3.88050706j, -126.3925536, -22.76538454 - 8.319509604j,
    )  # fmt: skip


KINDS_OF_LEADS = ["RR RR RR", "RR RR PR", "RR RR RP", "RR PR RP", "RR PR PR", "RR RP RP", "PR PR RP", "PR RP RP"]


def by_chance(kinds: str, seed: int) -> Mechanism:
    """Hang a basis link by three leads on a crank, on the frame and on the rocker of a four-bar before them."""
    chance = np.random.default_rng(seed)

    def spot(about: complex, size: float) -> complex:
        return complex(about + size * complex(*chance.uniform(-1, 1, 2)))

    o, a, c, b = 0j, 0.1 + 0j, 0.5 + 0j, spot(0.4 + 0.35j, 0.05)
    basis, corners = spot(0.3 + 0.9j, 0.1), [spot(way, 0.08) for way in (-0.3 - 0.1j, 0.3 - 0.1j, 0.3j)]
    seen: dict[int, dict[str, complex]] = {
        FRAME: {"O": o, "C": c}, 1: {"O": o, "A": a}, 6: {"A": a, "B": b}, 7: {"C": c, "B": b}, 5: {}
    }  # fmt: skip
    slides: list[Slide] = []
    hosts, ends = [7, FRAME, 1], [spot(0.3 + 0.3j, 0.1), spot(0.9 + 0.8j, 0.1), spot(0.1 + 0.5j, 0.1)]
    for k, (kind, host, end) in enumerate(zip(kinds.split(), hosts, ends, strict=True), 1):
        corner, link = basis + corners[k - 1], k + 1
        way = cmath.rect(1.0, float(chance.uniform(-3, 3)))
        seen[link] = {}
        if kind != "PR":
            seen[host][f"A{k}"] = seen[link][f"A{k}"] = end
        if kind != "RP":
            seen[5][f"B{k}"] = seen[link][f"B{k}"] = corner
        if kind == "PR":
            slides.append(Slide(link, host, Way(corner, way), Way(spot(corner, 0) + 0.2 * way, way), f"B{k}", ""))
        if kind == "RP":
            slides.append(Slide(link, 5, Way(end, way), Way(end + 0.3 * way, way), f"A{k}", ""))
    f, e = spot(1.3 + 1.2j, 0.1), spot(basis + 0.1, 0.05)
    d = spot(1.0 + 1.6j, 0.1)
    seen[5]["E"], seen[8], seen[9] = e, {"E": e, "D": d}, {"D": d, "F": f}
    seen[FRAME]["F"] = f
    return _in_own_frames(seen, slides)


def _in_own_frames(seen: dict[int, dict[str, complex]], slides: list[Slide]) -> Mechanism:
    """Take every link's first point for its origin, where it is drawn as it lies."""
    origins = {link: 0j if link == FRAME else next(iter(points.values())) for link, points in seen.items()}
    links = {link: {name: place - origins[link] for name, place in points.items()} for link, points in seen.items()}
    moved = tuple(
        slide._replace(
            on_slider=slide.on_slider._replace(through=slide.on_slider.through - origins[slide.slider]),
            on_owner=slide.on_owner._replace(through=slide.on_owner.through - origins[slide.owner]),
        )
        for slide in slides
    )
    sketch = {name: place for link in (5, 6, 8) for name, place in seen[link].items()}
    return linkages.mechanism("by chance", links, moved, Drive(1, "O", "A", 2.0, 3.0), sketch, None)


@pytest.mark.parametrize("kinds", KINDS_OF_LEADS)
@pytest.mark.parametrize("seed", [1])
def test_triads_by_chance(kinds: str, seed: int) -> None:
    """Moving hosts, dyads before and behind: both roads against joints closed in 60 digits."""
    mechanism = by_chance(kinds, seed)
    assert [group.kind for group in decompose(mechanism)] == ["RRR", "triad", "RRR"]
    comparison = compare(study_of(mechanism, positions=[0, 1]))
    direction = MP.expjpi(MP.mpf(1) / 180)
    for road in (comparison.construction, comparison.analysis):
        assert not road.gaps
        worst = errors(case(mechanism, direction, float(road.phi[1])), road, mechanism, 1)
        assert {key: one for key, one in worst.items() if not one <= BORNE} == {}


def loaded() -> str:
    """Write the geometry of the rods with the loads of M5.9, at rest: the crank's end is A1."""
    size = {k: abs(b - PLACES[f"A{k}"]) for k, b in enumerate((B1, B2, B3), 1)}
    own = {name: (spot - B1) / (B2 - B1) * abs(B2 - B1) for name, spot in {"B3": B3, "G": (B1 + B2 + B3) / 3}.items()}
    middles = "; ".join(f"M{k} = {{ on = {link}, at = [{size[k] / 2!r}, 0] }}" for k, link in ((1, 2), (2, 4), (3, 5)))
    spots = "; ".join(f"{name} = {{ on = 3, at = [{at.real!r}, {at.imag!r}] }}" for name, at in own.items())
    forces = [(3, "G", 40, -70), (2, "M1", 5, -8), (4, "M2", -3, -6), (5, "M3", 4, -7)]
    return scene(
        'title = "Loaded triad"; sheets = ["forces"]', frame="O = [-0.1, 0]; A2 = [0.5, 0]; A3 = [0.55, 0.5]",
        links="OA1 A1B1 B1B2 A2B2 A3B3",
        lengths="; ".join(
            ["OA1 = 0.1", f"B1B2 = {abs(B2 - B1)!r}", *(f"A{k}B{k} = {length!r}" for k, length in size.items())]
        ),
        points=f"{spots}; {middles}", sketch="B1 = [0.08, 0.22]; B2 = [0.42, 0.18]; B3 = [0.30, 0.40]",
        drive="link = 1; speed = 1; positions = [0]",
        forces=[f'on = {link}; point = "{point}"; value = [{x}, {y}]' for link, point, x, y in forces],
        moments=["on = 3; value = 2"],
    )  # fmt: skip


@pytest.mark.parametrize("road", ROADS)
def test_forces_by_moments_about_the_special_point(road: str) -> None:
    found = of_road(compared(loaded()), road).reactions
    along = [(b - PLACES[f"A{k}"]) / abs(b - PLACES[f"A{k}"]) for k, b in enumerate((B1, B2, B3), 1)]
    outer = [complex(found[key].force[0]) for key in ("1-2", "0-4", "0-5")]
    assert printed(*((way.conjugate() * force).real for way, force in zip(along, outer, strict=True))) == (
        78.65637908, 36.38414578, 59.76864184,
    )  # fmt: skip


def test_the_report_writes_each_sum_by_its_own_arms() -> None:
    """About each lead's hinge, then of the whole group about S: what is written on the left makes what is found."""
    statics = statics_of(loaded())
    plan = statics.drafts([0]).plans.plan
    formula = Formula(drafting_of(statics.study.scene))
    lines = [*CutEquations(plan, 0, formula, (0.0, 0.0)).lines(next(cut for cut in plan.cuts if cut.group))]
    about = [line.split(" = ")[0] for line in lines if "sum M" in line]
    assert about == [rf"$$\sum M_{{{sum_}}}" for sum_ in ("B1(2)", "B2(4)", "B3(5)", "S45(2,3,4,5)")]
    solved = [line.replace(r"\cdot", "*").split(" = ")[1:] for line in lines if "/" in line]
    assert len(solved) == len(about)
    for sum_, found in solved:
        assert abs(eval(sum_)) == pytest.approx(float(found.split("\\")[0]), rel=2e-4)


def test_a_triad_that_bears_nothing_gives_nothing() -> None:
    on_the_crank = '[[loads.forces]]\non = 1\npoint = "A1"\nvalue = [0, 5]\n'
    both = Study(parse_scene(loaded().split("[[loads")[0] + on_the_crank)).comparison("forces")
    assert both.agrees
    assert {key for key, one in both.construction.reactions.items() if one.force.any()} == {"0-1"}


@pytest.mark.parametrize("kinds", ["RR RR RR", "RR PR RP"])
def test_no_mark_is_farther_out_than_its_bound(kinds: str) -> None:
    replay = Replay(study_of(by_chance(kinds, 1), 0, 90))
    for position in (0, 1, 89):
        for mark, error, bound in replay.errors(position, Fraction(4 * position)):
            assert error <= bound or not bound > 0, mark.name


@pytest.mark.parametrize("kinds", ["RR RR PR", "PR RP RP"])
def test_both_roads_tell_where_the_leads_cannot_be_met(kinds: str) -> None:
    """A branch ends where the three lines of force meet in one point; beyond it positions are out of reach."""
    comparison = compare(study_of(by_chance(kinds, 20), 0, 24))
    ours, theirs = (
        [(gap.position, gap.plan, gap.reason) for gap in road.gaps]
        for road in (comparison.construction, comparison.analysis)
    )
    assert ours == theirs
    assert {reason for _, _, reason in ours} == {"out of reach"}
    assert comparison.agrees


PLATE = scene(
    'title = "Plate"', frame="O = [0, 0]; A2 = [0.5, 0]; A3 = [0.55, 0.5]", links="OA1 A1B1 B1B2B3 A2B2 A3B3",
    lengths="OA1 = 0.03; A1B1 = 0.25; B1B2 = 0.34; B1B3 = 0.28; B2B3 = 0.25; A2B2 = 0.2; A3B3 = 0.27",
    sketch="B1 = [0.08, 0.22]; B2 = [0.42, 0.18]; B3 = [0.30, 0.40]",
    drive="link = 1; speed = 1; start = 0; positions = 12",
)  # fmt: skip
BETWEEN = "B1 = [0.171, 0.142]\nB2 = [0.490, 0.176]\nB3 = [0.3326, 0.3516]"
AS_SHOWN = "B1 = [0.08, 0.22]\nB2 = [0.42, 0.18]\nB3 = [0.30, 0.40]"
PARALLEL = [
    ("A2 = [0.5, 0]\nA3 = [0.55, 0.5]", "A2 = [0.15, 0]\nA3 = [0.30, 0]"),
    ("A1B1 = 0.25\nB1B2 = 0.34\nB1B3 = 0.28\nB2B3 = 0.25", "A1B1 = 0.2\nB1B2 = 0.12\nB1B3 = 0.27\nB2B3 = 0.15"),
    ("A3B3 = 0.27", "A3B3 = 0.2"),
    (AS_SHOWN, "B1 = [0.03, 0.2]\nB2 = [0.15, 0.2]\nB3 = [0.3, 0.2]"),
]
REFUSED = {
    "three equal parallel leads": (PARALLEL, r"III\(2,3,4,5\) jams at the first position.* line of lead 5 is 0\. Fix:"),
    "between two assemblies": ([(AS_SHOWN, BETWEEN)], "can be assembled in"),
    "change points": ([("[mechanism.frame]", '[mechanism]\nthrough = "inertia"\n[mechanism.frame]')], "three-lead"),
    "a lead that slides twice": (
        [('2 = "A1B1"', '2 = "P"'), ("A1B1 = 0.25\n", ""),
         ("[mechanism.sketch]", '[[mechanism.slides]]\nlink = 2\nalong = "OA1"\n'
          '[[mechanism.slides]]\nlink = 2\nalong = "B1B2"\n[mechanism.sketch]')],
        "link 2 slides both",
    ),
}  # fmt: skip


def test_two_leads_may_make_a_parallelogram() -> None:
    """The plate only translates, B1 about 0.03 as A1B1 about A1: it is halfway to A1, and square to the way there."""
    study = LinkageStudy(parse_scene(changed(PLATE, *PARALLEL, ("start = 0", "start = 40"))))
    first, shifted = cmath.rect(0.03, radians(40)), 0.03
    half = (first - shifted) / 2
    reach = -1j * half / abs(half) * (0.2**2 - abs(half) ** 2) ** 0.5
    for road in (study.motion(0), solve(study.mechanism, study.turn.phi, 0)):
        assert road.points["B1"].r[0] == pytest.approx(shifted + half + reach, abs=1e-13)


@pytest.mark.parametrize(("size", "long"), [("0.95", False), ("0.96", True)])
def test_a_lead_is_never_met_that_is_longer_than_the_way_round(size: str, long: bool) -> None:
    """From A3 to A2 it is 0.5025 m, on by the second lead and the plate to B3 0.2 m and 0.25 m."""
    assert never(LinkageStudy(parse_scene(changed(PLATE, ("A3B3 = 0.27", f"A3B3 = {size}")))).mechanism) is long


@pytest.mark.parametrize(("above", "far"), [(0.04, False), (0.06, True), (-0.04, False)])
def test_a_guide_farther_off_than_crank_and_rod_reach_is_never_met(above: float, far: bool) -> None:
    slides = [f"link = 3; along = {{ through = [0, 0.25], angle = 0 }}; offset = {above}"]
    slider = scene(
        frame="O = [0, 0]", links="OA AB B", lengths="OA = 0.1; AB = 0.2", slides=slides, sketch="B = [0.05, 0.2]",
        drive="link = 1; speed = 1; start = 90",
    )  # fmt: skip
    assert never(LinkageStudy(parse_scene(slider)).mechanism) is far


@pytest.mark.parametrize("why", REFUSED)
def test_what_no_triad_can_be_is_refused_by_name(why: str) -> None:
    changes, said = REFUSED[why]
    with pytest.raises(DraftError, match=said):
        LinkageStudy(parse_scene(changed(PLATE, *changes))).motion(0)
