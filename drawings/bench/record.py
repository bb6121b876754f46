"""A bench kept as data: one line of a CSV file for each row, or the whole as JSON (протокол испытания)."""

from __future__ import annotations

import csv
import io
import json
from dataclasses import asdict
from typing import Any

from plans.bench.clock import Times
from plans.bench.result import Bench, Ratio, Row
from plans.bench.truth import KINDS

# The machine stands in every line, so that files of several machines can be laid together.
COLUMNS = (
    "scene", "technique", "positions", "of", "error", "error_95", "worst", "accepted",
    *(f"error_{kind}" for kind in KINDS), "repetitions", "median_s", "quartile_1_s", "quartile_3_s", "least_s",
    "position_s", "note",
    "processor", "cores", "load", "system", "python", "numpy",
)  # fmt: skip
FORMULA = ("=", "+", "-", "@", "\t", "\r")


def csv_bytes(bench: Bench) -> bytes:
    """Write the rows as CSV (UTF-8, comma, point), empty where there is nothing to say."""
    text = io.StringIO(newline="")
    writer = csv.DictWriter(text, COLUMNS, lineterminator="\n")
    writer.writeheader()
    for row in bench.rows:
        told = {"scene": bench.title, **_row(row, bench.accepted), **asdict(bench.machine)}
        writer.writerow({column: _as_text(value) for column, value in told.items()})
    return text.getvalue().encode("utf-8")


def _as_text(value: Any) -> Any:
    """Mark a text that a table program would take for a formula."""
    return f"'{value}" if isinstance(value, str) and value.startswith(FORMULA) else value


def json_text(bench: Bench) -> str:
    """Write the whole bench as JSON, null where there is nothing to say."""
    told = {
        "scene": bench.title,
        "machine": asdict(bench.machine),
        "words": list(bench.words),
        "accepted": bench.accepted,
        "rows": [_row(row, bench.accepted) for row in bench.rows],
        "ratios": [_ratio(ratio) for ratio in bench.ratios],
    }
    return json.dumps(told, allow_nan=False, ensure_ascii=False)


def _row(row: Row, accepted: float) -> dict[str, Any]:
    kinds = row.errors.kinds if row.errors else {}
    return {
        "technique": row.technique, "positions": row.positions, "of": row.of, "error": _finite(row.error),
        "error_95": row.often, "worst": row.errors.worst if row.errors else None,
        "accepted": None if row.error is None else bool(row.error <= accepted),
        **{f"error_{kind}": _finite(kinds.get(kind)) for kind in KINDS},
        **_times(row.times), "position_s": row.each, "note": row.note,
    }  # fmt: skip


def _finite(error: float | None) -> float | str | None:
    """A value that should be there and is not is infinitely wrong; JSON has no number for it."""
    return "infinite" if error == float("inf") else error


def _times(times: Times | None) -> dict[str, Any]:
    low, high = times.quartiles if times else (None, None)
    return {
        "repetitions": len(times.seconds) if times else 0, "median_s": times.median if times else None,
        "quartile_1_s": low, "quartile_3_s": high, "least_s": times.least if times else None,
    }  # fmt: skip


def _ratio(ratio: Ratio) -> dict[str, Any]:
    times, goal = ratio.times, ratio.goal
    low, high = times.quartiles if times else (None, None)
    return {
        "name": ratio.name, "positions": ratio.positions, "ratio": times.median if times else None,
        "quartile_1": low, "quartile_3": high, "rounds": len(times.seconds) if times else 0,
        "goal": goal.bound if goal else None, "at_least": goal.least if goal else None, "reached": ratio.reached,
        "note": ratio.note,
    }  # fmt: skip
