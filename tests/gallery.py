"""Scenes of the gallery by what they have: those of linkages are studied by many tests."""

from __future__ import annotations

import tomllib
from pathlib import Path

FOLDER = Path(__file__).parents[1] / "drawings" / "gallery"
LINKAGES = [
    path for path in sorted(FOLDER.glob("*.toml")) if "mechanism" in tomllib.loads(path.read_text(encoding="utf-8"))
]
