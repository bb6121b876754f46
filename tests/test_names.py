"""Names: a class is called after what it is, so that no name means two things (имена)."""

import ast
from collections import defaultdict
from pathlib import Path

ROOT = Path(__file__).parents[1]
# A line and an arc of a construction, without ends, and as strokes of a pen: a message calls either by its plain word.
PAIRS = {"Arc", "Line"}


def test_no_two_classes_have_one_name() -> None:
    homes = defaultdict(list)
    for top in ("geometry", "plans", "drawings"):
        for path in sorted((ROOT / top).rglob("*.py")):
            for node in ast.walk(ast.parse(path.read_text("utf-8"))):
                if isinstance(node, ast.ClassDef):
                    homes[node.name.lstrip("_")].append(path.relative_to(ROOT).as_posix())
    assert {name: places for name, places in homes.items() if len(places) > 1 and name not in PAIRS} == {}
