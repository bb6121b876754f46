"""The start-up: a whole `plandraft draw` in a process of its own, beside what it cannot do without (холодный пуск)."""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

from plans.bench.clock import Times, interleaved

ROOT = Path(__file__).parent.parent.parent  # where the three packages are found, installed or not
DRAW = "import sys; from drawings.cli import main; sys.exit(main())"
IMPORTS = "import numpy, svgwrite"


def startup(scene: Path, rounds: int) -> tuple[Times, Times, Times]:
    """Time in turns: `plandraft draw` of a scene, `python` with numpy and svgwrite imported, `python` alone."""
    with tempfile.TemporaryDirectory(prefix="plandraft-bench-") as folder:
        commands = ([DRAW, "draw", os.fspath(scene.resolve()), "-o", folder], [IMPORTS], ["pass"])
        runs = [_process(*command) for command in commands]
        runs[0]()  # the first run of all fills the system's cache of files
        draw, imports, nothing = interleaved(runs, rounds, float("inf"))
    return draw, imports, nothing


def _process(*arguments: str) -> Callable[[], object]:
    paths = [os.fspath(ROOT), os.environ.get("PYTHONPATH", "")]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, paths))}
    command = [sys.executable, "-c", *arguments]
    return lambda: subprocess.run(command, env=environment, capture_output=True, check=False)
