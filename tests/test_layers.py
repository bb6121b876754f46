"""Layers: drawings rest on plans, plans on geometry, never the other way; each heavy library has its one place."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from plans.techniques import TECHNIQUES, named
from tests.own_text import parsed
from tests.rows import over

ROOT = Path(__file__).parent.parent
TOPS = ("geometry", "plans", "drawings")
FILES = sorted(file.relative_to(ROOT).as_posix() for top in TOPS for file in (ROOT / top).rglob("*.py"))

EITHER = ("geometry", "plans.analytic", "plans.linkage", "plans.scene")
# Where the board is drawn on: no value of it may be what a sheet is held to.
CONSTRUCTIONS = (
    *("geometry.board", "geometry.meet", "plans.linkage.drafts", "plans.linkage.motion_plans"),
    *("plans.forces.force_template", "plans.forces.polygon", "plans.forces.lever"),
    *("plans.cam.profile", "plans.cam.centre", "plans.dynamics.loop", "plans.balance.sums", "plans.bank.polygons"),
    *("plans.structure.groups", "plans.structure.constraints"),
    *("plans.involute.action", "plans.involute.flanks", "plans.involute.generation"),
    *("plans.synthesis.chord", "plans.synthesis.rocker", "plans.synthesis.slider"),
    *("plans.synthesis.double_crank", "plans.synthesis.slotted", "plans.synthesis.sine"),
    *("plans.synthesis.rocker_slider", "plans.synthesis.centre_points", "plans.synthesis.rod_positions"),
    "plans.synthesis.dwell",
)
# Where a technique is drawn.
DRAWN = tuple(f"drawings.{name}" for name in TECHNIQUES)
# Where both roads of a technique are put beside each other.
BOTH = (
    *(f"plans.{name}.quantities" for name in TECHNIQUES),
    *("plans.balance.centre", "plans.cam.verdicts", "plans.cam.numbers", "plans.dynamics.numbers"),
    *("plans.forces.friction_quantities", "plans.forces.equilibrium", "plans.forces.bill", "plans.linkage.parts"),
)
ROADS = "both roads"
# What each technique is asked, which names the types of all rooms; at run time it knows none of them but for a default.
CONTRACT = "plans/techniques.py"
# Where a technique is an object: it knows all that its folder makes by either road.
OBJECTS = tuple(f"plans/{name}/__init__.py" for name in TECHNIQUES)
# Folder or file: what it must not import, anywhere in its text.
FORBIDDEN = {
    "geometry/": ("plans", "drawings"),
    "plans/": ("drawings",),
    "plans/analytic/": ("geometry.meet", "geometry.board", "geometry.replay", "geometry.precision"),
    **{f"plans/{name}/": ("plans.analytic",) for name in TECHNIQUES},
    # Who reads a sheet knows what stands on paper, the data of the alphabet, and words to refuse with.
    "drawings/reading/": (
        "drawings.layout",
        "drawings.lettering",
        "drawings.page",
        "drawings.pens",
        "drawings.symbols",
        "drawings.kinds",
        "drawings.sheets",
        *(f"plans.{room.stem}" for room in (ROOT / "plans").iterdir() if room.stem not in ("__init__", "words")),
    ),
    "drawings/checks/": ("drawings.kinds", "drawings.sheets", *DRAWN, "plans.analytic", *CONSTRUCTIONS),
    # Loads are put on either road's motion.
    "plans/forces/loading.py": EITHER,
}
# What must stand on a sheet is told by the analysis alone.
DUE, NO_DUE = re.compile(r"drawings/\w+/due\w*\.py"), ("drawings.kinds", "drawings.sheets", *CONSTRUCTIONS)
# all of plans that the analytic road may know
SHARED = (
    "plans.words",
    "plans.analytic",
    "plans.model.dyad",
    "plans.model.mechanism",
    "plans.model.motion",
    "plans.model.machine",
    "plans.model.kinetostatics",
    "plans.model.run",
    "plans.model.dynamics",
    "plans.model.motor",
    "plans.model.rotor",
    "plans.model.balance",
    "plans.model.cam",
    "plans.model.cam_motion",
    "plans.model.cyclogram",
    "plans.model.diagrams",
    "plans.model.structure",
    "plans.model.involute",
    "plans.model.gears",
    "plans.model.trains",
    "plans.model.synthesis",
)
ONLY_IN = {
    "svgwrite": ("drawings/pens/svg.py", "drawings/bench/plain_pen.py"),  # the bench times its defaults beside our pen
    "mpmath": ("geometry/replay.py",),
    "matplotlib": ("drawings/bench/plot.py",),
    "pylinkage": ("plans/bench/peers.py",),
    "scipy": ("plans/analytic/dynamics/equation.py",),
    "mechanism": ("plans/bench/peers.py",),
    "pytest": ("drawings/pytest_plugin/plugin.py",),  # which is only loaded by it
}
# Imported inside the function that needs them.
LATE = ("mpmath", "scipy", "shapely", "matplotlib", "numba", "pylinkage", "mechanism")


def within(module: str, package: str) -> bool:
    return module == package or module.startswith(f"{package}.")


def faults(path: str, text: str) -> Iterator[str]:
    """Give the imports of a file that its place forbids."""
    for module, line, late in parsed(text).imports:
        where = f"{path}:{line}: {module}"
        for folder, barred in FORBIDDEN.items():
            if (
                path.startswith(folder)
                and module_of(path) not in BOTH
                and any(within(module, package) for package in barred)
            ):
                yield f"{where} in {folder}"
        stated = any(re.fullmatch(rf"{room}(\.(due\w*|report)(\..*)?)?", module) for room in DRAWN)
        if DUE.match(path) and not stated and any(within(module, one) for one in (*NO_DUE, *DRAWN)):
            yield f"{where} in what must stand on a sheet"
        known = module == "plans" or any(within(module, package) for package in SHARED)
        if path.startswith("plans/analytic/") and within(module, "plans") and not known:
            yield f"{where} on the analytic road"
        if module.startswith("."):
            yield f"{where} is relative"
        library = module.partition(".")[0]
        if path not in ONLY_IN.get(library, (path,)):
            yield f"{where} outside {' and '.join(ONLY_IN[library])}"
        if library in LATE and not late:
            yield f"{where} at start-up"


@over("path", FILES)
def test_a_file_imports_only_what_its_layer_may(path: str) -> None:
    assert list(faults(path, (ROOT / path).read_text("utf-8"))) == []


def test_all_three_layers_are_examined() -> None:
    assert {path.partition("/")[0] for path in FILES} == set(TOPS)
    assert {"plans/analytic/kinematics.py", "drawings/pens/svg.py", "geometry/replay.py"} <= set(FILES)


@pytest.mark.parametrize(
    ("path", "text"),
    [
        ("geometry/meet.py", "import plans.linkage.study"),
        ("geometry/meet.py", "def f():\n    from drawings.files import atomic_files"),
        ("plans/linkage/study.py", "from drawings.files.atomic_files import write"),
        ("plans/analytic/closure.py", "from geometry.meet import arc_arc"),
        ("plans/analytic/closure.py", "from geometry import board"),
        ("plans/analytic/closure.py", "from plans.linkage.dyads import RRR"),
        ("plans/analytic/closure.py", "from plans.linkage import motion_plans"),
        ("plans/analytic/friction.py", "from plans.forces.rubbing import lost"),
        ("plans/analytic/friction.py", "from plans.forces import locking, friction"),
        ("plans/forces/loading.py", "from plans.linkage.study import LinkageStudy"),
        ("plans/rotor/reading.py", "def f():\n    from plans.analytic.rotor import balance"),
        ("drawings/page/page.py", "import svgwrite"),
        ("drawings/reading/alphabet.py", "from drawings.lettering.lettering import text_width"),
        ("drawings/reading/sheet.py", "def f():\n    from drawings.pens.paths import HUNDREDTH"),
        ("drawings/reading/sheet.py", "from plans.model.motion import Floats"),
        ("drawings/rotor/due.py", "from drawings.rotor.along import measure"),
        ("drawings/linkage/due.py", "def f():\n    from plans.linkage.drafts import Drafts"),
        ("drawings/checks/hold.py", "from drawings.rotor import due"),
        ("drawings/pens/svg.py", "from .strokes import Line"),
        ("geometry/replay.py", "import mpmath"),
        ("plans/linkage/quantities.py", "def f():\n    import mpmath"),
        ("plans/linkage/study.py", "from scipy import integrate"),
        ("drawings/layout/labels.py", "class A:\n    from shapely.geometry import box"),
        ("drawings/report/report.py", "if True:\n    import matplotlib.pyplot"),
        ("drawings/report/report.py", "def f():\n    from matplotlib.figure import Figure"),
        ("drawings/bench/plot.py", "from matplotlib.figure import Figure"),
        ("plans/bench/peers.py", "import mechanism"),
        ("plans/bench/motion.py", "def f():\n    import pylinkage"),
        ("plans/bench/motion.py", "from drawings.bench import sheet"),
    ],
)
def test_a_planted_fault_is_seen(path: str, text: str) -> None:
    assert len(set(faults(path, text))) >= 1


@pytest.mark.parametrize(
    ("path", "text"),
    [
        ("geometry/replay.py", "if TYPE_CHECKING:\n    import mpmath"),
        ("geometry/replay.py", "def exact():\n    import mpmath"),
        ("plans/analytic/closure.py", "from plans.analytic.points import X\nfrom geometry.errors import DraftError"),
        ("plans/analytic/closure.py", "from plans.model.mechanism import FRAME\nfrom plans.model.motion import Motion"),
        ("drawings/pens/svg.py", "import svgwrite\nfrom svgwrite import shapes"),
        ("drawings/layout/labels.py", "def f():\n    from shapely import geometry"),
        ("drawings/bench/plain_pen.py", "import svgwrite"),
        ("drawings/bench/plot.py", "def f():\n    from matplotlib.figure import Figure"),
        ("drawings/report/report.py", "from plans.linkage.study import LinkageStudy\nfrom geometry.board import at"),
    ],
)
def test_what_is_allowed_is_let_pass(path: str, text: str) -> None:
    assert list(faults(path, text)) == []


# The rooms from the ground up: a room knows only what stands in the rows before it, late and for the types alike.
ROOMS = (
    ("geometry",),
    ("plans.words",),
    ("plans.model",),
    ("plans.techniques",),
    ("plans.scene", "plans.analytic"),
    ("plans.quantity",),
    ("plans.explanation",),
    ("plans.study",),
    ("plans.linkage",),
    ("plans.forces",),
    ("plans.gears",),
    (
        *("plans.dynamics", "plans.cyclogram", "plans.balance", "plans.diagrams"),
        *("plans.structure", "plans.transfer", "plans.centres"),
    ),
    ("plans.bank",),
    (ROADS,),
    ("plans.bench",),
    ("drawings.paper",),
    ("drawings.lettering", "drawings.reading"),
    ("drawings.page", "drawings.files", "drawings.pens", "drawings.sheet_diff"),
    ("drawings.layout", "drawings.report"),
    ("drawings.symbols",),
    ("drawings.checks", "drawings.kinds"),
    ("drawings.sheets", "drawings.diagrams"),
    ("drawings.linkage", "drawings.redrawn"),
    ("drawings.forces", "drawings.form"),
    ("drawings.dynamics",),
    ("drawings.cyclogram",),
    ("drawings.balance", "drawings.cam"),
    ("drawings.bank",),
    ("drawings.grading",),
    ("drawings.bench", "drawings.gallery", "drawings.pytest_plugin"),
    ("drawings.commands",),
)
ROWS = {room: row for row, rooms in enumerate(ROOMS) for room in rooms}
# A technique that no row names rests on no other: it stands beside the linkage, and is drawn beside the cyclogram.
ROWS = {f"plans.{name}": ROWS["plans.linkage"] for name in TECHNIQUES} | ROWS
ROWS = {f"drawings.{name}": ROWS["drawings.cyclogram"] for name in TECHNIQUES} | ROWS
# What still goes up: file and module, with the reason.
UPWARD = {("drawings/gallery/__main__.py", "drawings.commands.draw"): "the gallery is redrawn as a user would draw it"}


def module_of(path: str) -> str:
    return path.removesuffix(".py").removesuffix("/__init__").replace("/", ".")


def room_of(module: str) -> str | None:
    if any(within(module, one) for one in BOTH):
        return ROADS
    return next((room for room in ROWS if within(module, room)), None)


def upward(path: str, text: str) -> Iterator[tuple[str, str]]:
    """Give the imports of a file from a room that does not stand in a row below its own."""
    own = ROADS if path in OBJECTS else room_of(module_of(path))
    for module, _, late in parsed(text).imports:
        if path == CONTRACT and late:
            continue
        other = room_of(module)
        if own and other and own != other and ROWS[other] >= ROWS[own]:
            yield path, module


def known_to(path: str) -> set[str]:
    """Give our own files that a file imports, late and for the types alike."""
    known = parsed((ROOT / path).read_text("utf-8")).imports
    places = {module.replace(".", "/") for module, _, late in known if path != CONTRACT or not late}
    files = {file for place in places for file in (f"{place}.py", f"{place}/__init__.py") if file in FILES} - {path}
    # `from drawings.rotor import along` asks for a file of the folder, and not for what the folder itself says
    asked = {Path(file).parent for file in files if not file.endswith("__init__.py")}
    return {file for file in files if not file.endswith("__init__.py") or Path(file).parent not in asked}


def circles(knows: dict[str, set[str]]) -> set[str]:
    """Leave out, again and again, the files that know none of the others, and those that none knows."""
    while True:
        known = {file for others in knows.values() for file in others}
        left = {
            file: others & knows.keys() for file, others in knows.items() if others & knows.keys() and file in known
        }
        if left.keys() == knows.keys():
            return set(left)
        knows = left


@over("path", FILES)
def test_a_room_knows_only_the_rooms_below(path: str) -> None:
    found = upward(path, (ROOT / path).read_text("utf-8"))
    assert [one for one in found if not any(one[0] == file and within(one[1], module) for file, module in UPWARD)] == []


@pytest.mark.parametrize(("path", "module"), UPWARD)
def test_an_exception_that_is_no_longer_needed_is_taken_off(path: str, module: str) -> None:
    assert (path, module) in set(upward(path, (ROOT / path).read_text("utf-8")))


@pytest.mark.parametrize("path", OBJECTS)
def test_what_a_technique_is_asked_late_is_there(path: str) -> None:
    every = (call for call in parsed((ROOT / path).read_text("utf-8")).asked if isinstance(call, ast.Call))
    for first, *parts in (map(ast.literal_eval, call.args) for call in every if ast.unparse(call.func) == "late"):
        assert all(map(named, (f"{module_of(path)}.{first}", *(f"plans.{part}" for part in parts))))


def test_every_file_stands_in_a_room() -> None:
    halls = {"plans/__init__.py", "drawings/__init__.py"}
    assert {path for path in FILES if room_of(module_of(path)) is None} == halls


def test_no_file_knows_itself_again_through_others() -> None:
    assert circles({path: known_to(path) for path in FILES}) == set()


def test_a_circle_is_found() -> None:
    assert circles({"a": {"b"}, "b": {"c"}, "c": {"b", "d"}, "d": set()}) == {"b", "c"}
    assert circles({"a": {"b", "c"}, "b": {"c"}, "c": set()}) == set()


@pytest.mark.parametrize(
    ("path", "text"),
    [
        ("plans/model/motion.py", "from plans.scene.units import PI"),
        ("plans/scene/scene.py", "def f():\n    from plans.linkage.primary import CrankPositions"),
        ("plans/scene/scene.py", "from plans.analytic import closure"),
        ("plans/linkage/dyads.py", "if TYPE_CHECKING:\n    from plans.forces.cut import Cut"),
        ("plans/forces/cut.py", "from plans.forces import quantities"),
        ("drawings/paper/strokes.py", "def f():\n    from drawings.lettering.lettering import text_width"),
        ("drawings/layout/labels.py", "from drawings.symbols import arms"),
        ("drawings/linkage/guides.py", "from drawings.forces.acting import acting"),
        ("drawings/forces/sheet.py", "import drawings.commands.draw"),
        ("drawings/rotor/due.py", "from drawings.balance.due import due"),
    ],
)
def test_a_planted_import_from_above_is_seen(path: str, text: str) -> None:
    assert len(set(upward(path, text))) >= 1
