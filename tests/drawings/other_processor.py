"""Lays out sheets as a processor would that rounds sines and roots otherwise: its last bits are turned up or down.

Run as `python -m tests.drawings.other_processor up FOLDER SCENE...`; `up-exact` lets ties hang on the last bit.
"""

from __future__ import annotations

import cmath
import math
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

BIT = {"up": 1 + 2.0**-52, "down": 1 - 2.0**-52}
# What processors and libraries round each in their way; sums, products and roots of numbers are alike everywhere.
FUNCTIONS = {
    math: ("sin", "cos", "tan", "asin", "acos", "atan", "atan2", "hypot", "exp", "log", "log10"),
    cmath: ("rect", "phase", "exp", "sqrt"),
    np: ("sin", "cos", "tan", "arcsin", "arccos", "arctan2", "hypot", "exp", "angle", "abs"),
    np.linalg: ("solve", "det", "norm"),
}


def turned(value: Any, by: float) -> Any:
    """Turn the last bit of a number, or of numbers, that are not whole."""
    if np.iscomplexobj(value):
        found = turned(np.real(value), by) + 1j * turned(np.imag(value), by)
        return found if isinstance(value, np.ndarray) else complex(found)
    if isinstance(value, np.ndarray) and value.dtype == float:
        return np.where(value == np.round(value), value, value * by)
    return value * by if isinstance(value, float) and math.isfinite(value) and value != round(value) else value


def rounding(function: Callable[..., Any], by: float) -> Callable[..., Any]:
    return lambda *given, **named: turned(function(*given, **named), by)


def sheets(scene: Path) -> Iterator[tuple[str, bytes]]:
    """Lay out the sheets of a scene, their texts left to the viewer's fonts; give each with its file's name."""
    from drawings.files.sheet_set import placed_sheets, stem_of
    from drawings.pens.svg import svg
    from drawings.sheets.documents import leaves_of
    from plans.scene.scene import read_scene
    from plans.study import Study

    study = Study(read_scene(scene))
    study.construct()
    for path, (_, leaf) in placed_sheets(Path(), stem_of(study.scene), leaves_of(study)):
        yield path.name, svg(leaf)


def main(way: str, folder: str, *scenes: str) -> None:
    direction, _, exact = way.partition("-")
    if exact:
        from drawings.paper import walk

        walk.PLACES = 17
    for module, names in FUNCTIONS.items():
        for name in names:
            setattr(module, name, rounding(getattr(module, name), BIT[direction]))
    for scene in scenes:
        for name, content in sheets(Path(scene)):
            (Path(folder) / name).write_bytes(content)


if __name__ == "__main__":
    main(*sys.argv[1:])
