"""How a bench is printed, kept and plotted, tested on one of made-up numbers."""

from __future__ import annotations

import csv
import io
import json
import math
from dataclasses import replace
from xml.etree import ElementTree

import pytest

from drawings.bench import hands, plot, report, sheet
from plans.bench.error import Errors
from plans.bench.peers import MECHANISM, PYLINKAGE
from plans.bench.roads import CONSTRUCTION, REPLAY, ROUNDING, TOLERANCES, newton
from plans.bench.trial import NOT_INSTALLED, Bench, Computer, Goal, Ratio, Row, Times
from plans.bench.truth import KINDS

SVG = "{http://www.w3.org/2000/svg}"
MACHINE = Computer("Abacus 9", 4, 0.5, "Linux x86_64", "3.11.7", "2.4.6")
TECHNIQUES = (*CONSTRUCTION, REPLAY, *map(newton, TOLERANCES), ROUNDING, sheet.MEASURED, sheet.PRINTED)


def invented() -> Bench:
    """Give a bench of made-up numbers, with every technique that a plot can show."""
    rows = []
    for k, name in enumerate((*TECHNIQUES, PYLINKAGE, MECHANISM)):
        for count in (12, 360):
            errors = Errors({}) if name == REPLAY else Errors({"r": 10.0**-k / 2, "v": 10.0**-k}, "v_B")
            rows.append(Row(name, count, count, errors, times=Times((count * 1e-6, count * 2e-6, count * 3e-6))))
    rows.append(Row(PYLINKAGE, 10_000, note=NOT_INSTALLED))
    rows += [Row(hands.BY_HAND.format(slip), None, 2, Errors({}, "", slip / 10), slip / 5) for slip in (0.1, 0.2)]
    reached = Ratio("this / that", 360, Times((9.0, 8.0, 7.0)), Times((1.0, 1.0, 1.0)), Goal(5.0))
    missed = Ratio("part / whole", 12, Times((9.0,)), Times((10.0,)), Goal(0.5, least=False))
    unknown = Ratio("peer / ours", 360, goal=Goal(2.0), note=NOT_INSTALLED)
    return Bench("Costs $5 and $6", MACHINE, tuple(rows), (reached, missed, unknown), ("error: so and so",), 1e-4)


def lines(content: bytes) -> list[dict[str, str]]:
    return list(csv.DictReader(io.StringIO(content.decode("utf-8"))))


def test_every_line_of_the_csv_has_its_error_its_times_and_its_machine() -> None:
    found = lines(report.csv_bytes(invented()))
    assert len(found) == len(invented().rows)
    assert tuple(found[0]) == report.COLUMNS
    assert {f"error_{kind}" for kind in KINDS} <= set(found[0])
    first = found[0]
    assert (first["technique"], first["positions"], first["worst"]) == (CONSTRUCTION[0], "12", "v_B")
    assert (float(first["error"]), float(first["error_r"]), first["error_a"]) == (1.0, 0.5, "")
    assert (first["repetitions"], first["accepted"]) == ("3", "False")
    assert [float(first[name]) for name in ("median_s", "least_s", "position_s")] == [2.4e-5, 1.2e-5, 2e-6]
    assert {line["processor"] for line in found} == {"Abacus 9"}
    left_out = next(line for line in found if line["note"] == NOT_INSTALLED)
    assert (left_out["error"], left_out["median_s"], left_out["repetitions"]) == ("", "", "0")


def test_the_json_is_plain_and_whole() -> None:
    told = json.loads(report.json_text(invented()))
    assert told["machine"]["processor"] == "Abacus 9"
    assert [ratio["reached"] for ratio in told["ratios"]] == [True, False, None]
    assert (told["ratios"][0]["ratio"], told["ratios"][0]["goal"]) == (8.0, 5.0)
    hand = told["rows"][-1]
    assert (hand["error"], hand["error_95"], hand["positions"]) == (0.02, 0.04, None)


def test_an_infinite_error_is_a_word_in_the_json() -> None:
    rows = (Row("lost", 12, 12, Errors({"v": math.inf}, "v_B"), times=Times((1.0,))),)
    told = json.loads(report.json_text(replace(invented(), rows=rows)))
    assert told["rows"][0]["error"] == "infinite"
    assert told["rows"][0]["accepted"] is False


def test_the_table_tells_goals_and_verdicts() -> None:
    text = report.written(invented())
    assert "Abacus 9, 4 cores" in text
    (reached,) = (line for line in text.splitlines() if line.startswith("this / that"))
    assert reached.split()[-3:] == [">=", "5", "yes"]
    (missed,) = (line for line in text.splitlines() if line.startswith("part / whole"))
    assert missed.split()[-3:] == ["<=", "0.5", "no"]
    (unknown,) = (line for line in text.splitlines() if line.startswith("peer / ours"))
    assert unknown.endswith(NOT_INSTALLED)
    assert "360 positions" in text
    assert "any number of positions" in text


@pytest.mark.rest
def test_the_plot_is_black_and_white_and_shows_every_technique() -> None:
    content = plot.svg(invented()).decode("utf-8")
    root = ElementTree.fromstring(content)
    assert root.tag == f"{SVG}svg"
    colours = {part.partition(";")[0].strip() for part in content.split("fill: #")[1:]}
    colours |= {part.partition(";")[0].strip() for part in content.split("stroke: #")[1:]}
    shades = [colour[:6] for colour in colours]
    assert all(shade[:2] == shade[2:4] == shade[4:6] for shade in shades)
    for text in (*CONSTRUCTION, ROUNDING, sheet.MEASURED, PYLINKAGE, "accepted", "by hand, mm"):
        assert f"<!-- {text} -->" in content  # what matplotlib has drawn as outlines it says beside
    assert "Abacus 9" in content
    assert "<dc:date>" not in content


def test_no_two_techniques_look_alike() -> None:
    assert len(set(plot.LOOKS.values())) == len(plot.LOOKS)
    assert {(look.marker, look.filled) for look in plot.LOOKS.values()} >= {("o", True), ("o", False)}
    assert len({(look.marker, look.filled) for look in plot.LOOKS.values()}) == len(plot.LOOKS)


@pytest.mark.rest
def test_a_plot_of_gaps_alone_is_still_a_plot() -> None:
    bare = replace(invented(), rows=(Row(PYLINKAGE, 12, note=NOT_INSTALLED),))
    assert ElementTree.fromstring(plot.svg(bare)).tag == f"{SVG}svg"


def test_a_title_like_a_formula_is_written_as_text() -> None:
    for title in ('=HYPERLINK("http://x","y")', "+1", "-1", "@SUM(1)"):
        lines = csv.DictReader(io.StringIO(report.csv_bytes(replace(invented(), title=title)).decode("utf-8")))
        assert {line["scene"] for line in lines} == {f"'{title}"}
    plain = next(csv.DictReader(io.StringIO(report.csv_bytes(invented()).decode("utf-8"))))
    assert plain["scene"] == invented().title
