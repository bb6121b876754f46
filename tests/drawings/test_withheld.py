"""What is right of a scene is drawn: a wrong sheet alone is withheld (5); one badly drawn is written and told (4)."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from drawings.checks.verify import SelfCheckFailed
from drawings.commands.draw import draw
from drawings.files.sheet_set import read_manifest
from drawings.paper.strokes import Fill, Group, Kind, Leaf, LineStyle, Text
from drawings.rotor.due import expected as due_of_rotor
from drawings.rotor.sheet import SHEETS
from drawings.sheets import documents
from plans.rotor import quantities
from tests.drawings.bank_scenes import scene
from tests.drawings.conftest import Run
from tests.gallery import GALLERY

WHITE = LineStyle(0.25, fill="#ffffff")


@pytest.fixture
def both(tmp_path: Path) -> Path:
    """Write a scene of a rotor and a bank."""
    rotor = (GALLERY / "fan.toml").read_text("utf-8").replace('sheets = ["rotor"]', 'sheets = ["rotor", "bank"]')
    bank = scene("boxer").replace('sheets = ["bank"]\n', "").partition("[sheet]")[0]
    path = tmp_path / "fan.toml"
    path.write_text(f"{rotor}\n{bank}", "utf-8")
    return path


def wrong_due(kind: Kind) -> Callable[..., Iterator[Any]]:
    """Let the table of a rotor ask for the first of a kind otherwise than it is."""
    own = due_of_rotor

    def due(*given: Any) -> Iterator[Any]:
        rows = [*own(*given)]
        first = next(k for k, row in enumerate(rows) if row.kind is kind and not row.may_lack)
        rows[first] = rows[first]._replace(value=1.01 * rows[first].value)
        return iter(rows)

    return due


@pytest.mark.parametrize("kind", [Kind.VECTOR, pytest.param(Kind.POINT, marks=pytest.mark.rest)])
def test_one_wrong_sheet_is_withheld_and_the_other_is_written(
    kind: Kind, both: Path, run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(SHEETS, "rotor", SHEETS["rotor"]._replace(expected=wrong_due(kind)))
    out = both.parent / "out"
    code, said, err = run("draw", both, "-o", out)
    assert code == 5
    assert "fan-rotor.svg" in err and "sheet.format" in err and "fan-bank.svg" not in err
    assert (out / "fan-bank.svg").exists() and (out / "fan-report.md").exists()
    assert not (out / "fan-rotor.svg").exists() and "fan-rotor.svg" not in said
    manifest = read_manifest(out / "fan-manifest.json")
    assert manifest is not None and manifest.strangers(out) == []


def test_where_no_sheet_is_right_nothing_is_written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(SHEETS, "rotor", SHEETS["rotor"]._replace(expected=wrong_due(Kind.VECTOR)))
    with pytest.raises(SelfCheckFailed) as told:
        draw(GALLERY / "fan.toml", tmp_path)
    assert told.value.exit_code == 5
    assert list(tmp_path.iterdir()) == []


def test_where_the_roads_of_one_technique_differ_the_sheets_of_the_others_are_written(
    both: Path, run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    balance = quantities.balance

    def wrong(rotor: Any) -> Any:
        found = balance(rotor)
        return replace(found, unbalance=found.unbalance._replace(value=found.unbalance.value * (1 + 1e-6)))

    monkeypatch.setattr(quantities, "balance", wrong)
    out = both.parent / "out"
    code, _, err = run("draw", both, "-o", out)
    assert code == 5
    assert "rotor" in err
    assert (out / "fan-bank.svg").exists() and not (out / "fan-rotor.svg").exists()


@pytest.mark.parametrize(
    ("strokes", "says"),
    [
        ((Text(60 + 60j, "12,5"), Fill((55 + 55j, 90 + 55j, 90 + 70j, 55 + 70j), WHITE)), "12,5"),
        ((Text(415 + 60j, "12,5"),), "12,5"),
    ],
)
def test_lettering_that_is_covered_or_off_the_paper_is_told_and_the_sheet_is_written(
    strokes: tuple[Any, ...], says: str, tmp_path: Path, run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    own = documents.leaves_of

    def spoilt(study: Any) -> Mapping[str, Sequence[Leaf]]:
        return {
            kind: [leaf._replace(groups=(*leaf.groups, Group(strokes, "added"))) for leaf in leaves]
            for kind, leaves in own(study).items()
        }

    monkeypatch.setattr(documents, "leaves_of", spoilt)
    code, _, err = run("draw", GALLERY / "fan.toml", "-o", tmp_path)
    assert code == 4
    assert re.search(says, err)
    assert (tmp_path / "fan-rotor.svg").exists()
