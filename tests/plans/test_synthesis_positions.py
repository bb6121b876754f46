"""Synthesis by positions: rods guided, functions met, dwells, and rocker-sliders; each by brute force too."""

from __future__ import annotations

import cmath
import math
from itertools import chain

import numpy as np
import pytest

from plans.analytic.synthesis import analysed
from plans.model.synthesis.positions import DwellTask, FunctionTask, RodTask
from plans.model.synthesis.swings import RockerSliderTask
from plans.scene.faults import SceneError
from plans.scene.scene import read_scene
from plans.study import Study
from plans.synthesis.dwell import following
from plans.synthesis.quantities import compare_synthesis
from plans.synthesis.study import SynthesisStudy
from plans.synthesis.written import written

KEYS = {RodTask: "rod_positions", FunctionTask: "function_points", DwellTask: "dwell"}
LEAN = math.radians(20)


def study_of(task) -> SynthesisStudy:
    return SynthesisStudy(KEYS.get(type(task), "rocker_slider"), task)


def designs(task):
    """Give every mechanism of a task, after seeing that both roads have the same ones."""
    comparison = compare_synthesis(study_of(task))
    assert [(one.name, one.excess.max()) for one in comparison.findings if one.excess.max() > 1] == []
    places = [[one.places for one in reading.found] for reading in comparison.analysis.readings]
    drawn = [[one.places for one in reading.found] for reading in comparison.construction.readings]
    for theirs, ours in zip(chain(*places), chain(*drawn), strict=True):
        size = max(map(abs, theirs.values()))
        assert theirs.keys() == ours.keys() and max(abs(theirs[k] - ours[k]) for k in theirs) < 1e-10 * size
    return [*chain(*(one.found for one in comparison.analysis.readings))]


def printed(value: float, text: str) -> bool:
    return f"{value:.{len(text.partition('.')[2])}f}" == text


SWINGS = [  # theme 6, tasks 8 and 9
    (RockerSliderTask(0.12, LEAN, 10.0), {"l_1": "0.1650639618", "l_2": "0.01650639618", "e": "0.1594184418"}),
    (
        RockerSliderTask(0.15, None, 0.5, tuple(map(math.radians, (8, 30)))),
        {"l_1": "0.8201076053", "l_2": "1.640215211"},
    ),
    (
        RockerSliderTask(0.15, None, 1.0, tuple(map(math.radians, (8, 30)))),
        {"l_1": "0.603657367", "l_2": "0.603657367"},
    ),
]


@pytest.mark.parametrize(("task", "lengths"), SWINGS)
@pytest.mark.parametrize("road", [analysed, lambda task: study_of(task).synthesis])
def test_textbook_rocker_sliders(road, task, lengths) -> None:
    made = road(task).chosen.sizes
    assert all(printed(made[name], text) for name, text in lengths.items())
    angles = {10.0: ("42.63003952", "20.0"), 0.5: ("22.0", "14.47751219"), 1.0: ("22.0", "30.0")}[task.ratio]
    assert [*map(printed, (math.degrees(made[name]) for name in ("ψ", "α_max")), angles)] == [True] * 2


def slid(made, rocker: float, sense: int) -> tuple[float, float]:
    """Give slider and signed pressure angle of a rocker-slider at an angle of its rocker, from the lengths alone."""
    height = made["l_1"] * math.sin(rocker) - made.get("e", 0.0)
    rod = math.sqrt(made["l_2"] ** 2 - height**2)
    return made["l_1"] * math.cos(rocker) + sense * rod, math.asin(height / made["l_2"])


def rocker_slider_tasks(count: int):
    for times in (0.98, 1.02):  # of the ratio where the slider turns back as the rocker does
        yield RockerSliderTask(0.1, LEAN, times * 2 * math.sin(LEAN) / (1 - math.sin(LEAN)))
    random = np.random.default_rng(11)
    for _ in range(count - 2):
        stroke, pressure = random.uniform(0.02, 2), math.radians(random.uniform(3, 50))
        if random.random() < 0.5:
            yield RockerSliderTask(stroke, pressure, 10 ** random.uniform(-1, 1.3))
        else:
            ends = tuple(map(math.radians, random.uniform(0, 179, 2)))
            known = {"ratio": 10 ** random.uniform(-1, 0.6)} if random.random() < 0.5 else {"pressure": pressure}
            yield RockerSliderTask(stroke, angles=ends, **known)


@pytest.mark.parametrize("task", [*rocker_slider_tasks(60)])
def test_a_rocker_slider_has_what_was_asked(task) -> None:
    """Stroke and pressure angle to 1e-12, the slider on one way all the time; where none is, none of many does so."""
    found = designs(task)
    for one in found:
        made, sense = one.sizes, 1 if (one.places["B_1"] - one.places["A_1"]).real > 0 else -1
        ends = [cmath.phase(one.places[f"A_{k}"] - one.places["C"]) for k in (1, 2)]
        way = [slid(made, float(angle), sense) for angle in np.linspace(*ends, 400)]
        assert math.isclose(abs(way[0][0] - way[-1][0]), task.stroke, rel_tol=1e-12 * (1 + made["l_1"] / task.stroke))
        moves = np.diff([x for x, _ in way])
        assert (moves > -1e-12 * made["l_1"]).all() or (moves < 1e-12 * made["l_1"]).all()
        least, most = min(lean for _, lean in way), max(lean for _, lean in way)
        assert max(most, -least) <= made["α_max"] + 1e-12 / math.cos(made["α_max"])
        if task.angles is None:
            assert math.isclose(least, -task.pressure, abs_tol=1e-12) and printed(
                made["l_1"] / made["l_2"], f"{task.ratio:.9f}"
            )
        else:
            assert sorted(ends) == pytest.approx(sorted(task.angles), abs=1e-13)
            known = task.pressure if task.ratio is None else math.asin(task.ratio * math.sin(task.steepest))
            assert math.isclose(made["α_max"], known, abs_tol=1e-12 / math.cos(known))
    assert len(found) == _tried_swings(task)


def test_ratio_and_pressure_angle_are_each_a_reading() -> None:
    asked = RockerSliderTask(0.15, LEAN, 0.5, tuple(map(math.radians, (8, 30))))
    alone = [designs(asked._replace(**{name: None})) for name in ("pressure", "ratio")]
    assert [one.sizes for one in designs(asked)] == [one.sizes for one in chain(*alone)]


def _tried_swings(task) -> int:
    """Count by trial the shapes whose slider goes one way: of rods leaning alike, or to either side of the rocker."""
    if task.angles is None:
        halves = np.linspace(0, math.pi, 20_001)[1:-1]
        lean = task.ratio * (1 - np.cos(halves)) / 2 - math.sin(task.pressure)  # of the rod, were it alike at the ends
        half = next(
            (float(one) for one, here, there in zip(halves, lean, lean[1:], strict=False) if here < 0 <= there), 9
        )
        return int(half + task.pressure < math.pi / 2)
    ratio = task.ratio or math.sin(task.pressure) / max(math.sin(one) for one in np.linspace(*task.angles, 10_001))
    return 2 if all(ratio * math.sin(one) < 1 for one in np.linspace(*task.angles, 1001)) else 0


def rod_tasks(count: int):
    random = np.random.default_rng(12)
    for _ in range(count):
        size = int(random.choice([2, 3]))
        spots = [complex(*random.uniform(-1, 1, 2)) for _ in range(size + 2)]
        kind, arms = str(random.choice(["hinges", "pivots"])), tuple(random.uniform(0.4, 2, 2)) if size == 2 else None
        yield RodTask(tuple(spots[2:]), tuple(random.uniform(-1, 1, size)), **{kind: tuple(spots[:2])}, arms=arms)


def function_tasks(count: int):
    random = np.random.default_rng(13)
    for _ in range(count):
        size = int(random.choice([2, 3]))
        turns = np.sort(random.uniform(0, 3, size)), np.sort(random.uniform(0, 1.5, size))
        rocker = random.uniform(0.3, 2) if size == 2 else None
        yield FunctionTask(*map(tuple, turns), random.uniform(0.2, 1), 1.0, rocker)


def third(near: complex, far: complex, radii: tuple[float, float], hand: float) -> complex:
    """Give where two notches meet, left or right of the way from one centre to the other."""
    way = far - near
    along = (abs(way) ** 2 + radii[0] ** 2 - radii[1] ** 2) / (2 * abs(way))
    return near + way / abs(way) * complex(along, math.copysign(math.sqrt(radii[0] ** 2 - along**2), hand))


def follows(pivots, hinges, ends, steps: int = 600) -> bool:
    """Lead a four-bar by trial: turn its first link by small steps, both ways, and see what positions it comes to."""
    lengths = abs(ends[0] - hinges[0]), abs(ends[0] - pivots[1])
    hand = ((pivots[1] - hinges[0]).conjugate() * (ends[0] - hinges[0])).imag
    for sense in (1, -1):
        ahead = [sense * cmath.phase((hinge - pivots[0]) / (hinges[0] - pivots[0])) % math.tau for hinge in hinges[1:]]
        turns = sorted({*np.linspace(0, ahead[-1], steps), *ahead})
        if ahead != sorted(ahead):
            continue
        try:
            at = {
                turn: third(pivots[0] + (hinges[0] - pivots[0]) * cmath.rect(1, sense * turn), pivots[1], lengths, hand)
                for turn in turns
            }
        except ValueError:  # it does not reach
            continue
        if all(abs(at[turn] - end) < 1e-6 for turn, end in zip(ahead, ends[1:], strict=True)):
            return True
    return False


def centre_by_lines(places, arm):
    """Give centres as solutions of linear equations, or by notches about two places."""
    if len(places) == 2:
        return [third(*places, (arm, arm), hand) for hand in (1, -1)] if abs(places[1] - places[0]) < 2 * arm else []
    rows = [2 * (one - places[0]) for one in places[1:]]
    right = [abs(one) ** 2 - abs(places[0]) ** 2 for one in places[1:]]
    return [complex(*np.linalg.solve([[row.real, row.imag] for row in rows], right))]


def moved(task, at: complex, k: int) -> complex:
    return task.places[k] + (at - task.places[0]) * cmath.rect(1, task.angles[k] - task.angles[0])


def back(task, at: complex, k: int) -> complex:
    return task.places[0] + (at - task.places[k]) * cmath.rect(1, task.angles[0] - task.angles[k])


def tried_rods(task) -> int:
    """Count the four-bars that lead by one link or the other."""
    sides, count = [], range(len(task.places))
    for at, arm in zip(task.hinges or task.pivots, task.arms or (None, None), strict=True):
        if task.hinges:
            places = [moved(task, at, k) for k in count]
            sides.append([(pivot, places) for pivot in centre_by_lines(places, arm)])
        else:
            firsts = centre_by_lines([back(task, at, k) for k in count], arm)
            sides.append([(at, [moved(task, first, k) for k in count]) for first in firsts])
    return sum(
        follows((o, c), hinges, ends) or follows((c, o), ends, hinges) for o, hinges in sides[0] for c, ends in sides[1]
    )


@pytest.mark.parametrize("task", [*rod_tasks(70)])
def test_a_rod_is_guided_through_its_positions(task) -> None:
    """The links keep their lengths, D is on the rod where it was asked; as many are found as lead by trial."""
    found = designs(task)
    for one in found:
        place, made = one.places, one.sizes
        size = max(map(abs, place.values()))
        for k in range(1, len(task.places) + 1):
            bars = [("O", f"A_{k}", "l_1"), (f"A_{k}", f"B_{k}", "l_2"), ("C", f"B_{k}", "l_3")]
            assert all(abs(abs(place[a] - place[b]) - made[name]) < 1e-12 * size for a, b, name in bars)
            way = (place[f"B_{k}"] - place[f"A_{k}"]) / (place["B_1"] - place["A_1"])
            assert abs(way - cmath.rect(1, task.angles[k - 1] - task.angles[0])) < 1e-12 * size / made["l_2"]
            spot = place[f"A_{k}"] + (place["D_1"] - place["A_1"]) * way
            assert abs(spot - task.places[k - 1]) < 1e-12 * size * (1 + 2 / made["l_2"])
        for i, j in task.poles:
            pole = place[f"P_{i + 1}{j + 1}"]
            assert abs(back(task, pole, i) - back(task, pole, j)) < 1e-10 * size
    assert len(found) == tried_rods(task)


@pytest.mark.parametrize("task", [*function_tasks(70)])
def test_a_function_is_met_at_its_points(task) -> None:
    """From the lengths alone the rocker's turns are those asked; as many are found as the crank leads by trial."""
    found = designs(task)
    for one in found:
        made, ends = one.sizes, [one.places[f"B_{k}"] for k in range(1, len(task.inputs) + 1)]
        hand = ((1 - one.places["A_1"]).conjugate() * (ends[0] - one.places["A_1"])).imag
        there = [
            third(cmath.rect(made["l_1"], angle), 1 + 0j, (made["l_2"], made["l_3"]), hand) for angle in task.inputs
        ]
        for end, output in zip(there, task.outputs, strict=True):
            turned = cmath.phase((end - 1) / (there[0] - 1)) - (output - task.outputs[0])
            off = abs(math.remainder(turned, math.tau))
            assert off < 1e-12 * max(made.values()) ** 2 / (made["l_3"] * math.sin(made["μ_min"]))
    pins = [cmath.rect(task.crank, angle) for angle in task.inputs]
    seen = [1 + (pin - 1) * cmath.rect(1, task.outputs[0] - out) for pin, out in zip(pins, task.outputs, strict=True)]
    tries = centre_by_lines(seen, None) if task.rocker is None else _on_circle(seen, task.rocker)
    turns = [cmath.rect(1, out - task.outputs[0]) for out in task.outputs]
    assert len(found) == sum(follows((0j, 1 + 0j), pins, [1 + (end - 1) * turn for turn in turns]) for end in tries)


def _on_circle(seen, rocker):
    """Find by trial the points of the rocker's circle that are as far from both pins."""
    places = [1 + rocker * np.exp(1j * np.linspace(0, math.tau, 20_001))]
    off = np.abs(places[0] - seen[0]) - np.abs(places[0] - seen[1])
    for k in np.nonzero((off[:-1] < 0) != (off[1:] < 0))[0]:
        share = off[k] / (off[k] - off[k + 1])
        end = places[0][k] * (1 - share) + places[0][k + 1] * share
        yield 1 + (end - 1) / abs(end - 1) * rocker


def dwell_tasks(count: int):
    random = np.random.default_rng(14)
    for _ in range(count):
        lengths = random.uniform(0.2, 0.5), *random.uniform(0.7, 1.3, 2), random.uniform(0.8, 1.3)
        begin, output = random.uniform(0, 5), random.uniform(0.4, 2.5)
        dwell = begin, begin + random.uniform(0.4, 1.6)
        yield DwellTask(
            lengths, random.uniform(0.3, 2), random.uniform(-2, 2), dwell, output, bool(random.random() < 0.3)
        )


@pytest.mark.parametrize("task", [*dwell_tasks(24)])
def test_a_rocker_rests(task) -> None:
    """Led round by notches in fine steps it goes no farther than is told, in its rest and over the turn."""
    found = designs(task)
    l1, l2, l3, l4 = task.lengths
    goes = l1 + min(l2, l3, l4) * 0 + max(l2, l3, l4) <= l2 + l3 + l4 - max(l2, l3, l4) and l1 < min(l2, l3, l4)
    angles = np.linspace(0, math.tau, 4001)[:-1]
    if goes:
        sides = [following(task, side) for side in (1, -1)]
        assert len(found) <= sum(low < task.output < high for low, high in sides)
    else:
        assert not found
    for one in found:
        place, made = one.places, one.sizes
        side = -1.0 if task.crossed else 1.0

        def point(angle: float) -> complex:
            pin = cmath.rect(l1, angle)
            end = third(pin, complex(l4), (l2, l3), side)  # noqa: B023
            return pin + (end - pin) / l2 * cmath.rect(task.arm, task.lean)

        hand = ((place["F"] - place["K_3"]).conjugate() * (place["D"] - place["K_3"])).imag

        def turned(angle: float) -> float:
            end = third(point(angle), place["F"], (made["l_5"], made["l_6"]), hand)  # noqa: B023
            return cmath.phase((end - place["F"]) / (place["D"] - place["F"]))  # noqa: B023

        over = [turned(float(angle)) for angle in angles]
        assert made["ψ"] - 1e-5 < max(over) - min(over) < made["ψ"] + 1e-12
        rest = [float(angle) for angle in np.linspace(*task.dwell, 2001)]
        off, missed = (
            [abs(turned(angle)) for angle in rest],
            [abs(abs(point(angle) - place["D"]) - made["l_5"]) for angle in rest],
        )
        assert (
            made["ψ_d"] - 1e-6 < max(off) < made["ψ_d"] + 1e-12 and made["h"] - 1e-6 < max(missed) < made["h"] + 1e-12
        )
        assert max(turned(task.stations[k]) for k in (0, 2, 4)) < 1e-11


WRITTEN = [
    SWINGS[0][0],
    SWINGS[1][0],
    RodTask((0j, 0.2 + 0.1j, 0.4 + 0.1j), (0.0, 0.3, 0.8), hinges=(0.1j, 0.3 + 0.05j)),
    RodTask((0j, 0.3 + 0.1j), (0.0, 0.6), pivots=(-0.2 - 0.2j, 0.4 - 0.3j), arms=(0.5, 0.4)),
    FunctionTask((0.5, 1.0, 1.6), (0.0, 0.3, 0.8), 0.1, 0.3),
    DwellTask((0.3, 1.0, 1.0, 1.1), 1.4, 0.4, (2.6, 3.6), 0.9),
]


@pytest.mark.parametrize("task", WRITTEN)
@pytest.mark.parametrize("road", ["construction", "analysis"])
def test_the_written_scene_does_what_was_asked(tmp_path, task, road) -> None:
    """The mechanism, studied by the roads that know nothing of the task, has its places to 1e-12."""
    study, path = study_of(task), tmp_path / "scene.toml"
    made = study.synthesis.chosen
    path.write_text(written(study.family.mechanism(made), "", "task.toml", {"language": "en"}), encoding="utf-8")
    points = Study(read_scene(path), ["positions"]).numbers("linkage", road).plain()["points"]
    size = max(map(abs, made.places.values()))
    for name, there in points.items():
        at = [complex(*spot) for spot in there["r"]]
        wanted = [made.places[f"{name}_{k}"] for k in (1, 2, 3) if name in "ABD" and f"{name}_{k}" in made.places]
        if isinstance(task, RodTask | FunctionTask):  # else between, or on the way round
            assert all(abs(one - other) < 1e-12 * size for one, other in zip(at, wanted, strict=bool(wanted)))
        elif wanted:
            last = -1 if isinstance(task, RockerSliderTask) else 0
            assert max(abs(at[0] - wanted[0]), abs(at[last] - wanted[min(1, -last)])) < 1e-12 * size
    if isinstance(task, DwellTask):
        turned = [
            cmath.phase((complex(*at) - made.places["F"]) / (made.places["D"] - made.places["F"]))
            for at in points["D"]["r"]
        ]
        assert max(map(abs, turned[:4])) < made.sizes["ψ_d"] < 0.02 < made.sizes["ψ"]
        assert 0.9 * made.sizes["ψ"] < max(turned) - min(turned) <= made.sizes["ψ"]


ROD = "places = [[0, 0], [0.2, 0.1], [0.4, 0.1]]\nangles = [0, 20, 50]\n"
FUNCTION = "inputs = [30, 60, 90]\noutputs = [0, 20, 45]\n"
BARS = "crank = 0.3\ncoupler = 1\nrocker = 1\nframe = 1.1\narm = 1.4\nlean = 23\ndwell = [149, 206]\n"
# A demand, the key that is told of, and what can be met.
REFUSED = [
    ("rocker_slider", "stroke = 0.12\npressure = 20\nratio = 1", "ratio", "1.03961"),  # 2 sin 20 / (1 - sin 20)
    ("rocker_slider", "stroke = 0.15\nangles = [8, 30]", "rocker_slider", "under 2 has"),  # 1 / sin 30
    ("rocker_slider", "stroke = 0.15\nangles = [8, 120]\nratio = 1", "ratio", "under 1:"),
    ("rocker_slider", "stroke = 0.15\nangles = [30, 30]\nratio = 1", "angles", "two different"),
    ("rocker_slider", "stroke = 0.15\nratio = 1", "rocker_slider", "pressure angle and a ratio"),
    ("rod_positions", f"{ROD}hinges = [[0, 0], [0.3, 0]]\narms = [1, 1]", "arms", "leave out"),
    (
        "rod_positions",
        "places = [[0, 0], [0, 1]]\nangles = [0, 90]\nhinges = [[1, 0], [3, 0]]\narms = [9, 0.1]",
        1,
        "2500 mm",
    ),
    (
        "rod_positions",
        "places = [[0, 0], [0, 1]]\nangles = [0, 90]\nhinges = [[-0.5, 0.5], [3, 0]]\narms = [9, 9]",
        0,
        "pole",
    ),
    (
        "rod_positions",
        "places = [[0, 0], [1, 1], [2, 2]]\nangles = [0, 0, 0]\nhinges = [[1, 0], [3, 1]]",
        0,
        "parallel",
    ),
    (
        "rod_positions",
        "places = [[0, 0], [1, 0], [2, 0]]\nangles = [0, 10, 30]\nhinges = [[0, 0], [3, 1]]",
        0,
        "circle about",
    ),
    ("rod_positions", f"{ROD}hinges = [[-0.2, 0.3], [0.3, 0.4]]", "hinges", "met by: B ("),
    ("function_points", f"{FUNCTION}crank = 0.1\nframe = 0.3\nrocker = 0.2", "rocker", "leave out"),
    (
        "function_points",
        "inputs = [30, 60]\noutputs = [0, 5]\ncrank = 0.2\nframe = 0.3\nrocker = 0.01",
        "rocker",
        "at least",
    ),
    ("function_points", "inputs = [30, 60, 90]\noutputs = [0, 20, 80]\ncrank = 0.2\nframe = 0.3", "crank", "met by: "),
    ("dwell", f"{BARS.replace('1.1', '2.1')}output = 0.9", "crank", "—"),
    ("dwell", f"{BARS.replace('0.3', '0.95')}output = 0.9", "crank", "less than 900 mm"),  # l2 + l3 - l4
    ("dwell", f"{BARS}output = 0.01", "output", " … "),
]


@pytest.mark.parametrize(("family", "told", "key", "number"), REFUSED)
def test_what_cannot_be_met_is_refused_with_what_can(tmp_path, family, told, key, number) -> None:
    path = tmp_path / "task.toml"
    path.write_text(f"[synthesis.{family}]\n{told}\n", encoding="utf-8")
    faults = _faults(path)
    assert [fault.path[-1] for fault in faults][:1] == [key] and number in str(faults[0]), faults[0]


def _faults(path):
    try:
        return read_scene(path).meaning.faults
    except SceneError as error:
        return error.faults
