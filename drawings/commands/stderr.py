"""What is said on stderr, and how a run ends whose own files fail it (сообщения об ошибках)."""

from __future__ import annotations

import contextlib
import sys

FILES = 7
UNREADABLE = "plandraft itself cannot be read: {error}. Fix: install it again"


def tell(message: str) -> None:
    """Say a message on stderr; where nobody can hear it, the work goes on, and the exit code tells how it ended."""
    with contextlib.suppress(OSError, ValueError):
        print(message, file=sys.stderr)
