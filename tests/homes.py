"""Assemblies from the sketch kept within a worker: of two tests of one mechanism the second finds it assembled.

They are kept here and not in the program: its bench times that road. A run on a planted fault, whose packages are
imported afresh, keeps assemblies of its own.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from functools import wraps
from typing import Any

ASKED_BY = ("kinematics", "extremes", "cyclogram")  # files of plans/analytic that assemble from the sketch


def keep() -> None:
    """Keep assemblies from now on, in the packages that are imported."""
    asking = [module for file in ASKED_BY if (module := sys.modules.get(f"plans.analytic.{file}"))]
    if asking:
        kept = _kept(asking[0].home)
        for module in asking:
            module.home = kept


def _kept(home: Callable[..., Any]) -> Callable[..., Any]:
    """Remember assemblies by all that tells one mechanism, its first angle and the others from the next."""
    known: dict[tuple[str, float | None, bytes], Any] = {}

    @wraps(home)
    def remembered(shape: Any, first: float | None, looks: Any) -> Any:
        key = (repr(shape.mechanism), first, looks.tobytes())
        if key not in known:
            known[key] = home(shape, first, looks)
            if known[key] is not None:
                known[key].poses.setflags(write=False)  # one is handed to many
        return known[key]

    return remembered
