"""The scenes of the gallery, by what they study: tests of linkages look at linkages alone."""

from __future__ import annotations

import tomllib
from pathlib import Path

GALLERY = Path(__file__).parents[1] / "drawings" / "gallery"
SCENES = sorted(GALLERY.glob("*.toml"))
SHEETS = {"kinematics", "positions", "forces"}  # that show plans of a linkage


def _shows_a_linkage(path: Path) -> bool:
    data = tomllib.loads(path.read_text(encoding="utf-8"))
    return "mechanism" in data and not SHEETS.isdisjoint(data.get("sheets", SHEETS))


LINKAGES = [path for path in SCENES if _shows_a_linkage(path)]
STROKES = [path for path in LINKAGES if "[drive.stroke]" in path.read_text(encoding="utf-8")]  # they do not come round
TURNING = [path for path in LINKAGES if path not in STROKES]
