"""The catalogue's rows that compare numbers: the same mechanism told otherwise, and mechanisms with exact answers."""

from __future__ import annotations

import math
from itertools import permutations
from pathlib import Path

import numpy as np
import numpy.typing as npt
import pytest

from drawings.commands import cli
from geometry.errors import LimitError
from plans.linkage.study import LinkageStudy
from plans.model.motion import Motion
from plans.scene.scene import parse_scene
from tests.catalogue.scenes import TEXTS
from tests.plans.scenes import changed, scene

PLAIN = (Path(__file__).parent / "plain.toml").read_text("utf-8")
DOUBLE_ROCKER = TEXTS["e07_double_rocker"]
EPS = 2.0**-52


def motion(text: str) -> Motion:
    return LinkageStudy(parse_scene(text)).motion()


def velocity(found: Motion, point: str) -> npt.NDArray[np.complex128]:
    value = found.points[point].v
    assert value is not None
    return value


def acceleration(found: Motion, point: str) -> npt.NDArray[np.complex128]:
    value = found.points[point].a
    assert value is not None
    return value


def test_e12_backwards_from_180_degrees_the_points_are_the_same() -> None:
    forth = motion(changed(PLAIN, ("start = 0", "start = 0\npositions = 14")))
    back = motion(changed(PLAIN, ("start = 0", "start = 180\npositions = 7"), ('"10 rad/s"', "-10")))
    same = [(7 - 2 * k) % 14 for k in range(7)]  # 180 degrees is position 7, and each step back is two of 14
    assert np.abs(back.points["B"].r - forth.points["B"].r[same]).max() < 8 * EPS


def test_f2_the_other_sense_reverses_velocities_and_keeps_accelerations() -> None:
    forth, back = motion(PLAIN), motion(changed(PLAIN, ('"10 rad/s"', "-10")))
    mirror = [-k % 12 for k in range(12)]
    assert velocity(back, "B") == pytest.approx(-velocity(forth, "B")[mirror], abs=1e-12)
    assert acceleration(back, "B") == pytest.approx(acceleration(forth, "B")[mirror], abs=1e-11)


def test_f3_an_angular_acceleration_adds_a_tangential_part() -> None:
    found = motion(changed(PLAIN, ("start = 0", "start = 0\nacceleration = 7")))
    radius = found.points["A"].r - found.points["O"].r
    parts = acceleration(found, "A") / radius  # -omega^2 along the radius, epsilon square to it
    assert parts == pytest.approx(np.full(12, -100 + 7j), abs=1e-9)


YOKE = scene(
    frame="O = [0, 0]", links="OA A BE", lengths="OA = 0.1; BE = 0.2",
    slides=['link = 2; along = "BE"', "link = 3; along = { through = [0, 0], angle = 0 }; angle = 90"],
    drive="link = 1; speed = 10",
)  # fmt: skip


def test_e17_a_scotch_yoke_moves_by_the_cosine() -> None:
    found = motion(YOKE)
    assert found.points["B"].r.real == pytest.approx(0.1 * np.cos(found.phi), abs=1e-16)
    assert velocity(found, "B").real == pytest.approx(-1.0 * np.sin(found.phi), abs=1e-15)


def test_d14_a_guide_in_any_direction_and_through_the_axis_is_the_same_mechanism() -> None:
    slider = scene(
        frame="O = [0, 0]", links="OA AB B", lengths="OA = 0.06; AB = 0.2",
        slides=["link = 3; along = {{ through = [0, 0], angle = {angle} }}"], sketch="B = [{x}, {y}]",
        drive="link = 1; speed = 10; start = {angle}",
    )  # fmt: skip
    found = {}
    for angle in (0, 90, 180, 270, 33):
        way = np.exp(1j * math.radians(angle))
        text = slider.format(angle=angle, x=0.26 * way.real, y=0.26 * way.imag)
        found[angle] = motion(text).points["B"].r / way
    for turned in found.values():
        assert turned == pytest.approx(found[0], abs=1e-15)


PEAUCELLIER = scene(
    frame="O = [0, 0]; C = [1, 0]", links="CP OA OB PA PB AQ BQ",
    lengths="CP = 1; OA = 3; OB = 3; PA = 1.5; PB = 1.5; AQ = 1.5; BQ = 1.5",
    sketch="A = [2.6, 1.5]; B = [2.6, -1.5]; Q = [3.4, 0]",
    drive="link = 1; speed = 1; positions = [0, 10, 20, 30, 40, 50, -10, -20, -30, -40, -50]",
)  # fmt: skip


def test_e23_peaucellier_s_point_runs_on_a_straight_line() -> None:
    """The cell inverts the circle of P through O: |OP| |OQ| = 3^2 - 1.5^2, so that Q stands at x = 6.75/2."""
    found = motion(PEAUCELLIER)
    assert found.gaps == ()
    assert found.points["Q"].r.real + 1 == pytest.approx(np.full(11, 6.75 / 2), abs=1e-13)  # from the datum C
    assert np.ptp(found.points["Q"].r.imag) > 2


def test_e24_no_position_is_lost_or_doubled_near_the_dead_centres() -> None:
    found = motion(changed(DOUBLE_ROCKER, ("start = 40", "start = 40\npositions = 3600")))
    gaps = [gap.position for gap in found.gaps]
    drawn = np.flatnonzero(np.isfinite(found.points["B"].r))
    assert sorted([*gaps, *drawn]) == list(range(3600))
    steps = np.flatnonzero(np.diff(gaps) != 1)
    assert len(steps) <= 2  # what is out of reach is one arc at each limit, with none lost in between


def chain(dyads: int) -> str:
    """Write a crank and a row of rockers, each driven by the one before it."""
    frame, links, lengths, sketch = ["O = [0, 0]"], ['1 = "OA0"'], ["OA0 = 0.1"], []
    for k in range(1, dyads + 1):
        frame.append(f"C{k} = [{0.35 * k}, 0]")
        links += [f'{2 * k} = "A{k - 1}A{k}"', f'{2 * k + 1} = "C{k}A{k}"']
        lengths += [f"A{k - 1}A{k} = {0.4 if k == 1 else 0.35}", f"C{k}A{k} = 0.3"]
        sketch.append(f"A{k} = [{0.35 * k + 0.04}, 0.3]")
    tables = {"frame": frame, "links": links, "lengths": lengths, "sketch": sketch}
    text = "".join(f"[mechanism.{name}]\n" + "\n".join(lines) + "\n" for name, lines in tables.items())
    return text + "[drive]\nlink = 1\nspeed = 10\n"


def test_d15_a_chain_of_59_links_is_solved() -> None:
    study = LinkageStudy(parse_scene(chain(29)))
    assert [group.kind for group in study.groups] == ["RRR"] * 29
    found = study.motion()
    assert found.gaps == ()
    for k in range(1, 30):
        rods = ((f"A{k - 1}", f"A{k}", 0.4 if k == 1 else 0.35), (f"C{k}", f"A{k}", 0.3))
        for first, second, length in rods:
            reach = np.abs(found.points[first].r - found.points[second].r)
            assert reach == pytest.approx(np.full(12, length), abs=1e-14)


def test_d15_more_than_sixty_links_are_too_many() -> None:
    with pytest.raises(LimitError, match="a table or list of 61 entries: more than LINKS_LIMIT = 60"):
        parse_scene(chain(30))


def test_b20_many_positions_of_many_links_are_too_many(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "chain.toml"
    path.write_text(chain(29) + "positions = 100_000\n", "utf-8")
    assert cli.main(["solve", str(path)]) == 8
    product = (
        "drive.positions = 100000: links times positions, 59 × 100000, is more than LINK_POSITIONS_LIMIT = 1000000"
    )
    assert f"{product}. Fix: 16949 positions" in capsys.readouterr().err


SLOT = scene(
    frame="O = [0, 0]; C = [0, -0.35]", links="OA A CB", lengths="OA = 0.12; CB = 0.7",
    slides=['link = 2; along = "CB"'], sketch="B = [0.16, 0.33]", drive="link = 1; speed = 10; start = 10",
)  # fmt: skip


@pytest.mark.parametrize("speed", [10, -10])
def test_f5_coriolis_s_part_is_twice_omega_times_the_slip_in_all_four_cases(speed: int) -> None:
    """The stone runs outward or inward while the slot turns either way: a square to it = 2 omega v_r + epsilon l."""
    found = motion(changed(SLOT, ("speed = 10", f"speed = {speed}")))
    omega, epsilon = found.links[3].omega, found.links[3].epsilon
    assert omega is not None
    assert epsilon is not None
    arm = found.points["A"].r - found.points["C"].r
    along = arm / np.abs(arm)
    slip = (velocity(found, "A") / along).real
    crank = -100 * found.points["A"].r  # the stone goes with the crank's end: its acceleration is known
    assert (crank / along).imag == pytest.approx(2 * omega * slip + epsilon * np.abs(arm), abs=1e-12)
    assert {(w > 0, s > 0) for w, s in zip(omega.tolist(), slip.tolist(), strict=True)} == {
        (w, s) for w in (True, False) for s in (True, False)
    }


@pytest.mark.parametrize("lengths", [(0.1, 0.25, 0.28, 0.3), (0.2, 0.25, 0.28, 0.42)], ids=["Grashof", "triple rocker"])
def test_e6_in_all_inversions_the_crank_turns_fully_only_where_grashof_lets_it(lengths: tuple[float, ...]) -> None:
    """The sum of the shortest and the longest is the less, and the shortest is the crank or the frame."""
    for crank, rod, rocker, frame in permutations(lengths):
        text = changed(
            PLAIN, ("0.350", f"{frame}"), ("OA = 0.100", f"OA = {crank}"), ("AB = 0.400", f"AB = {rod}"),
            ("CB = 0.300", f"CB = {rocker}"),
        )  # fmt: skip
        grashof = min(lengths) + max(lengths) < sum(lengths) / 2
        assert (not LinkageStudy(parse_scene(text)).barriers) == (grashof and min(lengths) in (crank, frame))
