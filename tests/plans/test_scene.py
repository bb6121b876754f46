"""Scenes: the example mechanisms with their exact numbers, and all faults of a file at once, each on its line."""

from __future__ import annotations

import math
import time
from decimal import Decimal

import pytest
from hypothesis import given
from hypothesis import strategies as st

from geometry.errors import LimitError
from plans.linkage.reading.fields import LineTable
from plans.linkage.reading.form import LinkageForm
from plans.linkage.reading.guides import triangle
from plans.linkage.reading.linkage import mechanism_of
from plans.model.cam import FORCE, GROOVE, LAWS
from plans.model.mechanism import Drive, Mechanism, Output, StructureError
from plans.scene.faults import SHOWN, Fault, SceneError
from plans.scene.forms import called
from plans.scene.scene import parse_scene
from plans.words.words import said, word
from tests.parts import examples, some
from tests.plans.scenes import scene

SHAPER = scene(
    'title = "Crank shaper"; sheets = ["kinematics"]', frame="O = [0, 0]; C = [0, -0.350]",
    links="OA A CB BD D", lengths='OA = 0.120; CB = "700 mm"; BD = 0.200',
    slides=['link = 2; along = "CB"', "link = 5; along = { through = [0, 0.3287856445], angle = 0 }"],
    sketch="B = [0.20, 0.32]; D = [0.40, 0.33]",
    drive='link = 1; speed = "60 rpm"; acceleration = 5; start = "extreme"; positions = 12',
)  # fmt: skip
ENGINE = scene(
    frame="O = [0, 0]", links="OA AB B", lengths='OA = "60 mm"; AB = "200 mm"',
    points="S2 = { on = 2, at = [0.070, 0] }", slides=["link = 3; along = { through = [0, 0.020], angle = 0 }"],
    sketch="B = [0.23, 0.02]", drive='link = 1; speed = "10 rad/s"',
)  # fmt: skip
FOUR_BAR = scene(
    frame="O = [0, 0]; C = [0.350, 0]", links="OA ABE CB",
    lengths="OA = 0.100; AB = 0.5; AE = 0.3; EB = 0.4; CB = 0.300", sketch="B = [0.39, 0.30]; E = [0.1, 0.4]",
    drive="link = 1; speed = 10; start = 30",
)  # fmt: skip


def build(text: str, *changes: tuple[str, str]) -> Mechanism:
    for old, new in changes:
        assert old in text
        text = text.replace(old, new, 1)
    return mechanism_of(parse_scene(text))


def faults(text: str, *changes: tuple[str, str]) -> tuple[Fault, ...]:
    with pytest.raises(SceneError) as refused:
        build(text, *changes)
    return refused.value.faults


def test_the_shaper() -> None:
    scene = parse_scene(SHAPER, "shaper.toml")
    form = scene.of(LinkageForm)
    assert form.mechanism.lengths["CB"] == Decimal("0.7")
    assert form.drive.start == "extreme"
    assert form.drive.count == 12
    assert form.mechanism.slides[1].along == LineTable(through=(0, Decimal("0.3287856445")), angle=0)
    mechanism = mechanism_of(scene)
    assert mechanism.links[3].points == {"C": 0, "B": 0.7}
    assert mechanism.links[0].points == {"C": -0.35j, "O": 0}
    assert mechanism.drive == Drive(1, "O", "A", 2 * math.pi, 5.0)
    stone, ram = mechanism.slides
    assert (stone.slider, stone.owner, stone.label, stone.point) == (2, 3, "CB", "A")
    assert (stone.on_owner.through, stone.on_owner.direction) == (0, 1)
    assert (ram.slider, ram.owner, ram.label, ram.point) == (5, 0, "", "D")
    assert (ram.on_owner.through, ram.on_owner.direction) == (0.3287856445j, 1)
    assert mechanism.hinges == {"A": (1, 2), "B": (3, 4), "C": (0, 3), "D": (4, 5), "O": (0, 1)}
    assert mechanism.mobility == 1


@pytest.mark.parametrize(
    ("near", "far", "foot"), [("0.3", "0.2", "0.3"), ("0.7", "0.2", "0.7"), ("0.2", "0.7", "-0.2")]
)
def test_a_flat_triangle_needs_no_side(near: str, far: str, foot: str) -> None:
    assert triangle(Decimal("0.5"), Decimal(near), Decimal(far)) == (Decimal(foot), 0)
    flat = ("AE = 0.3\nEB = 0.4", f"AE = {near}\nEB = {far}")
    assert build(FOUR_BAR, flat, ("E = [0.1, 0.4]", "")).links[2].points["E"] == float(foot)


def test_directions_of_right_angles_are_exact() -> None:
    for angle, direction in (("90", 1j), ('"-90 deg"', -1j), ("180", -1), ("450", 1j), ("-720", 1)):
        assert build(ENGINE, ("angle = 0 }", f"angle = {angle} }}")).slides[0].on_owner.direction == direction


def test_an_offset_slider_turned_to_its_guide() -> None:
    table = 'link = 3\npoint = "B"\noffset = 0.01\nangle = 90\n'
    slide = build(ENGINE, ("link = 3\n", table)).slides[0]
    # The link's +x axis is square to the guide, so the guide runs along -y of the link; left of it is +x.
    assert slide.on_slider.direction == -1j
    assert slide.on_slider.through == -0.01


def test_the_output_is_a_link_or_the_slider_at_a_point() -> None:
    assert build(SHAPER + "[output]\nlink = 5\n").output == Output(5, "D")
    assert build(SHAPER + '[output]\npoint = "D"\n').output == Output(5, "D")
    assert build(SHAPER + "[output]\nlink = 3\n").output == Output(3, None)
    assert build(ENGINE + '[output]\npoint = "S2"\n').output == Output(2, "S2")


def test_all_faults_come_at_once_with_their_lines() -> None:
    found = faults(
        FOUR_BAR,
        ("[mechanism.frame]", 'titel = "X"\n[mechanism.frame]'),  # line 1
        ("C = [0.350, 0]", 'C = [0.350, "3 kg"]'),  # line 4
        ("OA = 0.100", "OA = 0"),  # line 10
        ("B = [0.39, 0.30]", "G = [0.39, 0.30]"),  # line 16: of the meaning, not of the form
        ("speed = 10", "sped = 10"),  # line 20
        ("start = 30", "start = 30\n[masses]\n9 = { mass = 1 }"),  # line 23
    )
    assert [(fault.line, fault.kind) for fault in found] == [
        (1, "unknown_key"),
        (4, "wrong_unit"),
        (10, "not_positive"),
        (16, "unknown_point"),
        (20, "unknown_key"),
        (23, "unknown_link"),
    ]


def test_what_follows_from_a_fault_is_not_said() -> None:
    assert [fault.kind for fault in faults(SHAPER, ("[mechanism.lengths]", "[mechanism.lenghts]"))] == ["unknown_key"]
    assert [fault.kind for fault in faults(SHAPER, ("[mechanism.links]", "[mechanism.linkz]"))] == ["unknown_key"]
    assert [fault.kind for fault in faults(SHAPER, ('4 = "BD"', '4 = "bd"'))] == ["letters"]
    assert [fault.kind for fault in faults(SHAPER, ("link = 1\n", ""))] == ["missing"]
    assert [fault.kind for fault in faults(SHAPER, ("O = [0, 0]", "O = [0]"))] == ["pair"]


def test_a_message_shows_twenty_faults_and_counts_the_others() -> None:
    many = FOUR_BAR + "[sheet]\n" + "".join(f"key{number} = 1\n" for number in range(30))
    with pytest.raises(SceneError) as refused:
        parse_scene(many)
    lines = str(refused.value).splitlines()
    assert len(lines) == SHOWN + 1
    assert lines[-1] == "and 10 more"


def test_a_fault_is_one_line_that_names_everything() -> None:
    (fault,) = faults(ENGINE, ('OA = "60 mm"', 'OA = "60 kg"'))
    assert str(fault) == (
        'scene.toml:8:1: mechanism.lengths.OA = "60 kg": expected a unit of length (m, dm, cm, mm and others), but '
        "found kg. Fix: write it in one of these units, or as a bare number in m."
    )


@pytest.mark.parametrize("name", ["positions", "Positions", "position", "положения", "Положение", "ПОЛОЖЕНИЯ"])
def test_a_sheet_is_found_by_its_name_in_any_language(name: str) -> None:
    assert parse_scene(f'sheets = ["{name}"]\n{FOUR_BAR}').sheets == ("positions",)


@pytest.mark.parametrize(
    ("name", "nearest"), [("poziton", "positions"), ("силовой расчёт", "forces"), ("кулачки", "cam")]
)
def test_a_name_of_no_sheet_is_told_the_nearest(name: str, nearest: str) -> None:
    (fault,) = faults(FOUR_BAR, ("[mechanism.frame]", f'sheets = ["{name}"]\n[mechanism.frame]'))
    assert nearest in fault.advice


def test_a_word_of_a_choice_is_read_as_it_is_printed_and_in_short() -> None:
    laws = {word("ru", f"sheet.law {law}"): law for law in LAWS} | {"синус": "sine", "Косинус": "cosine"}
    assert {name: called(name, LAWS) for name in laws} == laws
    assert [called(name, (FORCE, GROOVE)) for name in ("силовое", "пазовое")] == [FORCE, GROOVE]
    assert [called(name) for name in ("структурный анализ", "центры")] == ["structure", "centres"]
    (fault,) = faults(FOUR_BAR, ("[mechanism.frame]", 'sheets = ["x"]\n[mechanism.frame]'))
    assert "dynamics (динамика), " in fault.worded("ru")


def test_mobility_shows_its_count() -> None:
    with pytest.raises(StructureError) as refused:
        build(
            SHAPER,
            ('5 = "D"', ""),
            ("[[mechanism.slides]]\nlink = 5\nalong = { through = [0, 0.3287856445], angle = 0 }", ""),
        )
    assert (refused.value.found, refused.value.needed) == (2, 1)
    assert refused.value.links == (1, 2, 3, 4)
    assert "W = 3n − 2p = 3*4 − 2*5 = 2 (4 hinges, 1 slides" in str(refused.value)


FIELD_VALUES = (
    "true",
    "[]",
    "{}",
    '""',
    '"x"',
    "nan",
    "-1",
    "0.5",
    "1979-05-27",
    "[1, 2, 3]",
    "{ a = 1 }",
    "[[1]]",
    "7",
)
LINES = [line for line in SHAPER.splitlines() if "=" in line and not line.startswith("title")]


@pytest.mark.parametrize("line", some(LINES, 6))
def test_a_wrong_value_is_one_fault_whatever_it_is(line: str) -> None:
    key = line.partition("=")[0]
    for value in FIELD_VALUES:
        try:
            build(SHAPER, (line, f"{key}= {value}"))
        except StructureError:
            continue
        except SceneError as error:
            number = SHAPER.splitlines().index(line) + 1
            about = [fault for fault in error.faults if fault.line == number]
            assert len(about) <= 1 or value in ("[1, 2, 3]", "{}", "{ a = 1 }"), str(error)


@examples(6)
@given(st.data())
def test_any_scene_is_read_or_refused_in_words(data: st.DataObject) -> None:
    lines = SHAPER.splitlines()
    for _ in range(data.draw(st.integers(1, 4))):
        number = data.draw(st.integers(0, len(lines) - 1))
        key = lines[number].partition("=")[0]
        other = data.draw(st.sampled_from(lines))
        lines[number] = data.draw(
            st.sampled_from(["", other, *(f"{key} = {value}" for value in FIELD_VALUES if "=" in lines[number])])
        )
    try:
        build("\n".join(lines))
    except (SceneError, StructureError, LimitError) as error:
        assert str(error).startswith("scene.toml")


HOSTILE = {
    "unknown points": FOUR_BAR.replace("OA = 0.1", "".join(f"OX{number} = 1\n" for number in range(900)) + "OA = 0.1"),
    "wrong angles": FOUR_BAR.replace("start = 30", "positions = [" + "'x'," * 99_000 + "]"),
    "unknown keys": FOUR_BAR + "[sheet]\n" + "".join(f"language{number} = 1\n" for number in range(60_000)),
    "wrong sheets": "sheets = [" + "'x'," * 990 + "]\n" + FOUR_BAR,
    "long letters": FOUR_BAR.replace('"OA"', '"' + "A" * 900_000 + '"'),
    "long name": FOUR_BAR.replace("OA = 0.100", "OA = 0.1\n" + "A" * 900_000 + " = 1"),
    "long unit": FOUR_BAR.replace("OA = 0.100", 'OA = "1 ' + "m" * 900_000 + '"'),
    "long title": 'title = "' + "x" * 900_000 + '"\n' + FOUR_BAR,
    "many links": FOUR_BAR.replace('3 = "CB"', "\n".join(f'{number} = "B{number}"' for number in range(3, 30_000))),
    "many lengths": FOUR_BAR.replace("OA = 0.100", "\n".join(f"O{number}A = 1" for number in range(30_000))),
    "many digits": FOUR_BAR.replace("speed = 10", "speed = 1." + "3" * 900_000 + "e999"),
}


@pytest.mark.parametrize("text", some(HOSTILE.values(), 9, HOSTILE))
def test_a_hostile_scene_is_refused_at_once(text: str) -> None:
    began = time.perf_counter()
    with pytest.raises((SceneError, LimitError)) as refused:
        build(text)
    assert time.perf_counter() - began < 30  # a hang, not a speed: under a second on a quiet machine
    assert all(len(line) < 2_000 for line in str(refused.value).splitlines())


CHAIN_OF_FIFTY = "[mechanism.frame]\nO = [0, 0]\n[mechanism.links]\n" + "".join(
    f'{k} = "A{k - 1}A{k}"\n' for k in range(1, 51)
)


@pytest.mark.parametrize(("sheets", "most"), [('["kinematics"]', 20_000), ('["forces"]', 10_000)])
def test_links_times_positions_are_limited_by_name(sheets: str, most: int) -> None:
    """59 links at 100,000 positions once took 9.4 GB, and running out of memory was called a bug."""
    text = f"sheets = {sheets}\n{CHAIN_OF_FIFTY}[drive]\nlink = 1\nspeed = 1\npositions = "
    assert parse_scene(f"{text}{most}").of(LinkageForm).drive.count == most
    with pytest.raises(LimitError, match=f"_POSITIONS_LIMIT = .* Fix: {most} positions at most") as refused:
        parse_scene(f"{text}{most + 1}")
    assert "links times positions, 50 ×" in str(refused.value)
    assert "Исправьте: не больше" in said(refused.value, "ru")
