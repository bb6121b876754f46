"""What is said of machines that the gallery has not, by report, remarks and first numbers; and what is not said."""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import pytest

from drawings.report.report import headlines, remarks, report
from plans.linkage.study import LinkageStudy
from plans.model.mechanism import ways
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.drawings.balance_scenes import scene as balanced
from tests.drawings.bank_scenes import bank, compensator
from tests.gallery import GALLERY
from tests.plans.cyclograms import scene_text
from tests.plans.dynamics_scenes import PLANING, text
from tests.plans.force_cases import text_of
from tests.plans.scenes import changed
from tests.plans.test_cam_marks import SIZES, TURNING, one
from tests.plans.test_cyclogram import CAM
from tests.plans.test_load_pressures import PUSHED, WITH_ROD
from tests.plans.test_loading import ENGINE, ROCKER

ENGLISH = '[sheet]\nlanguage = "en"\n'
GRADED = "rotor.speed = 100\nrotor.mass = 20\n"
UNLIKE = "{ moment = 1, angle = 0, place = 1 }, { moment = 3, angle = 0, place = 0 }"
LOAD = "[cam.load]\nmass = 2\nforce = 100\n"
FLAT = one("flat", '[cam.limits]\ncurvature = "5 mm"\n')
WEAR = "by which it wears"
STOPS = "the machine would stop"
CASES, IN_ENGLISH = Path(__file__).parents[1] / "cases/loads", ('language = "ru"', 'language = "en"')
JACK = (
    "Working stroke: counter-clockwise, up, the faster of the two; "
    "the crank turns 163.80° over it, 196.20° over the idle stroke"
)
NO_FLYWHEEL = "divisions = 24"


def gallery(name: str, sheet: str, more: str = "") -> str:
    """Ask one sheet of a scene of the gallery."""
    scene = (GALLERY / f"{name}.toml").read_text("utf-8")
    return re.sub("(?m)^sheets = .*$", f'sheets = ["{sheet}"]', scene) + more


def rotor(rows: str, more: str = "") -> str:
    return f'sheets = ["rotor"]\nrotor.masses = [{rows}]\n{more}{ENGLISH}'


def case(name: str, *changes: tuple[str, str]) -> str:
    """Give a loaded machine with some of its words changed."""
    return changed((CASES / f"{name}.toml").read_text("utf-8"), *changes)


class Row(NamedTuple):
    """A scene, what is said of it, and what is not."""

    scene: str
    said: Sequence[str]
    unsaid: Sequence[str] = ()


ROWS = {
    # Balancing
    "a link on a slide has a variable vector: a yoke of 4 kg beside a stone of 0.3 kg": Row(
        gallery("scotch-yoke", "balancing", "\n[balance]\n"),
        [
            "Link 3 hangs on a slide: its vector $u_{3}$ along the guide is variable, 0.93023 of the way",
            "- Gravity: (0; −9.81) m/s²",
        ],
    ),
    "a main point off its link's line is a vector, at the angle of S (10; 4)": Row(
        gallery("shaking-yoke", "balancing"), [r"$\bar h_{3}$ = $m_{3}$·$\bar l_{BS_{3}}$/m = ", "m ∠ 21.801° from "]
    ),
    "whose speeds plans are drawn at": Row(
        gallery("planer", "kinematics").replace("[drive]\n", '[drive]\nspeed_from = "dynamics"\n'),
        ["(of the machine's steady motion under a constant driving moment)"],
    ),
    "what is balanced already needs nothing": Row(
        balanced("still"),
        ["Balanced in this way already: no counterweight is needed"],
        ["are added to links", "a_1 = "],
    ),
    "a slow crank has tiny forces and the same best shares": Row(
        balanced("engine", "A1").replace("speed = 20", "speed = 2e-5"), ["with k = 0.58994", "1.7162·10⁻¹⁰ N"]
    ),
    "reactions have the letter of the scene": Row(
        balanced("engine", "A1") + 'reactions = "P"\n',
        ["largest P_01: 473 → ", "| $P_{01}$, N |"],
        ["largest R_01", "| $R_{01}$, N |"],
    ),
    # Banks
    "a bank at rest in itself": Row(
        bank([(0, 0, 0), (180, 0, 180)], compensator(1)) + ENGLISH, ["balance one another"], ["F_{max}"]
    ),
    "an order too slight to be drawn": Row(
        bank([(0, -100, 0), (120, 0, 0), (240, 100, 0)]) + ENGLISH, ["Below 1/1000 of the largest, not drawn: order 6"]
    ),
    "a letter begins no sentence with a capital": Row(
        bank([(0, -100, 0), (120, 0, 0), (240, 100, 0)], compensator(6)) + ENGLISH, ["\n- $mr_{VI}$"], ["$Mr"]
    ),
    # Rotors
    "the quality of one plane: 4 kg*m of 20 kg at 100 rad/s": Row(
        rotor(UNLIKE, GRADED), ["e·ω = 20000 mm/s"], ["the worse plane, doubled"]
    ),
    "the quality of two planes is that of the worse one, doubled: 2*3/20": Row(
        rotor(UNLIKE, f"{GRADED}rotor.planes = [{{ place = 1 }}, {{ place = 0 }}]\n"),
        ["e·ω = 30000 mm/s", "the worse plane, doubled"],
    ),
    "one plane tells no grade while a couple is left": Row(
        rotor(
            '{ moment = 1, angle = 0, place = "0.5 m" }, { moment = 1, angle = 90 }',
            f"{GRADED}rotor.bearings = [0, 1]\n",
        ),
        ["of the resultant alone"],
        ["as drawn: e"],
    ),
    # Cams
    "a pointed follower wears": Row(one("pointed", SIZES, TURNING + LOAD), ["Force at the contact: from ", WEAR]),
    "a roller does not": Row(one("roller", SIZES, TURNING + LOAD), ["Force at the contact: from "], [WEAR]),
    "a face that is long enough is no complaint": Row(
        FLAT.replace("lift =", 'reach = "60 mm"\nlift ='), ["reach of the face b = 60 mm"], ["must"]
    ),
    "the setting of a single cam": Row(one().replace("speed =", "setting = 306.9\nspeed ="), ["306.9°"]),
    # Loads
    "which way the working stroke goes": Row(
        case("pumping-jack", IN_ENGLISH),
        [
            f"\n- {JACK}\n",
            f"\n- Pш over the stroke. {JACK}\n",
            "K = 1.1978 of the slower, idle stroke over the faster, working one",
        ],
    ),
    "without a choice only the loads tell the working stroke": Row(
        case("pumping-jack", ('working = "up"\n', "")),
        ["- Pш по ходу. Рабочий ход: по часовой стрелке, вниз, более медленный из двух; кривошип"],
        ["\n- Рабочий ход", "быстрее"],
    ),
    "reactions by sizes and angles, a piston by its areas, letters as in the formulas": Row(
        gallery("compressor", "forces").partition("[sheet]")[0] + ENGLISH,
        [
            "D = 112.84 mm; the pressure acts on 100 cm²",
            " ∠ ",
            r"$\lvert M_{\text{bal}}\rvert_{\text{max}}$ = ",
            "## Conclusion",
        ],
        ["e-1", "kappa"],
    ),
    "a force between two links": Row(case("pump", IN_ENGLISH), ["- P between B of link 2 and C of link 3, always"]),
    "a load that rests on a reversal": Row(
        case("press", IN_ENGLISH, ('during = "working direction"\n', "")),
        [
            "its point reverses 4 times in a turn, at 19.96°, 151.1°, 204.8°, 259.3°. If it should act",
            'write during = "working direction"',
        ],
    ),
    "a load that follows its stroke rests on no reversal": Row(
        case("press", IN_ENGLISH),
        [r"$F_{\text{us}}$ at G of link 7, wherever it goes as on the working stroke"],
        ["its point reverses"],
    ),
    "one position of the other flank": Row(text_of("shaper", ("= 1500", "= -1500")), ["never pull: in position 0 "]),
    "wear is a mean over positions": Row(gallery("slotter", "forces"), ["(по 12 положениям)"]),
    # Cyclograms
    "the positions of a tool": Row(
        scene_text("shaper", "overrun = 0.1\nbreaks = [0.6, 0.75]\n" + CAM),
        [
            "| 8  overrun begins | 48.00 | 306.88 | 0.415 |",
            r"$\varphi_{\text{rise}}$ = 360° − ($\varphi_{2}$ − $\varphi_{1}$) = 74.58°",
            "set at 306.88°",
        ],
    ),
    "a window within one turn": Row(
        gallery("press-cycle", "cyclogram"),
        [r"$\varphi_{\text{у}}$ = $\varphi_{1}$ − $\varphi_{2}$ = 105,79°"],
        ["360° − ($"],
    ),
    # Motion of a machine
    "heavy enough without a flywheel": Row(
        text(asked='fluctuation = "1/5"\nshafts = [{ inertia = 40 }]'),
        ["heavy enough without a flywheel", "## Motion without a flywheel", "- Without a flywheel δ"],
        ["ith the flywheel"],
    ),
    "without its flywheel the machine would stop": Row(text(), [STOPS], ["wrong direction"]),
    "no rim of the diameter that is asked for": Row(
        text(asked='fluctuation = "1/40"\nflywheel.diameter = "0.2 m"'), ["No rim of D = 200"]
    ),
    "a piston alone is no inertia at its dead centre": Row(
        re.sub(r"(?m)^[12] = \{ mass.*\n", "", text(drive="start = 180\npositions = 24")), ["the linkage has 0 at"]
    ),
    "a shaft beside the linkage": Row(
        text(asked='fluctuation = "1/25"\nshafts = [{ inertia = 0.4, ratio = 2.5, name = "gear" }]'),
        ["Shaft (gear): 0.4 kg·m²"],
    ),
    "no flywheel where no fluctuation is asked for, but that the machine would stop": Row(
        text(asked=NO_FLYWHEEL), ["M_dr", STOPS], ["Flywheel"]
    ),
    "with a motor the driving moment is constant for the flywheel alone": Row(
        text(asked='fluctuation = "1/25"\nmotor = { starting = "200 N*m", synchronous = 20 }'),
        ["the run with that of the motor", "= ($\\omega_{\\text{max}}$", "turn, by 26 strips, the loads"],
        ["the drive's own slip"],
    ),
    "a heavy shaft has enough energy": Row(text(asked=f"{NO_FLYWHEEL}\nshafts = [{{ inertia = 40 }}]"), [], [STOPS]),
    "rounding is nothing: weights do no work over a turn": Row(
        text("[loads]\ngravity = 9.81\n", "positions = 12"), ["| 0 |"], ["0.0000000000", "·10⁻¹⁶ J", "·10⁻¹⁷ J"]
    ),
    "rotation and working stroke where no forces are drawn": Row(
        text().replace("120 rpm", "-120 rpm"),
        [
            "- Crank: turns clockwise\n",
            "\n- $F_{\\text{us}}$ over the stroke. Working stroke: to the ",
            "the crank turns 180.00° over it",
            "\n| 1 | 345",
        ],
    ),
    "loads that drive": Row(
        text(PLANING.replace('against = "motion"', "direction = 180")), ["one of them has the wrong direction"]
    ),
    "a scene that draws no such sheet": Row(
        text().replace('sheets = ["dynamics"]', 'sheets = ["positions"]'),
        ["- Motion of the machine under its loads: the sheets do not need it."],
    ),
}


def told(scene: str) -> str:
    """Give all that is said of a scene, in plain spaces."""
    study = Study(parse_scene(scene))
    said = [*headlines(study), *map(str, remarks(study)), report(study, {})]
    return "\n".join(said).replace("\N{NO-BREAK SPACE}", " ")


@pytest.mark.parametrize("row", ROWS.values(), ids=ROWS)
def test_it_is_said(row: Row) -> None:
    said = told(row.scene)
    assert [one for one in row.said if one not in said] == []
    assert [one for one in row.unsaid if one in said] == []


def test_the_numbers_of_a_report_balance_each_other() -> None:
    """A piston without mass: pressures on the areas that are told give its load, which balances both its reactions."""
    said = report(Study(parse_scene(f'sheets = ["forces"]\n{ENGINE}{PUSHED}{WITH_ROD}')), {}).replace("−", "-")
    areas = re.search(r"acts on (\S+) cm², the other side has (\S+) cm²; 0.3 MPa behind", said)
    assert areas
    load = 1e-4 * (8e5 * float(areas[1]) - 3e5 * float(areas[2]))
    lines = said.partition("## Reactions")[2].partition("###")[0].splitlines()
    heads, _, *rows = (re.split(r" *\| *", line) for line in lines if line.startswith("|"))
    for row in rows:
        of = {}
        for head, cell in zip(heads, row, strict=True):
            x, y, size, angle = (float(one) for one in [*re.findall(r"-?\d+(?:\.\d+)?", cell), *"0000"][:4])
            assert "∠" not in cell or abs(complex(x, y) - cmath.rect(size, math.radians(angle))) < 2e-4 * size
            of[head.partition(" ")[0]] = complex(x, y)
        assert abs(of["$R_{03}$"] + of["$R_{23}$"] - load) < 1e-4 * load


SLIDER, GUIDE = "B = [0.5, 0]", "[0, 0] }"


@pytest.mark.parametrize(
    ("scene", "named"),
    [
        (ENGINE, ("left",)),
        (ENGINE.replace(GUIDE, "[0, 0], angle = 90 }").replace(SLIDER, "B = [0, 0.5]"), ("down",)),
        (ENGINE.replace(GUIDE, "[0, 0], angle = 30 }").replace(SLIDER, "B = [0.4, 0.3]"), ("left", "down")),
        (ENGINE.replace(GUIDE, "[0, 0], angle = 8 }"), ("left",)),
        (ROCKER, ("clockwise",)),
        (ROCKER + '[output]\npoint = "B"\n', ("clockwise", "right", "up")),
    ],
)
def test_the_way_of_a_stroke_in_words(scene: str, named: tuple[str, ...]) -> None:
    """From the outer dead centre the slider goes in; the rocker's end above C from 0.3 to 0.5 from O, to the right."""
    study = LinkageStudy(parse_scene(scene))
    low, high = (0.5, 0.3) if "AB" in scene and "CB" not in scene else (2.5, 1.5)
    assert ways(study.mechanism, study.output, low, high) == named
