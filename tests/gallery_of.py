"""The gallery's scenes by technique: a test of linkages asks for those that have one."""

from __future__ import annotations

import tomllib
from pathlib import Path

from plans.scene.demand import techniques_of

GALLERY = Path(__file__).parent.parent / "drawings" / "gallery"


def gallery_of(technique: str) -> list[Path]:
    """Give the scenes of the gallery that have a part in a technique."""
    scenes = sorted(GALLERY.glob("*.toml"))
    return [path for path in scenes if technique in techniques_of(tomllib.loads(path.read_text("utf-8")))]
