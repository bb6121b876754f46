"""A bench reported: as text with goals and verdicts, as CSV and as JSON (протокол испытания)."""

from __future__ import annotations

import csv
import io
import json
import math
import textwrap
from collections.abc import Iterator
from dataclasses import asdict, fields
from typing import Any

from plans.bench.trial import Bench, Computer, Errors, Ratio, Timed, Times

WIDTH = 118
MANY = 1e6  # roundings: so many are no measure of rounding
_UNITS = ((1.0, "s"), (1e-3, "ms"), (1e-6, "us"), (1e-9, "ns"))


def written(bench: Bench) -> str:
    """Write a bench for a terminal."""
    lines = [f"{bench.title}: error against run time", f"machine: {bench.machine.written()}", ""]
    for word in bench.words:
        lines += textwrap.wrap(word, WIDTH, subsequent_indent="  ")
    for count in dict.fromkeys(row.positions for row in bench.rows):
        lines += ["", *_rows([row for row in bench.rows if row.positions == count], count, bench.accepted)]
    return "\n".join([*lines, "", *_ratios(bench.ratios)])


def _rows(rows: list[Timed], count: int | None, accepted: float) -> Iterator[str]:
    title = "any number of positions" if count is None else f"{count} positions"
    yield _line(title, "worst, %", "median, %", "roundings", "accepted", _timing("one run", "(quartiles)", "times"))
    for row in rows:
        found, timing = row.errors, ""
        if row.times:
            spread = " ... ".join(seconds(time) for time in row.times.quartiles)
            each = f"{seconds(row.each)} a position" if row.each and row.positions else ""
            timing = _timing(seconds(row.times.median), f"({spread})", str(len(row.times.seconds)), each)
        note = "; ".join(filter(None, (f"of {row.of} positions" if row.of else "", _worst(found), row.note)))
        if found is None:
            yield f"{_line(row.technique, '', '', '', '', timing)} {note}".rstrip()
        else:
            worst, typical = f"{100 * found.worst:.1e}", f"{100 * found.typical:.1e}"
            few = short(found.roundings) if found.roundings < MANY else ""
            verdict = "yes" if found.worst <= accepted else "no"
            yield f"{_line(row.technique, worst, typical, few, verdict, timing)} {note}".rstrip()


def _line(technique: str, worst: str, typical: str, roundings: str, accepted: str, timing: str) -> str:
    return f"{technique:<32} {worst:>8} {typical:>9} {roundings:>9} {accepted:<8} {timing}"


def _timing(run: str, spread: str, times: str, each: str = "") -> str:
    return f"{run:>9} {spread:<23} {times:>5} {each:<18}"


def _worst(found: Errors | None) -> str:
    return f"worst in {found.name}" if found and found.name else ""


def _ratios(ratios: tuple[Ratio, ...]) -> Iterator[str]:
    yield _ratio("ratios of times, side by side", "positions", ("times", "ratio", "(quartiles)"), "goal", "reached")
    for ratio in ratios:
        goal = f"{'>=' if ratio.goal.least else '<='} {ratio.goal.bound:g}" if ratio.goal else ""
        verdict = {None: ratio.note, True: "yes", False: "no"}[ratio.reached]
        yield _ratio(ratio.name, str(ratio.positions or ""), _measured(ratio), goal, verdict)


def _measured(ratio: Ratio) -> tuple[str, str, str]:
    if not (ratio.times and ratio.first and ratio.second):
        return "", "", ""
    low, high = ratio.times.quartiles
    both = f"{seconds(ratio.first.median)}, {seconds(ratio.second.median)}"
    return both, short(ratio.times.median), f"({short(low)} ... {short(high)})"


def _ratio(name: str, positions: str, measured: tuple[str, str, str], goal: str, verdict: str) -> str:
    times, ratio, spread = measured
    return f"{name:<62} {positions:>9} {times:>17} {ratio:>7} {spread:<17} {goal:<8} {verdict}".rstrip()


def seconds(time: float) -> str:
    """Write a time with three digits and its unit.

    >>> seconds(0.0123), seconds(5.6e-8), seconds(2.5), seconds(0.00099999)
    ('12.3 ms', '56 ns', '2.5 s', '1000 us')
    """
    size, unit = next(((size, unit) for size, unit in _UNITS if time >= size), _UNITS[-1])
    return f"{short(time / size)} {unit}"


def short(number: float) -> str:
    """Write a number with three digits, without an exponent.

    >>> short(12.345), short(0.4567), short(1234.5), short(8.0)
    ('12.3', '0.457', '1234', '8')
    """
    if number == 0 or not math.isfinite(number):
        return f"{number:g}"
    places = max(2 - math.floor(math.log10(abs(number))), 0)
    text = f"{number:.{places}f}"
    return text.rstrip("0").rstrip(".") if "." in text else text


FORMULA = ("=", "+", "-", "@", "\t", "\r")


def csv_bytes(bench: Bench) -> bytes:
    """Write the rows as CSV (UTF-8, comma, point), empty where there is nothing to say."""
    text = io.StringIO(newline="")
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(COLUMNS)
    for row in bench.rows:
        values = (bench.title, *_row(row, bench.accepted).values(), *asdict(bench.machine).values())
        writer.writerow(map(_as_text, values))
    return text.getvalue().encode("utf-8")


def _as_text(value: Any) -> Any:
    return f"'{value}" if isinstance(value, str) and value.startswith(FORMULA) else value


def json_text(bench: Bench) -> str:
    """Write the whole bench as JSON, null where there is nothing to say."""
    data = {
        "scene": bench.title,
        "machine": asdict(bench.machine),
        "words": list(bench.words),
        "accepted": bench.accepted,
        "rows": [_row(row, bench.accepted) for row in bench.rows],
        "ratios": [_held(ratio) for ratio in bench.ratios],
    }
    return json.dumps(data, allow_nan=False, ensure_ascii=False)


def _row(row: Timed, accepted: float) -> dict[str, Any]:
    found = row.errors
    return {
        "technique": row.technique, "positions": row.positions, "of": row.of,
        "error": _finite(found and found.worst), "typical": _finite(found and found.typical),
        "roundings": _finite(found and found.roundings), "worst": found.name if found else None,
        "accepted": None if found is None else bool(found.worst <= accepted),
        **_times(row.times), "position_s": row.each, "note": row.note,
    }  # fmt: skip


def _finite(error: float | None) -> float | str | None:
    """A value that should be there and is not is infinitely wrong; JSON has no number for it."""
    return "infinite" if error == float("inf") else error


def _times(times: Times | None) -> dict[str, Any]:
    names = ("median_s", "quartile_1_s", "quartile_3_s", "least_s")
    values = (times.median, *times.quartiles, times.least) if times else (None,) * 4
    return {"repetitions": len(times.seconds) if times else 0, **dict(zip(names, values, strict=True))}


def _held(ratio: Ratio) -> dict[str, Any]:
    times, goal = _times(ratio.times), ratio.goal
    return {
        "name": ratio.name, "positions": ratio.positions, "ratio": times["median_s"],
        "quartile_1": times["quartile_1_s"], "quartile_3": times["quartile_3_s"], "rounds": times["repetitions"],
        "goal": goal.bound if goal else None, "at_least": goal.least if goal else None, "reached": ratio.reached,
        "note": ratio.note,
    }  # fmt: skip


# The machine stands in every line, so that files of several machines can be laid together.
COLUMNS = ("scene", *_row(Timed("", None), 0.0), *(field.name for field in fields(Computer)))
