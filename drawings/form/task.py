"""What a form takes over from each kind of sheet (задание): the places of its figures, and the heads of its tables.

Whatever is not named here belongs to the answer, and is left out.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

PLAN, FRAME, GRAPH = "plan", "frame", "graph"  # a place with its pole; fixed points and guides too; bare axes

_LOADS: Final = {"load_diagram-": GRAPH}

# Of each kind of sheet: how the names of its figures begin, and what a form shows of them.
FIGURES: Final[Mapping[str, Mapping[str, str]]] = {
    "kinematics": {
        "positions": FRAME, "velocities-": PLAN, "accelerations-": PLAN,
        "diagrams-travel": GRAPH, "diagrams-velocity": GRAPH, "diagrams-acceleration": GRAPH,
    },
    "positions": {"positions": FRAME},
    "forces": {
        "scheme-": PLAN, "forces-": PLAN, "lever": PLAN, "balancing": GRAPH, "hodograph-": PLAN, **_LOADS,
    },
    "dynamics": {
        "moments": GRAPH, "works": GRAPH, "surplus": GRAPH, "speeds": GRAPH, "inertia": GRAPH, "loop": GRAPH,
        "before": GRAPH, "tachogram": GRAPH, **_LOADS,
    },
    "balancing": {
        "scheme-": PLAN, "static-moments": PLAN, "shaking": PLAN, "rocking": GRAPH, "moment": GRAPH, "share": GRAPH,
    },
    "bank": {
        "star": PLAN, "shaft": PLAN, "order_forces-": PLAN, "order_moments-": PLAN, "force_graph": GRAPH,
        "moment_graph": GRAPH, "force_hodograph": PLAN, "moment_hodograph": PLAN,
    },
    "rotor": {"across": PLAN, "along": PLAN, "unbalances": PLAN, "couples": PLAN},
    "cam": {"law-": GRAPH, "pressure": GRAPH, "sizes": PLAN, "profile": PLAN},
    "profile": {"manufacturing": PLAN},
    "cyclogram": {"characteristic": FRAME, "bars": GRAPH, "circle": PLAN},
}  # fmt: skip

# Of each kind of sheet: the names of its tables.
TABLES: Final[Mapping[str, tuple[str, ...]]] = {
    "kinematics": ("values", "output"),
    "forces": ("values",),
    "dynamics": ("positions", "reduction", "results"),
    "balancing": ("costs", "counterweights"),
    "bank": ("orders", "compensators", "results"),
    "rotor": ("masses", "results"),
    "cam": ("sizes", "results"),
    "profile": ("radii", "coordinates"),
    "cyclogram": ("stations",),
}


def figure_of(kind: str, name: str) -> str:
    """Tell what a form shows of a figure, or nothing where it is not known as a part of the task.

    >>> figure_of("kinematics", "velocities-4"), figure_of("forces", "detail-2-3-Z"), figure_of("cam", "law-1-velocity")
    ('plan', '', 'graph')
    """
    return next((shown for begin, shown in FIGURES.get(kind, {}).items() if name.startswith(begin)), "")


def table_of(kind: str, name: str) -> str:
    """Give the table that a band of a laid sheet, by its name, is of; nothing where that is no part of the task.

    >>> table_of("kinematics", "values-2"), table_of("kinematics", "velocities-2")
    ('values', '')
    """
    table, _, number = name.rpartition("-")
    return table if number.isdigit() and table in TABLES.get(kind, ()) else ""
