"""The table of many trials: how many ended how, and which of them fail (сводка испытаний)."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence

from tests.trials.trial import DRAWN, FAULTS, GAPS, KINDS, NEAR, REFUSED, SLOW, TRACEBACK, WITHHELD, Verdict

OUTCOMES = (DRAWN, NEAR, GAPS, REFUSED, WITHHELD, TRACEBACK, SLOW)
WIDTH = max(map(len, (*OUTCOMES, *FAULTS))) + 2


def table(verdicts: Sequence[Verdict]) -> str:
    """Count outcomes and faults by kind of scene, and refusals by their reason."""
    kinds = [kind for kind in KINDS if any(verdict.kind == kind for verdict in verdicts)]
    outcomes = Counter((verdict.outcome, verdict.kind) for verdict in verdicts)
    faults = Counter((fault, v.kind) for v in verdicts for fault in {fault for fault, _ in v.faults})
    totals = Counter(verdict.kind for verdict in verdicts)
    lines = [_row("", kinds), _row("scenes", [totals[kind] for kind in kinds])]
    lines += [_row(name, [outcomes[name, kind] for kind in kinds]) for name in OUTCOMES]
    lines += ["what must not be, in scenes:"]
    lines += [_row(name, [faults[name, kind] for kind in kinds]) for name in FAULTS]
    lines += ["refused, drawn with gaps:", *_reasons(verdicts, (REFUSED, GAPS))]
    return "\n".join(lines)


def _row(name: str, cells: Sequence[object]) -> str:
    return f"{name:<{WIDTH}}" + "".join(f"{cell!s:>15}" for cell in cells)


def _reasons(verdicts: Sequence[Verdict], outcomes: tuple[str, ...]) -> Iterator[str]:
    reasons = Counter((v.kind, v.outcome, v.reason) for v in verdicts if v.outcome in outcomes)
    for (kind, outcome, reason), count in sorted(reasons.items(), key=lambda item: (item[0][0], -item[1])):
        yield f"  {count:>5} {kind}: {outcome}: {reason}"


def failing(verdicts: Sequence[Verdict]) -> Iterator[str]:
    """Name the scenes that fail, fault by fault, each with its first particulars."""
    for name in FAULTS:
        own = [(v, [told for fault, told in v.faults if fault == name]) for v in verdicts]
        own = [(verdict, told) for verdict, told in own if told]
        if own:
            yield f"{name}: {len(own)}"
        for verdict, told in own:
            more = f" (and {len(told) - 1} more)" if len(told) > 1 else ""
            yield f"  --kind {verdict.kind} --only {verdict.number}: {told[0]}{more}"
