"""The process that is the command plandraft: its signals and streams, from the first moment, and how it ends."""

from __future__ import annotations

import contextlib
import gc
import os
import signal
import sys
from typing import NoReturn

from drawings.commands.stderr import FILES, UNREADABLE, tell
from drawings.files.signals import ENDING, Stopped, raise_signals

COLLECTED = 1_000_000  # new objects between two collections: a sheet makes fewer, and hardly any of them in rings
STREAMS = 3  # stdin, stdout, stderr


def run() -> NoReturn:
    """Be the command plandraft: a process that ends with it, and so need not be tidied up after it."""
    for number in ENDING:
        if signal.getsignal(number) != signal.SIG_IGN:
            signal.signal(number, lambda which, _: os._exit(128 + which))  # there is nothing yet to tidy up
    # Closed streams are kept from being opened as something else: a note to stderr would go into a sheet.
    while (handle := os.open(os.devnull, os.O_RDWR)) < STREAMS:
        pass
    os.close(handle)
    if sys.stderr is None:
        sys.stderr = open(os.devnull, "w", encoding="utf-8")  # noqa: SIM115, PTH123  (open as long as the process is)
    # Our matrices are small: a second thread of the linear algebra would cost more than it does.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    gc.set_threshold(COLLECTED)
    code = _code()
    for stream in (sys.stdout, sys.stderr):
        with contextlib.suppress(AttributeError, OSError, ValueError):  # closed, or none from the beginning
            stream.flush()
    os._exit(code)


def _code() -> int:
    try:
        from drawings.commands import cli  # its imports take most of the time in which Ctrl-C may come
    except (ImportError, OSError) as error:
        tell(UNREADABLE.format(error=error))
        return FILES
    try:
        raise_signals()
        return cli.main()
    except Stopped as stopped:
        return stopped.exit_code
    finally:
        for number in ENDING:  # there is nothing left to stop
            signal.signal(number, signal.SIG_IGN)


if __name__ == "__main__":
    run()
