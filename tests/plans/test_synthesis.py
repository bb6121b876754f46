"""Synthesis by construction: the textbook's values, and random tasks whose mechanisms do what was asked."""

from __future__ import annotations

import math
from itertools import product

import numpy as np
import pytest

from plans.analytic.synthesis import analysed, slider
from plans.analytic.synthesis.rocker import admissible, at_place, best, end_of_arc, start_of_arc
from plans.analytic.synthesis.slider import sliders as closed
from plans.model.synthesis.extremes import RockerTask, SliderTask
from plans.scene.scene import read_scene
from plans.study import Study
from plans.synthesis.quantities import compare_synthesis
from plans.synthesis.rocker import with_best
from plans.synthesis.slider import with_best as with_best_slider
from plans.synthesis.study import SynthesisStudy
from plans.synthesis.written import written

TASK = RockerTask(0.30, math.radians(40), math.radians(15), place=math.radians(200), side=1)
STROKE = SliderTask(0.12, 0.03, math.radians(6.5), 5.0)  # theme 6, task 7


class SliderLengths(slider.SliderLengths):
    """A slider-crank with what it does, from its lengths alone (M1.6)."""

    @property
    def overlap(self) -> float:
        near, far = self.rod - self.crank, self.rod + self.crank
        return math.asin(self.offset / near) - math.asin(self.offset / far)

    @property
    def pressure(self) -> float:
        return self.pressures[1]

    @property
    def stroke(self) -> float:
        near, far = self.rod - self.crank, self.rod + self.crank
        return math.sqrt(far**2 - self.offset**2) - math.sqrt(near**2 - self.offset**2)


def study(task) -> SynthesisStudy:
    return SynthesisStudy("crank_rocker" if isinstance(task, RockerTask) else "slider_crank", task)


def draw(task):
    return study(task).synthesis


def sliders(task) -> list[SliderLengths]:
    """Give what the construction found by the closed forms' value, which tells angles and stroke of its own."""
    return [SliderLengths(*(one.sizes[name] for name in ("l_1", "l_2", "e"))) for one in draw(task).readings[0].found]


ROADS = pytest.mark.parametrize("road", [draw, analysed])


def printed(value: float, text: str) -> bool:
    """Tell whether a value, rounded to the digits of a text, is that text."""
    return f"{value:.{len(text.partition('.')[2])}f}" == text


@ROADS
def test_textbook_crank_rocker(road) -> None:
    """Methods M1.5, all printed digits."""
    (one,) = road(TASK).readings[0].found
    pivot, (l1, l2, l3, l4, *_) = one.places["O"], one.sizes.values()
    assert printed(pivot.real, "-0.3725310918") and printed(pivot.imag, "-0.2366134082")
    found = l1, l2, l4, math.degrees(one.sizes["μ_min"]), l1 + l2 - l3 - l4
    texts = "0.0593602436", "0.6439316772", "0.4413222397", "21.79034348", "-0.0380303189"
    assert [*map(printed, found, texts)] == [True] * 5


def test_textbook_circle() -> None:
    """Methods M1.5: centre and radius."""
    board = study(TASK).drawn[0].board
    assert printed(board["M"].point.imag, "-0.1010231794") and printed(board["M:o"].value.radius, "0.3964393075")


SLIDERS = [  # theme 6, tasks 4, 5, 7, and M1.6 fed back: crank, rod, offset, signed pressure angles
    (STROKE.only("overlap", "ratio"), ("0.0578116854", "0.289058427", "0.07566935175"), ("3.541916713", "27.50194624")),
    (STROKE.only("offset", "overlap"), ("0.05914210508", "0.1878802967", "0.03"), ("-8.923173554", "28.32434183")),
    (STROKE.only("offset", "ratio"), ("0.05968319715", "0.2984159857", "0.03"), ("-5.708605054", "17.48948743")),
    (SliderTask(0.12, ratio=3.0), ("0.06", "0.18", "0.00"), ("-19.47122063", "19.47122063")),
    (SliderTask(0.12, ratio=4.0), ("0.06", "0.24", "0.00"), ("-14.47751219", "14.47751219")),
    (SliderTask(0.12, ratio=5.0), ("0.06", "0.30", "0.00"), ("-11.53695903", "11.53695903")),
    (SliderTask(0.12, pressure=math.asin(0.25)), ("0.06", "0.24", "0.00"), ("-14.47751219", "14.47751219")),
    (
        SliderTask(0.1206655633, 0.02, math.radians(3.801484916)),
        ("0.060000", "0.200000", "0.02"),
        ("-11.53696", "23.57818"),
    ),
]


@ROADS
@pytest.mark.parametrize(("task", "lengths", "angles"), SLIDERS)
def test_textbook_slider_cranks(road, task, lengths, angles) -> None:
    (one,) = road(task).readings[0].found
    assert [*map(printed, (one.sizes[name] for name in ("l_1", "l_2", "e")), lengths)] == [True] * 3
    assert [*map(printed, (math.degrees(one.sizes[name]) for name in ("α_min", "α_max")), angles)] == [True] * 2


@ROADS
def test_an_overdetermined_task_has_three_readings(road) -> None:
    """Theme 6, task 7: its third reading leaves the overlap out, and has another."""
    readings = road(STROKE).readings
    kept = [("overlap", "ratio"), ("offset", "overlap"), ("offset", "ratio")]
    assert [one.kept for one in readings] == kept and [len(one.found) for one in readings] == [1, 1, 1]
    assert printed(math.degrees(readings[2].found[0].sizes["θ"]), "2.41344924")


def turned(l1, l2, l3, l4) -> tuple[float, float]:
    """Give swing and overlap by the cosine rule alone, from the lengths (M1.2)."""
    reach = l2 + l1, l2 - l1
    at_o = [math.acos((r**2 + l4**2 - l3**2) / (2 * r * l4)) for r in reach]
    at_c = [math.acos((l3**2 + l4**2 - r**2) / (2 * l3 * l4)) for r in reach]
    return abs(at_c[0] - at_c[1]), abs(at_o[0] - at_o[1])


def agree(task) -> None:
    comparison = compare_synthesis(study(task))
    assert [(one.name, one.excess.max()) for one in comparison.findings if one.excess.max() > 1] == []
    assert [len(one.found) for one in comparison.construction.readings] == [
        len(one.found) for one in comparison.analysis.readings
    ]


def rocker_tasks(count: int):
    random = np.random.default_rng(5)
    for _ in range(count):
        swing, overlap = math.radians(random.uniform(10, 120)), math.radians(random.uniform(1, 60))
        task = RockerTask(random.uniform(0.05, 2), swing, overlap, side=int(random.choice([1, -1])))
        end = end_of_arc(task, task.side)
        if end is not None:
            start = start_of_arc(task, task.side)
            yield task._replace(place=start + random.uniform(0.02, 0.98) * (end - start))


@pytest.mark.parametrize("task", [*rocker_tasks(70)])
def test_a_crank_rocker_has_what_was_asked(task) -> None:
    """Swing and overlap to 1e-12, a crank that turns, and by its frame the same mechanism again."""
    (one,) = draw(task).readings[0].found
    l1, *_, l4 = lengths = [one.sizes[f"l_{k}"] for k in range(1, 5)]
    swing, overlap = turned(*lengths)
    slack = 1e-12 / math.sin(one.sizes["μ_min"])
    assert math.isclose(swing, task.swing, rel_tol=0, abs_tol=slack)
    assert math.isclose(overlap, task.overlap, rel_tol=0, abs_tol=slack)
    assert min(lengths) == l1 and l1 + max(lengths) < sum(lengths) / 2
    agree(task)
    again = draw(task._replace(place=None, frame=l4)).readings[0].found
    assert min(abs(other.sizes["l_1"] / l1 - 1) for other in again) < 1e-9


@pytest.mark.parametrize(("side", "degrees"), [*product((1, -1), np.arange(0.5, 360, 9))])
def test_an_arc_ends_where_no_mechanism_is(side, degrees) -> None:
    """The arc between B2 and its end, and its mirror image, admit O, and nothing else does."""
    task = RockerTask(0.3, math.radians(40), math.radians(15), place=math.radians(degrees), side=side)
    ends = sorted((start_of_arc(task, side), end_of_arc(task, side)))
    left = math.radians(degrees if 90 <= degrees <= 270 else (180 - degrees) % 360)
    assert bool(draw(task).readings[0].found) == bool(analysed(task).readings[0].found) == (ends[0] < left < ends[1])


def slider_tasks(count: int):
    random = np.random.default_rng(7)
    for _ in range(count):
        stroke, theta, ratio = random.uniform(0.02, 2), math.radians(random.uniform(0.5, 30)), random.uniform(1.5, 8)
        offset = stroke * random.uniform(0.01, 1)
        pair = [("offset", "overlap"), ("offset", "ratio"), ("overlap", "ratio"), ("ratio", "pressure")]
        pair += [("offset", "pressure"), ("overlap", "pressure")]
        every = SliderTask(stroke, offset, theta, ratio, math.asin(min(random.uniform(1, 1.8) / ratio, 0.9)))
        yield every.only(*pair[random.integers(6)])


@pytest.mark.parametrize("task", [*slider_tasks(100)])
def test_a_slider_crank_has_what_was_asked(task) -> None:
    """Each demand to 1e-12, and where there is no mechanism, none of many tried ones meets the demands."""
    found = sliders(task)
    for one in found:
        has = {"offset": one.offset, "overlap": one.overlap, "ratio": one.ratio, "pressure": one.pressures[1]}
        near = one.rod - one.crank - one.offset  # how far a dead place is: angles there are badly told
        assert math.isclose(one.stroke, task.stroke, rel_tol=1e-12 * one.rod / near)
        for name in task.demands:
            assert math.isclose(has[name], getattr(task, name), rel_tol=1e-12 * one.rod / near), name
    agree(task)
    assert len(found) == len(tried(task))


def tried(task: SliderTask) -> list[SliderLengths]:
    """Find the mechanisms of a task by brute force: with the first demand met, where the other changes its sign."""
    named, other = task.demands
    if task.demands == ("overlap", "pressure"):  # of all offsets with this overlap
        offsets = task.stroke / math.tan(task.overlap) * np.linspace(0, 1, 4001)[1:-1]
        made = [next(closed(task.only("overlap")._replace(offset=float(offset)))) for offset in offsets]
        return _changes(made, [one.pressures[1] - task.pressure for one in made])
    far = np.geomspace(1e-7, 1e4, 200_001) * task.stroke  # beyond the foot of O, along the guide
    if named == "ratio":  # by the ratio the offset is free: that of the shape is sought
        offsets = np.linspace(0, 1, 400_001)[1:-1] * (task.ratio - 1)
        shapes = [SliderLengths(1.0, task.ratio, offset) for offset in offsets[:: len(offsets) // 4000]]
        return _changes(shapes, [one.pressures[1] - task.pressure for one in shapes])
    if named == "offset":
        shapes = [_at(task.stroke, task.offset, x) for x in far[::100]]
        return _changes(shapes, [getattr(one, other) - getattr(task, other) for one in shapes])
    shapes = [SliderLengths(1.0, task.ratio, e * (task.ratio - 1)) for e in np.linspace(0, 1, 4001)[:-1]]
    return _changes(shapes, [one.overlap - task.overlap for one in shapes])


def _at(stroke: float, offset: float, x: float) -> SliderLengths:
    near, far = math.hypot(x, offset), math.hypot(x + stroke, offset)
    return SliderLengths((far - near) / 2, (far + near) / 2, offset)


def _changes(shapes, off) -> list[SliderLengths]:
    return [one for one, here, there in zip(shapes, off, off[1:], strict=False) if (here < 0) != (there < 0)]


@pytest.mark.parametrize(("swing", "overlap"), [*product((20, 40, 70), (3, 10, 16, 25))])
def test_the_best_place_is_best(swing, overlap) -> None:
    """No place of a fine division of both arcs has a larger least transmission angle, and the roads agree."""
    task = RockerTask(0.3, math.radians(swing), math.radians(overlap))
    chosen = draw(with_best(task)).chosen.sizes["μ_min"]
    assert abs(chosen - max(best(task, side)[1] for side in (1, -1))) < 1e-7
    tries = product((1, -1), np.linspace(math.pi / 2, 3 * math.pi / 2, 3001))
    made = [at_place(task, side, float(place)) for side, place in tries]
    assert max(each.transmission for each in made if each) <= chosen + 1e-7
    assert all(admissible(task, each.pivot) for each in made if each)


@pytest.mark.parametrize("degrees", [0.5, 3, 8.2, 20, 44])
def test_the_best_slider_crank_of_an_overlap_is_best(degrees) -> None:
    """None of many offsets with stroke and overlap as asked has a larger least transmission angle."""
    task = SliderTask(0.12, overlap=math.radians(degrees))
    one = study(with_best_slider(task))
    agree(one.task)
    chosen = math.pi / 2 - one.synthesis.chosen.sizes["α_max"]
    assert math.isclose(one.synthesis.chosen.sizes["θ"], task.overlap, rel_tol=1e-11)
    # e/H from nothing to where B2 is over O: there the overlap is atan(H/e).
    offsets = np.linspace(0, task.stroke / math.tan(task.overlap), 20_001)[1:-1]
    tries = [[*closed(task._replace(offset=float(offset)))] for offset in offsets]
    assert max(math.pi / 2 - each.pressures[1] for (each,) in tries) == pytest.approx(chosen, abs=1e-6)


WRITTEN = [
    TASK,
    TASK._replace(place=None, frame=0.4, side=1),
    TASK._replace(place=math.radians(160), side=-1),
    RockerTask(0.5, math.radians(60), 0.0, frame=0.9),
    *(task for task, *_ in SLIDERS),
]


@pytest.mark.parametrize("task", WRITTEN)
def test_the_written_scene_does_what_was_asked(tmp_path, task) -> None:
    """The mechanism, studied by the roads that know nothing of the task, has its stroke and overlap to 1e-12."""
    path, one = tmp_path / "scene.toml", draw(task).chosen
    made = study(task).family.mechanism(one)
    path.write_text(written(made, "", "task.toml", {"language": "en"}), encoding="utf-8")
    for road in ("construction", "analysis"):
        guided = Study(read_scene(path), ["positions"]).numbers("linkage", road).plain()["points"]["B"]["r"]
        if "e" in one.sizes:  # its guide is left of the way from O on, or the other stroke is the working one
            assert np.allclose([spot[1] for spot in guided], one.sizes["e"], rtol=1e-12, atol=1e-15)
        found = Study(read_scene(path), ["extremes"]).numbers("linkage", road).plain()["extremes"]
        wanted = task.swing if isinstance(task, RockerTask) else task.stroke
        assert math.isclose(found["stroke"], wanted, rel_tol=1e-12)
        assert math.isclose(found["overlap"], one.sizes["θ"], rel_tol=0, abs_tol=1e-12)


# A demand, what is changed in it, the key that is told, and the number that can be met.
REFUSED = [
    (("slider_crank", "stroke = 0.12\noffset = 0.03\noverlap = 80"), "overlap", "75.9638"),  # atan(H/e)
    (("slider_crank", "stroke = 0.12\noffset = 0.08\nratio = 2"), "offset", "45 mm"),  # H (k^2 - 1)/(4k)
    (("slider_crank", "stroke = 0.12\noverlap = 70\nratio = 4"), "overlap", "53.1301"),  # acos((k - 1)/(k + 1))
    (("slider_crank", "stroke = 0.12\npressure = 10\nratio = 4"), "pressure", "14.4775"),  # asin(1/k)
    (("slider_crank", "stroke = 0.12\noffset = 0.08"), "slider_crank", "two of"),
    (("slider_crank", "stroke = 0.12\noffset = 0\noverlap = 3"), "offset", "agree"),
    (("slider_crank", "stroke = 0.12\ntime_ratio = 1.2\npressure = 40"), "pressure", "42.79"),  # of the best
    (("crank_rocker", "rocker = 0.3\nswing = 40\noverlap = 15\nplace = 90"), "place", "105"),  # 90 + theta
    (("crank_rocker", "rocker = 0.3\nswing = 40\noverlap = 15\nframe = 4"), "frame", "300"),  # l4 = l3 at B2
    (("crank_rocker", "rocker = 0.3\nswing = 100\noverlap = 50\nbeyond = true"), "beyond", "100"),  # psi/2 + theta
    (("crank_rocker", "rocker = 0.3\nswing = 40\ntime_ratio = 1"), "crank_rocker", "300 mm"),
]


@pytest.mark.parametrize(("told", "key", "number"), REFUSED)
def test_what_cannot_be_met_is_refused_with_what_can(tmp_path, told, key, number) -> None:
    path = tmp_path / "task.toml"
    path.write_text("[synthesis.{}]\n{}\n".format(*told), encoding="utf-8")
    (fault,) = read_scene(path).meaning.faults
    assert fault.path[-1] == key and number in str(fault)
