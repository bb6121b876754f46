"""What a scene says of a bank: read with its units, refused all at once with its reason, noted where odd."""

from __future__ import annotations

import re
from fractions import Fraction

import pytest

from plans.bank.reading import notes_of
from plans.linkage.reading.linkage import mechanism_of
from plans.model.balance.bank import BankTask, Member
from plans.scene import notes
from plans.scene.faults import Fault, SceneError
from plans.scene.scene import Scene, parse_scene
from tests.plans.banks import ENGINE, MEMBER, UNIT

SPEED = 'speed = "3000 rpm"\n'
BANK = f"[bank]\n{SPEED}{UNIT}{MEMBER}"
COMPENSATORS = "[[bank.compensators]]\n"


def task(text: str) -> BankTask:
    found: BankTask = parse_scene(text).meaning["bank"].task
    return found


def refused(text: str) -> list[Fault]:
    with pytest.raises(SceneError) as told:
        parse_scene(text)
    assert all(re.search("[а-я]{3}", fault.worded("ru")) for fault in told.value.faults)
    return list(told.value.faults)


def said(text: str) -> list[tuple[str, str]]:
    """Give what is refused, each as its place and its kind."""
    return [(".".join(map(str, fault.path)), fault.kind) for fault in refused(text)]


def test_a_bank_of_the_linkage_turns_as_the_drive_does() -> None:
    assert task(f"{ENGINE}[bank]\n{MEMBER}")[:3] == (None, (Member("1", Fraction(0), Fraction(0), Fraction(0)),), 20)
    assert task(f"{ENGINE}[bank]\n{MEMBER}").axis == 0
    assert task(f"{ENGINE.replace('= 20', '= -20')}[bank]\n{MEMBER}").speed == -20
    assert task(f"{ENGINE}[bank]\nspeed = 30\n{MEMBER}").speed == 30


def with_bank(line: str) -> str:
    return BANK.replace(SPEED, f"{SPEED}{line}\n")


# Others are rows of the catalogue (tests/catalogue/faults/balancing.toml).
WRONG = {
    "a list of none": (f"[bank]\n{SPEED}members = []\n{UNIT}", "members", "empty"),
    "half an order": (with_bank("orders = [0.5]"), "orders.0", "not_whole"),
    "an order beyond all": (with_bank("orders = [101]"), "orders.0", "order_limit"),
    "no orders": (with_bank("orders = []"), "orders", "empty"),
    "an order twice": (with_bank("orders = [2, 2]"), "orders", "repeated"),
    "compensators twice": (
        f"{BANK}{COMPENSATORS}order = 1\n{COMPENSATORS}order = 1\n",
        "compensators.1.order",
        "compensators_twice",
    ),
    "compensators of no mass": (f"{BANK}{COMPENSATORS}order = 1\nmass = 0\n", "compensators.0.mass", "not_positive"),
    "no rod": (BANK.replace('"140 mm"', "0"), "unit.rod", "not_positive"),
    "a crank in kilograms": (BANK.replace("40 mm", "40 kg", 1), "unit.crank", "wrong_unit"),
    "a negative mass": (BANK.replace('"600 g"', "-1"), "unit.rotating", "negative"),
    "no masses at all": (BANK.replace("600 g", "0 g").replace("0.5 kg", "0 kg"), "unit.reciprocating", "massless_unit"),
    "a speed by its unit": (BANK.replace('speed = "3000 rpm"', "rpm = 3000"), "rpm", "unknown_key"),
}


@pytest.mark.parametrize("name", WRONG)
def test_each_thing_that_is_wrong_is_one_fault_at_its_key(name: str) -> None:
    text, path, kind = WRONG[name]
    assert said(text) == [(f"bank.{path}".strip("."), kind)]


@pytest.mark.parametrize("speed", ["", "speed = 0\n", 'speed = "3000 mm"\n'])
def test_a_bank_with_a_wrong_speed_has_its_mechanism_still(speed: str) -> None:
    assert [path for path, _ in said(f"sheets = ['bank']\n{BANK.replace(SPEED, speed)}")] == ["bank.speed"]


def test_a_bank_of_the_linkage_needs_masses_and_a_crank_that_turns_evenly() -> None:
    bank = f"[bank]\n{MEMBER}"
    assert said(ENGINE.replace("= 20", "= 0") + bank) == [("drive.speed", "crank_at_rest")]
    massless = re.sub(r"mass = \d", "mass = 0", ENGINE)
    assert said(massless + bank) == [("masses", "massless")]
    with pytest.raises(SceneError, match="a link with a mass") as told:
        mechanism_of(parse_scene(f"{massless}[balance]\n{bank}"))
    assert len(told.value.faults) == 1


def noted(scene: Scene) -> list[tuple[str, str]]:
    found = list(notes_of(scene))
    assert all(re.search("[а-я]{3}", note.worded("ru")) for note in found)
    return [(".".join(map(str, note.path[1:])), note.kind) for note in found]


@pytest.mark.parametrize(
    ("text", "odd"),
    [
        (BANK, []),
        (BANK.replace("140 mm", "60 mm"), []),
        (BANK.replace("140 mm", "59 mm"), [("unit.rod", "near_rod")]),
        (f"{BANK}[[bank.members]]\ncrank = 180\n", [("members.1", "stacked")]),
        (f"{BANK}[[bank.members]]\ncrank = 180\naxis = 180\n", []),
        (f"{BANK}[[bank.members]]\ncrank = 180\nplace = 0.1\n", []),
        (f"{BANK}[[bank.members]]\ncrank = 180\nplace = 100\n", [("members.1.place", "metres")]),
        (f"{ENGINE}[bank]\nspeed = 20\n{MEMBER}", []),
        (f"{ENGINE}[bank]\nspeed = 21\n{MEMBER}", [("speed", "bank_speed")]),
        (f"{ENGINE}[bank]\nspeed = -20\n{MEMBER}", [("speed", "bank_speed")]),
    ],
)
def test_what_may_be_a_slip_is_noted(text: str, odd: list[tuple[str, str]]) -> None:
    assert noted(parse_scene(text)) == odd


def test_a_sheet_of_a_bank_uses_the_linkage_and_its_balancing() -> None:
    scene = parse_scene(f'sheets = ["bank"]\n{ENGINE}[balance]\n[bank]\n{MEMBER}')
    assert [note.kind for note in notes.notes_of(scene)] == []
    other = parse_scene(f'sheets = ["kinematics"]\n{ENGINE}[balance]\n[bank]\n{MEMBER}')
    assert [note.path for note in notes.notes_of(other)] == [("masses",), ("balance",), ("bank",)]
