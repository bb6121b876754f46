"""What is kept in a worker: assemblies, marches from them, composed sheets. Tests of one mechanism or sheet share them.

They are kept here and not in the program: its bench times these roads. A run on a planted fault, whose packages are
imported afresh, keeps its own.
"""

from __future__ import annotations

import pickle
import sys
from collections.abc import Callable, Hashable
from functools import wraps
from typing import Any

import numpy as np

# What is kept: the function of plans/analytic, and the files there that ask for it.
KEPT = {"home": ("kinematics", "extremes", "cyclogram"), "survey": ("positions",)}

COMPOSED = ("drawings/layout/", "drawings/lettering/", "drawings/page/", "drawings/paper/")  # what composes a sheet

changed = ""  # the fault that is planted into what composes a sheet


def keep() -> None:
    """Keep assemblies and marches from now on, in the packages that are imported."""
    for name, files in KEPT.items():
        for asking in [sys.modules[file] for file in map("plans.analytic.{}".format, files) if file in sys.modules]:
            if not hasattr(getattr(asking, name), "__wrapped__"):
                setattr(asking, name, _kept(getattr(asking, name)))
    leaves = sys.modules.get("drawings.sheets.leaves")
    if leaves is not None and not hasattr(leaves.compose, "__wrapped__"):
        leaves.compose = _composed(leaves.compose)  # type: ignore[attr-defined]


def _composed(compose: Callable[..., Any]) -> Callable[..., Any]:
    """Remember where all stands by all that is shown, and by the fault that is planted."""
    known: dict[Hashable, Any] = {}

    @wraps(compose)
    def remembered(contents: Any, page: Any, cuts: Any) -> Any:
        key = pickle.dumps((contents, page)), changed
        if key not in known:
            known[key] = compose(contents, page, cuts)
        return known[key]

    return remembered


def _kept(asked: Callable[..., Any]) -> Callable[..., Any]:
    """Remember answers by all that tells one mechanism and what is asked of it from the next."""
    known: dict[Hashable, Any] = {}

    @wraps(asked)
    def remembered(shape: Any, *given: Any) -> Any:
        key = (repr(shape.mechanism), *map(_told, given))
        if key not in known:
            known[key] = asked(shape, *given), shape  # kept: were it told by its place alone, another could come there
            if hasattr(known[key][0], "poses"):
                known[key][0].poses.setflags(write=False)  # one is handed to many
        return known[key][0]

    return remembered


def _told(given: Any) -> Hashable:
    """Tell what is given to the last bit: arrays, and pairs with an array."""
    if isinstance(given, tuple):
        return tuple(map(_told, given))
    return given.tobytes() if isinstance(given, np.ndarray) else given
