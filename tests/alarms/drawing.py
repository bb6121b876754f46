"""A scene is drawn as a user draws it, and what comes of that is told: drawn, refused, withheld, crashed."""

from __future__ import annotations

import contextlib
import io
import tempfile
import time
from collections.abc import Iterator, Sequence
from multiprocessing import get_context
from pathlib import Path
from typing import NamedTuple

from drawings.commands import cli
from tests.time_limit import limited

WHOLE, REMARKED, REFUSED, WITHHELD, CRASHED, SLOW = (
    "drawn",
    "with remarks",
    "refused",
    "withheld",
    "crashed",
    "too slow",
)
OUTCOMES = (WHOLE, REMARKED, REFUSED, WITHHELD, CRASHED, SLOW)
CODES = {0: WHOLE, 4: REMARKED, 3: REFUSED, 8: REFUSED, 5: WITHHELD}
DRAWN = (WHOLE, REMARKED)
ALARMS = (WITHHELD, CRASHED, SLOW)
SCENES = 40  # that a process draws before another takes its place: what is kept between them grows
LONGEST = 240.0  # s: a scene that takes longer is told as too slow


class Outcome(NamedTuple):
    """What came of a scene: its name and text, the outcome with its particulars, and how long it took, s."""

    name: str
    text: str
    outcome: str
    told: str
    seconds: float

    @property
    def alarm(self) -> bool:
        """Whether this must not be."""
        return self.outcome in ALARMS


class _TooSlow(BaseException):
    """A scene took too long: no handler of the command's own may take it for a bug."""


def drawings(scenes: Sequence[tuple[str, str]], workers: int) -> Iterator[Outcome]:
    """Draw scenes, each by its name and text, shared between processes."""
    if workers < 2 or len(scenes) < 2:
        yield from map(drawing, scenes)
        return
    with get_context("spawn").Pool(workers, maxtasksperchild=SCENES) as pool:
        yield from pool.imap_unordered(drawing, scenes)


def drawing(scene_of: tuple[str, str]) -> Outcome:
    """Draw a scene into a folder that is thrown away, with the self-check whole."""
    name, text = scene_of
    began, told = time.monotonic(), io.StringIO()
    with tempfile.TemporaryDirectory() as folder:
        scene = Path(folder) / f"{name}.toml"
        scene.write_text(text, encoding="utf-8")
        try:
            with (
                limited(LONGEST, _TooSlow),
                contextlib.redirect_stderr(told),
                contextlib.redirect_stdout(io.StringIO()),
            ):
                code = cli.main(["draw", str(scene), "-o", str(Path(folder) / "out")])
            outcome = CODES.get(code, CRASHED)
        except _TooSlow:
            outcome = SLOW
    lines = told.getvalue().replace(f"{scene}:", "").strip()
    return Outcome(name, text, outcome, lines, time.monotonic() - began)
