"""Scenes that the gallery has not, of every technique: what is odd about each stands in its name or beside it."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import cycle
from pathlib import Path
from typing import NamedTuple

from tests.drawings import balance_scenes, bank_scenes, mechanisms
from tests.gallery import GALLERY
from tests.plans.cyclograms import scene_text
from tests.plans.dynamics_scenes import PLANING, text
from tests.plans.force_cases import DYADS, text_of

CASES = Path(__file__).parents[1] / "cases"
PAPERS = ("A1", "en", "GOST"), ("A3", "ru", "ISO"), ("A4", "en", "ISO"), ("A2", "ru", "GOST")


class Odd(NamedTuple):
    """A scene, and what is said on its sheets."""

    name: str
    text: str
    says: tuple[str, ...] = ()


# Banks: said of them is what vanishes, what is left out, and why.
SAID = {
    "vee": ("a counterweight on the crank itself",),
    "six": ("Forces of order 1, 2, 4 balance one another", "Order 1: nothing to compensate"),
    "three": ("Below 1/1000 of the largest, not drawn: order 6", "Over the turn F_{max} = 0.8806"),
    "cancelled": ("of order 2, 4, 6 the latter is the mirror image in the guide, not shown",),
    "unlike": ("F_{I} and F_{−I} differ: couples by the distances of the two shafts are not counted",),
}


def banks() -> Iterator[Odd]:
    for paper, name in zip(cycle(PAPERS), bank_scenes.SCENES, strict=False):
        yield Odd(f"bank {name}", bank_scenes.scene(name, *(PAPERS[0] if name in SAID else paper)), SAID.get(name, ()))


def balances() -> Iterator[Odd]:
    papers = cycle((*PAPERS[:2], ("A2", "ru", "GOST"), ("A2", "en", "ISO")))
    for paper, name in zip(papers, balance_scenes.SCENES, strict=False):
        yield Odd(f"balance {name}", balance_scenes.scene(name, *paper))


# Machines: what is asked of them on which paper.
WHEEL = 'fluctuation = "1/25"\nflywheel.diameter = "1.2 m"\n'
SHAFTS = 'shafts = [{ inertia = 0.4, ratio = 2.5, name = "gear" }]\n'
MOTOR = "motor = { rotor = 0.02, ratio = 8, breakdown = 40, slip = 0.2, synchronous = 105 }\nrun = { brake = 100 }\n"
STARTED = 'motor = { rotor = 0.02, ratio = 10, starting = "60 N*m", synchronous = "1250 rpm" }\nrun = { brake = 100 }\n'
ASKED = {
    "with shafts": (WHEEL + SHAFTS, "A3", "ru"),
    "of a fine fluctuation": ('fluctuation = "1/500"\ndivisions = 360', "A3", "en"),
    "heavy enough without a flywheel": ('fluctuation = "1/5"\nshafts = [{ inertia = 80 }]', "A3", "en"),
    "without a rim of its diameter": ('fluctuation = "1/40"\nflywheel.diameter = "0.2 m"', "A1", "en"),
    "of no fluctuation": ("divisions = 36", "A1", "en"),
    "of a thousand strips": ('fluctuation = "1/25"\ndivisions = 1000', "A1", "en"),
    "with a motor": (WHEEL + MOTOR, "A1", "ru"),
    "with a motor, small": (WHEEL + STARTED, "A4", "en"),
}
SPRUNG = """
[[loads.forces]]
on = 3
point = "B"
direction = 180
bore = 0.1
behind = "0.1 MPa"
diagram = { travel = ["0 %", "20 %", "100 %"], pressure = ["0.6 MPa", "0.1 MPa", "0.1 MPa"] }
"""
EXTREME = 'start = "extreme"\npositions = 12'


def without_masses(scene: str) -> str:
    before, after = scene.split("[masses]", 1)
    return before + after[after.index("[[loads") :]


# What is but rounding is not held to its digits: constant inertia, a loop touched in both dead points, no load.
ROUNDED = {
    "from an extreme": text(PLANING, EXTREME, WHEEL),
    "of constant inertia": without_masses(text(asked=WHEEL + SHAFTS)),
    "of constant inertia from an extreme": without_masses(text(PLANING, EXTREME, WHEEL + SHAFTS)),
    "touched in both dead points": text(SPRUNG, EXTREME, WHEEL),
    "of masses alone": text("", "positions = 12", WHEEL),
    "of one position": text("", "positions = [60]", ""),
    "of weights alone": text("[loads]\ngravity = 9.81\n", "positions = 12", WHEEL),
    "of steep tangents": text(asked='fluctuation = "1/25"').replace("120 rpm", "1500 rpm"),
    "left of its axis": text(PLANING, "positions = 24\nstart = 70", 'fluctuation = "1/25"'),
}


def machines() -> Iterator[Odd]:
    for name, (asked, size, language) in ASKED.items():
        yield Odd(f"machine {name}", f'{text(asked=asked)}[sheet]\nformat = "{size}"\nlanguage = "{language}"\n')
    yield from (Odd(f"machine {name}", scene) for name, scene in ROUNDED.items())


# Cams: a scene of the gallery, what is otherwise in it, and the flaw that is told of it.
CAMS = (
    ("tappet-cam", "[cam.limits]", '[cam.sizes]\nbase = "35 mm"\n[cam.limits]', "{min} = −"),
    ("rocker-cam", 'speed = "240 rpm"', "", ""),
    ("tappet-cam", 'end = "flat"', 'end = "flat"\nreach = "20 mm"', "off the face"),
    ("tappet-cam", 'length = "45 мм"', "angle = 75", "middle of the keyway at θ = 75°"),
    ("rocker-cam", "[cam.limits]", '[cam.hub]\nbore = "18 mm"\nwidth = 0\n[cam.limits]', "without a keyway"),
    ("feed-cam", "[cam.limits]", '[cam.sizes]\nbase = "50 mm"\noffset = "-8 mm"\n[cam.limits]', "e = −8"),
    ("feed-cam", "[cam.limits]", '[cam.sizes]\nbase = "50 mm"\noffset = "0.4 mm"\n[cam.limits]', "e = 0.4"),
    ("rocker-cam", 'law = "sine"', 'law = "constant velocity"', "Corner at φ = 120°"),
    ("copying-cam", 'speed = "0.4 m/s"', "", "Soft shock at x = 100 mm: S'' jumps by"),
)
# A diagram so small that the arcs of both limits of the rise would lie on one place.
CROWDED = """
sheets = ["cam"]
sheet.format = "A3"
[[cam]]
speed = "-262 rpm"
follower = { motion = "rocking", end = "roller", swing = 4, turns = "with", length = "253 mm" }
limits = { rise = 17, return = 22 }
phases = [{ kind = "rise", angle = 87, law = "constant velocity" }, { kind = "return", angle = 117, law = "3-4-5" },
    { kind = "dwell", angle = "rest" }]
"""


def cams() -> Iterator[Odd]:
    for name, old, new, said in CAMS:
        scene = (GALLERY / f"{name}.toml").read_text(encoding="utf-8").replace('language = "ru"', "")
        assert old in scene
        yield Odd(f"{name}, {said or 'no speed'}", scene.replace(old, new, 1), (said,))
    yield Odd("cam of crowded limits", CROWDED, ("−α_{rise} = −17°", "α_{rise} = 17°"))


LOADED = {"pump": ("'P'", "'P′'")}  # a force between two links stands at both ends
CYCLOGRAMS = ("crank-rocker", "walking-leg", "press", "jaw-crusher", "scotch-yoke", "oscillating-cylinder")


def linkages() -> Iterator[Odd]:
    yield from (Odd(name, text) for name, text in mechanisms.ALL.items())
    yield from (Odd(f"cyclogram of {name}", scene_text(name)) for name in CYCLOGRAMS)
    yield from (Odd(f"dyad of {name}", text_of(name)) for name in DYADS)
    for path in sorted((CASES / "strokes").glob("*.toml")):
        yield Odd(f"stroke of a {path.stem}", path.read_text(encoding="utf-8"))
    for path in sorted((CASES / "loads").glob("*.toml")):
        yield Odd(f"load of a {path.stem}", path.read_text(encoding="utf-8"), LOADED.get(path.stem, ()))
    ram = (CASES / "strokes" / "ram.toml").read_text(encoding="utf-8").replace('"forces"', '"kinematics"', 1)
    yield Odd("stroke whose ticks lie under a block", ram.replace("positions = 6", "positions = 60"))


STRUCTURES = {  # what is said of their structure
    "triad": ("Наименьший класс II",),
    "roller": ("Local mobility: link 3 turns by itself",),
    "parallelogram": ("пассивные звенья 1, 3, 4",),
    "slider": ("link 2 moves across the plane by itself",),
}


def filed() -> Iterator[Odd]:
    for folder in ("odd_balances", "odd_structures"):
        for path in sorted((CASES / folder).glob("*.toml")):
            yield Odd(path.stem, path.read_text(encoding="utf-8"), STRUCTURES.get(path.stem, ()))


PAIRS = {  # of involute wheels: what is given, and of the paper
    "far wheel": ('teeth = [21, 90]\naim = "no undercut"\ncentre = 281', 'format = "A3"\nstandard = "ISO"'),
    "plain pair": ("teeth = [20, 31]", 'language = "ru"'),
    "shift inwards": ("teeth = [40, 61]\nshift = [-0.4, 0.1]", 'format = "A2"'),
    "ring of odd teeth": ("teeth = [17, 45]\nshift = [0.5, 0.9]\ninternal = true", 'format = "A3"\nlanguage = "ru"'),
    "few teeth": ('teeth = [9, 31]\naim = "no undercut"', 'language = "ru"'),
    "steep rack": ('teeth = [13, 20]\nangle = 25\naim = "equal sliding"', 'format = "A3"\nlanguage = "ru"'),
}


def pairs() -> Iterator[Odd]:
    said = {"far wheel": "is shared inversely", "plain pair": "Δy = 0", "steep rack": "α = 25°"}
    said |= {"few teeth": "колеса 1 тоньше 0,25m"}
    for name, (given, paper) in PAIRS.items():
        text = f'sheets = ["involute"]\n[involute]\nmodule = 5\n{given}\n[sheet]\n{paper}\n'
        yield Odd(name, text, (said[name],) if name in said else ())


TASKS = (  # of synthesis: what is asked
    "crank_rocker]\nrocker = 0.3\nswing = 40\noverlap = 15\nframe = 0.441",  # on both circles
    "crank_rocker]\nrocker = 0.3\nswing = 40\noverlap = 15\nplace = 160\nbeyond = true",
    "crank_rocker]\nrocker = 0.3\nswing = 40\noverlap = 0\nframe = 0.441",
    "slider_crank]\nstroke = 0.12\ntime_ratio = 1.2",
    "slider_crank]\nstroke = 0.12\nratio = 4",
    "slider_crank]\nstroke = 0.12\nratio = 4\npressure = 20",
    "slider_crank]\nstroke = 0.12\noffset = 0.05\nratio = 2.2",  # two mechanisms
    "double_crank]\ncoupler = 0.3\nswing = 40\noverlap = 15",
    "double_crank]\ncoupler = 0.3\nswing = 40\noverlap = 20",  # M on C
    "crank_rocker]\nrocker = 30\nswing = 5\noverlap = 5",  # arcs too short to be hatched
    "whitworth]\noverlap = 5\ncrank = 0.07\nstroke = 0.21\npressure = 0.5",  # an angle too small for a dimension
    "slotted_lever]\ncrank = 0.12\nframe = 0.35",  # methods M1.7
    "slotted_lever]\ntime_ratio = 1.5\nframe = 0.35\nstroke = 0.48\npressure = 8\nmean_speed = 0.5",
    "slotted_lever]\noverlap = 38\ncrank = 0.12\nstroke = 0.5\nlever = 0.7",  # three readings
    "whitworth]\ntime_ratio = 2.2\ncrank = 0.075\nstroke = 0.3\npressure = 20\noutput = 40",
    "sine]\nstroke = 0.12",  # theme 6, task 6
    "tangent]\nstroke = 0.15\npressure = 28",  # theme 6, task 10
    "rocker_slider]\nstroke = 0.12\npressure = 20\nratio = 10",
    "rocker_slider]\nstroke = 0.15\nangles = [8, 30]\nratio = 0.5\npressure = 20",  # two readings, to either side
    "rod_positions]\nplaces = [[0.05, 0.3], [0.16, 0.34], [0.26, 0.3]]\nangles = [10, -12, -40]\n"
    "hinges = [[0.03, 0.22], [0.19, 0.27]]",  # none of its places is the origin
    "rod_positions]\nplaces = [[0, 0], [0.3, 0.1], [0.4, 0.3]]\nangles = [0, 30, 80]\nhinges = [[0, 0.1], [0.3, 0.05]]",
    "rod_positions]\nplaces = [[0, 0], [0.3, 0.1]]\nangles = [0, 34]\npivots = [[-0.2, -0.2], [0.4, -0.3]]\n"
    "arms = [0.5, 0.4]",  # four mechanisms
    "rod_positions]\nplaces = [[0, 0], [0.2, 0.15], [0.5, 0.2]]\nangles = [0, 0, 0]\nhinges = [[0, 0.1], [0.3, 0.05]]",
    "function_points]\ninputs = [30, 60, 95]\noutputs = [0, 18, 45]\ncrank = 0.1\nframe = 0.3",
    "function_points]\ninputs = [30, 95]\noutputs = [0, 45]\ncrank = 0.1\nframe = 0.3\nrocker = 0.15",
    "dwell]\ncrank = 0.1\ncoupler = 0.23\nrocker = 0.25\nframe = 0.21\narm = 0.47\nlean = 60\n"
    "dwell = [149, 219]\noutput = 0.13",
)


def tasks() -> Iterator[Odd]:
    """Write the odd tasks of synthesis, every other one in Russian."""
    for k, asked in enumerate(TASKS):
        yield Odd(f"task {k + 1}", f'[synthesis.{asked}\n[sheet]\nlanguage = "{"en" if k % 2 else "ru"}"\n')


EVERY = (*tasks(), *pairs(), *banks(), *balances(), *machines(), *cams(), *linkages(), *filed())
