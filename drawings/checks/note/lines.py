"""The lines of a chapter of a note (строки записки)."""

from __future__ import annotations


def part(text: str, head: str) -> list[str]:
    """Give the lines of a chapter by its head, up to the next chapter; none where there is no such chapter."""
    _, found, rest = text.partition(f"\n{head.strip().partition(chr(10))[0]}\n")
    own = rest.partition("\n## ")[0] if found else ""
    return [line for line in own.splitlines() if line.strip()]
