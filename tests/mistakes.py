"""Mistakes that students make (ошибки студентов): the tables of tests/cases, by scene and by what the mistake is."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

CASES = Path(__file__).parent / "cases"


def mistakes(table: str) -> list[dict[str, Any]]:
    """Give the mistakes of a table, each with its name and its scene."""
    told = tomllib.loads((CASES / f"{table}.toml").read_text("utf-8"))
    return [{"name": name, "scene": scene, **row} for scene, rows in told.items() for name, row in rows.items()]
