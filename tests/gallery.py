"""The scenes of the gallery that tests go through: all of them, and those that have a linkage."""

from __future__ import annotations

from pathlib import Path

FOLDER = Path(__file__).parent.parent / "drawings" / "gallery"
SCENES = sorted(FOLDER.glob("*.toml"))
LINKAGES = [path for path in SCENES if "\n[mechanism" in path.read_text("utf-8")]
