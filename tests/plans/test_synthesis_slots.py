"""Synthesis of slotted links, sine and tangent mechanisms: the textbook's values, and random tasks (кулисы)."""

from __future__ import annotations

import math
import re
import tomllib

import numpy as np
import pytest

from plans.analytic.synthesis import analysed
from plans.model.synthesis.extremes import DoubleCrankTask, RockerTask
from plans.model.synthesis.pace import Pace
from plans.model.synthesis.slots import LeverTask, SineTask, TangentTask, WhitworthTask
from plans.scene.scene import read_scene
from plans.study import Study
from plans.synthesis import double_crank
from plans.synthesis.families import FAMILIES
from plans.synthesis.sine import drawn_sines, drawn_tangents
from plans.synthesis.slotted import drawn_levers, drawn_whitworths
from plans.synthesis.study import SynthesisStudy
from plans.synthesis.written import written

DRAWN = {
    LeverTask: drawn_levers,
    WhitworthTask: drawn_whitworths,
    SineTask: drawn_sines,
    TangentTask: drawn_tangents,
    DoubleCrankTask: double_crank.drawn,
}


def draw(task):
    return [[one.design for one in reading.found] for reading in DRAWN[type(task)](task)]


def solve(task):
    return [[*reading.found] for reading in analysed(task).readings]


ROADS = pytest.mark.parametrize("road", [draw, solve])


def printed(value: float, text: str) -> bool:
    """Tell whether a value, rounded to the digits of a text, is that text."""
    return f"{value:.{len(text.partition('.')[2])}f}" == text


deg = math.radians
VALUES = [  # of which task, which size, its printed digits, told in degrees
    (LeverTask(crank=0.12, frame=0.35), "ψ", "40.10208513"),  # methods M1.7
    (LeverTask(crank=0.12, frame=0.35), "K", "1.573304973"),
    (LeverTask(deg(40.10208513), frame=0.35), "l_1", "0.120000000"),
    (LeverTask(deg(40.10208513), crank=0.12), "l_0", "0.35000000"),
    (WhitworthTask(crank=0.075, frame=0.05), "K", "2.735"),  # R. S. Khurmi, J. K. Gupta, example 5.4
    (SineTask(0.12), "l_1", "0.06"),  # theme 6, task 6
    (TangentTask(0.15, deg(28)), "h", "0.1410544849"),  # theme 6, task 10
    (TangentTask(0.15, deg(28), one_sided=True), "h", "0.2821089698"),
]


@ROADS
@pytest.mark.parametrize(("task", "size", "text"), VALUES)
def test_textbook_sizes(road, task, size, text) -> None:
    ((one,),) = road(task)
    value = one.sizes[size]
    assert printed(math.degrees(value) if size in "θψ" else value, text)


@ROADS
def test_textbook_places(road) -> None:
    """Methods M1.7, where O is the origin."""
    ((one,),) = road(LeverTask(crank=0.12, frame=0.35))
    right = one.places["A_1"] - one.places["O"]
    assert printed(right.real, "0.1127265067") and printed(right.imag, "-0.04114285714")


READINGS = [
    (LeverTask(0.7, 0.12, 0.35), 3),
    (LeverTask(0.7, 0.12, stroke=0.4, lever=0.6), 3),  # the angle beside stroke and lever leaves the crank unknown
    (LeverTask(None, 0.12, 0.35, 0.4, 0.6), 4),
    (LeverTask(0.7, 0.12, 0.35, 0.4, 0.6), 8),  # of ten triples two are such
    (WhitworthTask(0.7, 0.12, 0.05), 3),
    (TangentTask(0.15, 0.5, 0.2), 3),
]


@pytest.mark.parametrize(("task", "count"), READINGS)
def test_an_overdetermined_task_is_read_in_each_way(task, count) -> None:
    assert len(draw(task)) == len(solve(task)) == count


def has(one, task) -> dict[str, float]:
    """Give what a mechanism has of what was asked, by relations of its lengths alone."""
    size = one.sizes
    if isinstance(task, TangentTask):
        lean = math.atan(size["H"] * (1.0 if task.one_sided else 0.5) / size["h"])
        return {"stroke": size["H"], "distance": size["h"], "pressure": lean}
    if isinstance(task, SineTask):
        return {"stroke": 2 * size["l_1"]}
    crank, frame, lever = size["l_1"], size["l_0"], size.get("l_3", math.nan)
    found = {"crank": crank, "frame": frame, "lever": lever}
    if isinstance(task, LeverTask):
        sine = crank / frame
        found |= {"overlap": 2 * math.asin(sine), "stroke": 2 * sine * lever}
        rise = lever * (1 - math.sqrt(1 - sine**2)) / 2
    else:  # of the crank's turn the return takes the angle between the pins on the guide
        found |= {"overlap": math.pi - 2 * math.acos(frame / crank), "stroke": 2 * lever}
        rise = lever
    return found | ({"pressure": math.asin(rise / size["l_4"])} if "l_4" in size else {})


def tasks(count: int):
    random = np.random.default_rng(11)
    for k in range(count):
        a, b, c, d = random.uniform(0.05, 1, 4)
        theta, alpha = deg(random.uniform(2, 85)), deg(random.uniform(2, 60))
        pace = Pace(*[(a, None), (None, b), (None, None)][k % 3])
        lever = LeverTask(theta, a, b, c, d)
        names = [("overlap", "crank"), ("overlap", "frame"), ("crank", "frame")]
        ends = [("crank", "stroke", "lever"), ("frame", "stroke", "lever"), ("overlap", "crank", "stroke")]
        kept = [*names, *ends, ("overlap", "frame", "lever"), ("crank", "frame", "stroke")][random.integers(8)]
        one = LeverTask(**{name: getattr(lever, name) for name in kept})
        yield one._replace(pressure=alpha, pace=pace) if one.driven else one
        kept = names[random.integers(3)]
        yield WhitworthTask(**{name: getattr(lever, name) for name in kept}, stroke=c, pressure=alpha, pace=pace)
        yield SineTask(a, pace)
        three = {"stroke": a, "pressure": alpha, "distance": b}
        three.pop([*three][random.integers(3)])
        yield TangentTask(**three, one_sided=k % 2 > 0)


@pytest.mark.parametrize("task", [*tasks(50)])
def test_a_mechanism_has_what_was_asked(task) -> None:
    """Each demand to 1e-12, by both roads alike; where there is no mechanism, none of many tried ones is one."""
    (drawn,), (solved,) = draw(task), solve(task)
    assert len(drawn) == len(solved) == tried(task)
    for one, other in zip(drawn, solved, strict=True):
        flat = 1 / math.cos(other.sizes.get("θ", 0.0) / 2) ** 2  # near a stretched figure angles are badly told
        assert [*one.sizes] == [*other.sizes] and one.places.keys() == other.places.keys()
        assert all(math.isclose(one.sizes[name], size, rel_tol=1e-12 * flat) for name, size in other.sizes.items())
        size = max(map(abs, other.places.values()))
        assert all(abs(one.places[name] - place) < 1e-12 * flat * size for name, place in other.places.items())
        for name, value in has(one, task).items():
            asked = getattr(task, name, None)
            assert asked is None or math.isclose(value, asked, rel_tol=1e-12 * flat), name
        if isinstance(task, TangentTask):
            continue
        angle = math.pi + one.sizes.get("θ", 0.0)
        if task.pace.speed is not None and "H" in one.sizes:
            assert math.isclose(one.sizes["H"] / (angle / one.sizes["ω_1"]), task.pace.speed, rel_tol=1e-12)
        if task.pace.output is not None and "H" in one.sizes:
            assert math.isclose(one.sizes["ω_1"], math.tau * task.pace.output, rel_tol=1e-12)


def tried(task) -> int:
    """Count mechanisms by brute force: turn the crank, or swing the lever, and look whether it does what it must."""
    if isinstance(task, (SineTask, TangentTask)):
        return 1
    turn = np.exp(1j * np.linspace(0, math.tau, 20001))
    half = None if task.overlap is None else task.overlap / 2
    if half is None and task.crank is not None and task.frame is not None:
        round_about = round(np.unwrap(np.angle(task.crank * turn + 1j * task.frame))[[0, -1]] @ [-1, 1] / math.tau)
        if round_about != (1 if isinstance(task, WhitworthTask) else 0):
            return 0
        half = (np.ptp(np.angle(task.crank * turn + 1j * task.frame))) / 2
    if isinstance(task, WhitworthTask):
        return 1
    if half is None:  # the end of the lever must come as far as half of the stroke
        reach = task.lever * np.sin(np.linspace(0, math.pi / 2, 200001))
        if reach[-1] <= task.stroke / 2:
            return 0
        half = float(np.interp(task.stroke / 2, reach, np.linspace(0, math.pi / 2, 200001)))
    if not task.driven:
        return 1
    swing = np.linspace(-half, half, 20001)  # of a lever of length 1: its ram must go one way all along
    below = (1 + math.cos(half)) / 2 - np.cos(swing)
    rod = (1 - math.cos(half)) / 2 / math.sin(task.pressure)
    ram = np.sin(swing) + np.sqrt(np.maximum(rod**2 - below**2, 0.0))
    return int((np.diff(ram) > 0).all())


DOUBLE = DoubleCrankTask(RockerTask(0.30, deg(40), deg(15), place=deg(200), side=1))  # methods M1.5, inverted
PART = 0.0593602436 / 0.6439316772  # l1/l2 of it: the speeds are as 1 ± l1/l2 with O, A and B in line


@ROADS
def test_a_double_crank_keeps_the_indices_of_its_crank_rocker(road) -> None:
    """Methods M1.4: the links of M1.5, each now another; both speeds are as l2 ± l1 to l2 with O, A, B in line."""
    ((one,),) = road(DOUBLE)
    texts = {"l_1": "0.4413222397", "l_3": "0.6439316772", "l_4": "0.0593602436"}
    assert all(printed(one.sizes[name], text) for name, text in texts.items())
    assert printed(math.degrees(one.sizes["μ_min"]), "21.79034348")
    assert printed(one.sizes["i_1"], f"{1 + PART:.8f}")


def double_cranks(count: int):
    random = np.random.default_rng(3)
    while count:
        swing, overlap = deg(random.uniform(10, 100)), deg(random.uniform(1, 50))
        rocker = RockerTask(random.uniform(0.1, 1), swing, overlap, place=deg(random.uniform(90, 270)))
        task = DoubleCrankTask(rocker)
        if any(one.found for one in analysed(task).readings):
            count -= 1
            yield task


@pytest.mark.parametrize("task", [*double_cranks(30)])
def test_a_double_crank_turns_by_what_was_asked(task) -> None:
    """By its lengths alone: where O, A and B are in line, by the cosine rule, the driver has turned by π + θ."""
    for drawn, solved in zip(draw(task), solve(task), strict=True):
        for one, other in zip(drawn, solved, strict=True):
            l1, l2, l3, l4 = (one.sizes[f"l_{k}"] for k in range(1, 5))
            assert min(l1, l2, l3, l4) == l4 and l4 + max(l1, l2, l3) < l1 + l2 + l3 - max(l1, l2, l3)  # Grashof
            reach = l3 + l4, l3 - l4  # OB
            at_o = [math.acos((r**2 + l1**2 - l2**2) / (2 * r * l1)) for r in reach]
            at_c = [math.acos((l1**2 + l2**2 - r**2) / (2 * l1 * l2)) for r in reach]
            flat = 1e-12 / math.sin(one.sizes["μ_min"]) / min(*map(math.sin, at_o), 0.1)
            asked = task.inverted
            assert math.isclose(abs(at_o[0] - at_o[1]), asked.overlap, rel_tol=0, abs_tol=flat)
            assert math.isclose(abs(at_c[0] - at_c[1]), asked.swing, rel_tol=0, abs_tol=flat)
            assert all(math.isclose(one.sizes[name], size, abs_tol=flat) for name, size in other.sizes.items())
            assert all(abs(one.places[name] - place) < flat for name, place in other.places.items())


# A task as told, the numbers of the study of its scene and what they must be.
WRITTEN = [
    ("slotted_lever", "crank = 0.12\nframe = 0.35", {"stroke": 0.6999134224861251, "ratio": 1.573304972717285}),
    ("slotted_lever", "time_ratio = 1.5\nframe = 0.35\nstroke = 0.48\npressure = 8", {"stroke": 0.48, "ratio": 1.5}),
    ("slotted_lever", "swing = 36\ncrank = 0.1\nlever = 0.8", {"stroke": deg(36), "overlap": deg(36)}),
    ("whitworth", "time_ratio = 2.2\ncrank = 0.075\nstroke = 0.3\npressure = 20", {"stroke": 0.3, "ratio": 2.2}),
    ("sine", "stroke = 0.12", {"stroke": 0.12, "ratio": 1.0}),
    ("slider_crank", "stroke = 0.12\noffset = 0.03\nmean_speed = 0.5\noutput = 130", {"stroke": 0.12}),
]


@pytest.mark.parametrize(("family", "told", "wanted"), WRITTEN)
def test_the_written_scene_does_what_was_asked(tmp_path, family, told, wanted) -> None:
    """Its study by the roads that know nothing of the task, to 1e-12."""
    path = scene_of(tmp_path, family, told)
    for road in ("construction", "analysis"):
        found = Study(read_scene(path), ["extremes"]).numbers("linkage", road).plain()["extremes"]
        assert all(math.isclose(found[name], value, rel_tol=1e-12, abs_tol=1e-12) for name, value in wanted.items())


def scene_of(folder, family: str, told: str):
    """Write the scene of the mechanism of a task."""
    task, made = folder / "task.toml", folder / "made.toml"
    task.write_text(f"[synthesis.{family}]\n{told}\n", encoding="utf-8")
    study = Study(read_scene(task), ["synthesis"])
    assert study.comparison("synthesis").agrees
    text = FAMILIES[family].mechanism(study.of(SynthesisStudy).synthesis.chosen)
    made.write_text(written(text, "", "task.toml", {"language": "en"}), encoding="utf-8")
    return made


@pytest.mark.parametrize("road", ["construction", "analysis"])
@pytest.mark.parametrize("one_sided", [False, True])
def test_a_written_tangent_mechanism_goes_its_stroke(tmp_path, road, one_sided) -> None:
    """From the first of its positions to the last, that at the largest pressure angle (theme 6, task 10)."""
    told = f"stroke = 0.15\npressure = 28\none_sided = {str(one_sided).lower()}"
    found = Study(read_scene(scene_of(tmp_path, "tangent", told)), ["positions"]).numbers("linkage", road).plain()
    first, *_, last = (y for _, y in found["points"]["A"]["r"])
    assert math.isclose(last - first, 0.15, rel_tol=1e-12) and math.isclose(found["phi"][-1], deg(28), rel_tol=1e-12)


@pytest.mark.parametrize("road", ["construction", "analysis"])
def test_a_written_double_crank_turns_fully(tmp_path, road) -> None:
    """Where its driver has turned back by π - θ, O, A and B are in line again; the speeds there are as asked (M1.4)."""
    path = scene_of(tmp_path, "double_crank", "coupler = 0.3\nswing = 40\noverlap = 15\nplace = 200")
    text = path.read_text(encoding="utf-8")
    drive, frame = (tomllib.loads(text)[name] for name in ("drive", "mechanism"))
    angles = [drive["start"], drive["start"] + 180 - 15]
    path.write_text(re.sub("start = .*\npositions = 12", f"positions = {angles}", text), encoding="utf-8")
    found = Study(read_scene(path), ["positions", "velocities"]).numbers("linkage", road).plain()
    assert found["gaps"] == []
    pivot, fixed = (complex(*frame["frame"][name]) for name in "OA")
    ends, speeds = (np.array([complex(*at) for at in found["points"]["B"][name]]) for name in "rv")
    assert np.allclose(((ends - pivot) / (fixed - pivot)).imag, 0, atol=1e-12)
    driven = (speeds / (1j * (ends - fixed))).real / math.tau  # at 60 rpm
    assert np.allclose(driven, [1 + PART, 1 - PART], rtol=1e-9, atol=0)


PACED = [  # theme 6, task 1: φ* = H n / v, and θ = 2π (φ* - 1/2)
    ("slotted_lever", "frame = 0.35\nstroke = 0.3\npressure = 8\nmean_speed = 0.4\noutput = 45"),
    ("whitworth", "crank = 0.075\nstroke = 0.3\npressure = 20\nmean_speed = 0.4\noutput = 50"),
    ("slider_crank", "stroke = 0.12\noffset = 0.03\nmean_speed = 0.5\noutput = 130"),
    ("slider_crank", "stroke = 0.12\nratio = 4\nmean_speed = 0.5"),
    ("sine", "stroke = 0.12\nmean_speed = 0.5"),
]


@pytest.mark.parametrize(("family", "told"), PACED)
def test_the_working_stroke_is_as_fast_as_asked(tmp_path, family, told) -> None:
    """The written scene's crank, its stroke and the angle of its working stroke make the mean speed and the output."""
    path = scene_of(tmp_path, family, told)
    found = Study(read_scene(path), ["extremes"]).numbers("linkage", "analysis").plain()["extremes"]
    asked = tomllib.loads(told)
    omega = float(tomllib.loads(path.read_text(encoding="utf-8"))["drive"]["speed"].removesuffix(" rad/s"))
    time = (math.pi + found["overlap"]) / omega
    assert math.isclose(found["stroke"] / time, asked["mean_speed"], rel_tol=1e-12)
    assert "output" not in asked or math.isclose(omega, math.tau * asked["output"] / 60, rel_tol=1e-12)


# A demand that cannot be met, the key that is told, and what can be.
REFUSED = [
    ("slotted_lever", "crank = 0.4\nframe = 0.35", "crank", "350 mm"),
    ("slotted_lever", "stroke = 0.5\nlever = 0.2\nframe = 0.3", "stroke", "400 mm"),
    ("slotted_lever", "overlap = 80\nframe = 0.3\nstroke = 0.3\npressure = 60", "pressure", "50 degrees"),  # 90 - psi/2
    ("slotted_lever", "overlap = 30\nstroke = 0.3\nlever = 0.5", "slotted_lever", "not all of which tell the swing"),
    ("slotted_lever", "time_ratio = 1\nframe = 0.35", "time_ratio", "above 0"),
    ("slotted_lever", "overlap = 30\nframe = 0.3\npressure = 6", "pressure", "stroke beside"),
    ("slotted_lever", "frame = 0.3\nstroke = 0.3\nmean_speed = 0.1\noutput = 30", "mean_speed", "0.2 and up to 0.3"),
    ("slotted_lever", "swing = 20\nframe = 0.3\nstroke = 0.3\nmean_speed = 0.28\noutput = 30", "swing", "12.8571"),
    ("whitworth", "crank = 0.3\nframe = 0.35", "frame", "300 mm"),
    ("whitworth", "crank = 0.3\nframe = 0.2\noutput = 30", "output", "stroke beside"),
    ("tangent", "stroke = 0.12", "tangent", "two of"),
    ("double_crank", "coupler = 0.3\nswing = 40\ntime_ratio = 1", "double_crank", "300 mm"),
    ("double_crank", "coupler = 0.3\nswing = 40\noverlap = 15\ndriver = 4", "driver", "300"),
]


@pytest.mark.parametrize(("family", "told", "key", "number"), REFUSED)
def test_what_cannot_be_met_is_refused_with_what_can(tmp_path, family, told, key, number) -> None:
    path = tmp_path / "task.toml"
    path.write_text(f"[synthesis.{family}]\n{told}\n", encoding="utf-8")
    (fault,) = read_scene(path).meaning.faults
    assert fault.path[-1] == key and number in str(fault)
