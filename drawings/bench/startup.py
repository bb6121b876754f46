"""The start-up: a whole `plandraft draw` in a process of its own, beside what it cannot do without (холодный пуск)."""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

from plans.bench.trial import Times, interleaved

ROOT = Path(__file__).parent.parent.parent  # where the three packages are found, installed or not
DRAW = "from drawings.commands.process import run; run()"
MADE = 0, 4  # exit codes of what was drawn, whole or with gaps
IMPORTS = "import numpy, svgwrite"


def startup(scene: Path, rounds: int) -> tuple[Times, Times, Times]:
    """Time in turns: `plandraft draw` of a scene, `python` with numpy and svgwrite imported, `python` alone."""
    with tempfile.TemporaryDirectory(prefix="plandraft-bench-") as folder:
        commands = ([DRAW, "draw", os.fspath(scene.resolve()), "-o", folder], [IMPORTS], ["pass"])
        runs = [_process(folder, *command) for command in commands]
        # The first runs of all compile the modules, as installing them does, and fill the cache of files.
        for run in runs:
            run()
        draw, imports, nothing = interleaved(runs, rounds, float("inf"))
    return draw, imports, nothing


def _process(folder: str, *arguments: str) -> Callable[[], object]:
    paths = [os.fspath(ROOT), os.environ.get("PYTHONPATH", "")]
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    environment |= {"PYTHONPATH": os.pathsep.join(filter(None, paths)), "PYTHONPYCACHEPREFIX": folder}
    command = [sys.executable, "-c", *arguments]

    def run() -> None:
        ended = subprocess.run(command, env=environment, capture_output=True, check=False)
        if ended.returncode not in MADE:  # no time is told of a run that made nothing
            ended.check_returncode()

    return run
