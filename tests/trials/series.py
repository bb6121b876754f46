"""A series of trials, shared between the processor's cores (серия испытаний)."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from multiprocessing import get_context

from tests.trials.judgement import Judgement, judged
from tests.trials.trial import KINDS, Verdict, tried

WORKERS = 2
CHUNK = 20  # scenes handed to a worker at once


def trials(kinds: Sequence[str], share: int = 1, draw: bool = False, only: int | None = None) -> Iterator[Verdict]:
    """Try every `share`-th scene of some kinds, or one by its number."""
    numbers = {kind: range(0, KINDS[kind][1], share) if only is None else [only] for kind in kinds}
    cases = [(kind, number, draw) for kind in kinds for number in numbers[kind]]
    if len(cases) == 1:
        yield tried(*cases[0])
        return
    with get_context("spawn").Pool(WORKERS) as pool:
        for count, verdict in enumerate(pool.imap(_tried, cases, CHUNK), 1):
            _progress(count, len(cases))
            yield verdict


def _tried(case: tuple[str, int, bool]) -> Verdict:
    return tried(*case)


def judgements(kinds: Sequence[str], count: int, only: int | None = None) -> Iterator[Judgement]:
    """Judge so many scenes of each kind, spread over all, or one by its number."""
    spread = {kind: range(0, KINDS[kind][1], max(1, KINDS[kind][1] // count)) for kind in kinds}
    cases = [(kind, number) for kind in kinds for number in (spread[kind][:count] if only is None else [only])]
    with get_context("spawn").Pool(WORKERS) as pool:
        for done, found in enumerate(pool.imap(_judged, cases, CHUNK), 1):
            _progress(done, len(cases))
            yield from found


def _judged(case: tuple[str, int]) -> list[Judgement]:
    return judged(*case)


def _progress(count: int, of: int) -> None:
    if sys.stderr.isatty() or count % 1000 == 0:
        print(f"\r{count} of {of}", end="" if count < of else "\n", file=sys.stderr, flush=True)
