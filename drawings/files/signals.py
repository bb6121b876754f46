"""Signals that end a run: it is tidied up first, and what must be done wholly is (сигналы)."""

from __future__ import annotations

import contextlib
import signal
from collections.abc import Iterator
from types import FrameType

NAMES = ("SIGINT", "SIGTERM", "SIGHUP")  # SIGHUP is unknown to Windows
ENDING = tuple(getattr(signal, name) for name in NAMES if hasattr(signal, name))


class Stopped(BaseException):
    """The run was told to end; `exit_code` is 128 and the number of the signal, as the shell says it."""

    def __init__(self, number: int) -> None:
        super().__init__(number)
        self.exit_code = 128 + number


def raise_signals() -> None:
    """From now on let a signal end the run by an exception; those after the first do not disturb the tidying up."""
    for number in _heard():
        signal.signal(number, _stop)


def _stop(number: int, _: FrameType | None) -> None:
    for other in ENDING:
        signal.signal(other, signal.SIG_IGN)
    raise Stopped(number)


@contextlib.contextmanager
def unstopped() -> Iterator[None]:
    """Let signals wait until the block has ended: what it does is done wholly, and in a moment."""
    waiting: list[int] = []
    try:
        before = {number: signal.signal(number, lambda which, _: waiting.append(which)) for number in _heard()}
    except ValueError:  # another thread than the first: signals do not come here
        before = {}
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
        for which in waiting[:1]:
            signal.raise_signal(which)


def _heard() -> list[signal.Signals]:
    """Give the signals that are not ignored: nohup and shells in the background ask for that."""
    return [number for number in ENDING if signal.getsignal(number) not in (signal.SIG_IGN, None)]
