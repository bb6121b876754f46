"""Layers: drawings rest on plans, plans on geometry, never the other way; each heavy library has its one place."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
TOPS = ("geometry", "plans", "drawings")
FILES = sorted(file.relative_to(ROOT).as_posix() for top in TOPS for file in (ROOT / top).rglob("*.py"))

EITHER = (
    "geometry",
    "plans.analytic",
    "plans.linkage.plan",
    "plans.linkage.drafts",
    "plans.linkage.study",
    "plans.linkage.extreme",
    "plans.scene.scene",
)
# Folder or file: what it must not import, anywhere in its text.
FORBIDDEN = {
    "geometry/": ("plans", "drawings"),
    "plans/": ("drawings",),
    "plans/analytic/": ("geometry.meet", "geometry.board", "geometry.replay", "geometry.precision"),
    # Loads are put on either road's motion.
    "plans/forces/loading.py": EITHER,
    "plans/forces/stroke.py": EITHER,
}
# all of plans that the analytic road may know
SHARED = (
    "plans.analytic",
    "plans.model.mechanism",
    "plans.model.motion",
    "plans.model.machine",
    "plans.model.kinetostatics",
    "plans.model.losses",
)
ONLY_IN = {
    "svgwrite": ("drawings/pens/svg.py", "drawings/bench/plain_pen.py"),  # the bench times its defaults beside our pen
    "mpmath": ("geometry/replay.py", "plans/bench/truth.py"),
    "matplotlib": ("drawings/bench/plot.py",),
    "pylinkage": ("plans/bench/peers.py",),
    "mechanism": ("plans/bench/peers.py",),
}
# Imported inside the function that needs them.
LATE = ("mpmath", "scipy", "shapely", "matplotlib", "numba", "pylinkage", "mechanism")


def within(module: str, package: str) -> bool:
    return module == package or module.startswith(f"{package}.")


def imports(node: ast.AST, late: bool = False) -> Iterator[tuple[str, int, bool]]:
    """Give the imports of a file: module, line, and whether it waits for a function or only serves the types."""
    for child in ast.iter_child_nodes(node):
        if isinstance(child, ast.Import):
            yield from ((name.name, child.lineno, late) for name in child.names)
        elif isinstance(child, ast.ImportFrom):
            yield "." * child.level + (child.module or ""), child.lineno, late
            # `from plans import group` imports a module as `import plans.group` does
            yield from ((f"{child.module}.{name.name}", child.lineno, late) for name in child.names if not child.level)
        else:
            types = isinstance(child, ast.If) and ast.unparse(child.test) == "TYPE_CHECKING"
            yield from imports(child, late or types or isinstance(child, ast.FunctionDef | ast.AsyncFunctionDef))


def faults(path: str, text: str) -> Iterator[str]:
    """Give the imports of a file that its place forbids."""
    for module, line, late in imports(ast.parse(text)):
        where = f"{path}:{line}: {module}"
        for folder, barred in FORBIDDEN.items():
            if path.startswith(folder) and any(within(module, package) for package in barred):
                yield f"{where} in {folder}"
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


@pytest.mark.parametrize("path", FILES)
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
        ("plans/analytic/closure.py", "from plans.linkage.groups.rrr import positions"),
        ("plans/analytic/closure.py", "from plans.linkage import velocity"),
        ("plans/analytic/friction.py", "from plans.forces.rubbing import lost"),
        ("plans/analytic/friction.py", "from plans.forces import locking, friction"),
        ("plans/forces/loading.py", "from plans.linkage.study import Study"),
        ("drawings/page/page.py", "import svgwrite"),
        ("drawings/pens/svg.py", "from .strokes import Line"),
        ("geometry/replay.py", "import mpmath"),
        ("plans/checks/compare.py", "def f():\n    import mpmath"),
        ("plans/linkage/study.py", "from scipy import integrate"),
        ("drawings/layout/labels.py", "class A:\n    from shapely.geometry import box"),
        ("drawings/report/report.py", "if True:\n    import matplotlib.pyplot"),
        ("drawings/report/report.py", "def f():\n    from matplotlib.figure import Figure"),
        ("drawings/bench/plot.py", "from matplotlib.figure import Figure"),
        ("plans/bench/peers.py", "import mechanism"),
        ("plans/bench/roads.py", "def f():\n    import pylinkage"),
        ("plans/bench/roads.py", "from drawings.bench import sheet"),
    ],
)
def test_a_planted_fault_is_seen(path: str, text: str) -> None:
    assert len(set(faults(path, text))) >= 1


@pytest.mark.parametrize(
    ("path", "text"),
    [
        ("geometry/replay.py", "if TYPE_CHECKING:\n    import mpmath"),
        ("geometry/replay.py", "def exact():\n    import mpmath"),
        (
            "plans/analytic/closure.py",
            "from plans.analytic.constraints import X\nfrom geometry.errors import DraftError",
        ),
        ("plans/analytic/closure.py", "from plans.model.mechanism import FRAME\nfrom plans.model.motion import Motion"),
        ("drawings/pens/svg.py", "import svgwrite\nfrom svgwrite import shapes"),
        ("drawings/layout/labels.py", "def f():\n    from shapely import geometry"),
        ("drawings/bench/plain_pen.py", "import svgwrite"),
        ("drawings/bench/plot.py", "def f():\n    from matplotlib.figure import Figure"),
        ("plans/bench/truth.py", "def f():\n    import mpmath"),
        ("drawings/report/report.py", "from plans.linkage.study import Study\nfrom geometry.board import at"),
    ],
)
def test_what_is_allowed_is_let_pass(path: str, text: str) -> None:
    assert list(faults(path, text)) == []
