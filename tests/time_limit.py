"""A limit of time for what a test runs (предел времени)."""

from __future__ import annotations

import signal
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

AGAIN = 0.01  # seconds after which the alarm rings again: what rings while garbage is collected is not heard


@contextmanager
def limited(seconds: float, end: type[BaseException]) -> Iterator[None]:
    """End what takes longer than some seconds."""

    def ring(_signal: int, _frame: FrameType | None) -> None:
        raise end

    before = signal.signal(signal.SIGALRM, ring)
    signal.setitimer(signal.ITIMER_REAL, seconds, AGAIN)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
