"""Disturbed runs: plandraft draws in processes of their own, in which a call to the system fails or ends them."""

from __future__ import annotations

import contextlib
import io
import os
import shutil
import signal
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from drawings.commands import cli
from drawings.commands.draw import draw
from drawings.files.atomic_files import PREFIX

CALLS = (
    *("open", "read", "write", "fsync", "close", "fstat", "fchmod", "stat", "lstat", "readlink", "scandir"),
    *("mkdir", "rmdir", "link", "rename", "replace", "unlink"),
)
PLAIN = Path(__file__).parent / "plain.toml"
LOADED = '\nspeed = "10 rad/s"', '\nspeed = "11 rad/s"'
BOTH = 'title = "Crank-rocker"', 'title = "Crank-rocker"\nsheets = ["forces", "kinematics"]'
FORCES = '\n[masses]\n3 = { mass = 2, inertia = 0.1, centre = "middle" }\n'

Files = dict[str, bytes]


class Outcome(NamedTuple):
    """How a run ended: its exit code (negative: killed by that signal), and what it said on stderr."""

    code: int
    told: str


class Shim:
    """Stands before the system's calls, counts them, and does something instead of one of them."""

    def __init__(self, number: int, instead: Callable[[], None], calls: Sequence[str] = CALLS) -> None:
        self.count, self.number, self.instead = 0, number, instead
        for name in calls:
            setattr(os, name, self._watched(name, getattr(os, name)))

    def _watched(self, name: str, real: Callable[..., Any]) -> Callable[..., Any]:
        def call(*arguments: Any, **options: Any) -> Any:
            self.count += 1
            if self.count == self.number:
                if name == "close":  # a file whose closing tells of an error is closed all the same
                    real(*arguments)
                self.instead()
            return real(*arguments, **options)

        return call


class Bench:
    """A folder of scenes; sets are drawn from them by runs that may be disturbed."""

    def __init__(self, work: Path) -> None:
        text = PLAIN.read_text("utf-8") + "positions = 2\n"  # soon drawn
        self.work, self.out = work, work / "out"
        self.scenes = {
            "old": text,
            "new": text.replace(*LOADED),
            "more": text.replace('title = "Crank-rocker"', 'title = "Rocker"\nsheets = ["forces", "kinematics"]')
            + FORCES,
        }
        self.sets: dict[str, Files] = {}
        for name, content in self.scenes.items():
            (work / name).mkdir()
            self.scene(name).write_text(content, "utf-8")
        self.other = work / "other.toml"
        self.other.write_text(text, "utf-8")
        with contextlib.redirect_stdout(io.StringIO()):  # what is imported here, no run need import again
            draw(self.scene("more"), self.out)

    def scene(self, name: str) -> Path:
        return self.work / name / "rocker.toml"

    def start(self, scene: Path, disturb: Callable[[], Shim | None] = lambda: None) -> int:
        """Start a run in a process of its own, disturbed from its beginning; give the process."""
        child = os.fork()
        if child:
            return child
        for stream, name in ((1, "stdout"), (2, "stderr")):
            os.dup2(os.open(self.work / f"{name}-{os.getpid()}", os.O_CREAT | os.O_WRONLY), stream)
        shim = disturb()
        code = cli.main(["draw", str(scene), "-o", str(self.out)])
        sys.stderr.flush()
        if shim is not None:
            (self.work / "count").write_text(str(shim.count))
        os._exit(code)

    def end(self, child: int) -> Outcome:
        """Wait for a run."""
        code = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
        told = (self.work / f"stderr-{child}").read_text("utf-8") if code != -signal.SIGKILL else ""
        for stream in ("stdout", "stderr"):
            (self.work / f"{stream}-{child}").unlink(missing_ok=True)
        return Outcome(code, told)

    def run(self, scene: Path, disturb: Callable[[], Shim | None] = lambda: None) -> Outcome:
        """Run to the end."""
        return self.end(self.start(scene, disturb))

    def set_out(self, before: Path | None) -> None:
        shutil.rmtree(self.out, ignore_errors=True)
        if before is not None:
            shutil.copytree(before, self.out)

    def seen(self) -> Files:
        """Give the files of the set in the folder, without temporary ones and those of the other scene."""
        files = self.out.iterdir() if self.out.exists() else ()
        return {path.name: path.read_bytes() for path in files if path.name.startswith("rocker-")}

    def orphans(self) -> int:
        return len(list(self.out.glob(f"{PREFIX}*"))) if self.out.exists() else 0
