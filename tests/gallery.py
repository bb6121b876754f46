"""The scenes of the gallery, by what they study: tests of linkages look at linkages alone."""

from __future__ import annotations

import tomllib
from pathlib import Path

GALLERY = Path(__file__).parents[1] / "drawings" / "gallery"
SCENES = sorted(GALLERY.glob("*.toml"))
LINKAGES = [path for path in SCENES if "mechanism" in tomllib.loads(path.read_text(encoding="utf-8"))]
