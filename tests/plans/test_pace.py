"""A linkage whose crank has in each position an angular velocity and acceleration of its own, by both roads."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np
import pytest

from drawings.forces.notes import notes as force_notes
from drawings.linkage.notes import notes as motion_notes
from plans.forces.quantities import ForceComparison, compare_forces
from plans.forces.statics import Statics
from plans.linkage import study as studies
from plans.linkage.quantities import compare
from plans.linkage.study import LinkageStudy
from plans.model.motion import Floats, Pace, Rates
from plans.scene.scene import parse_scene, read_scene
from tests import parts
from tests.gallery import GALLERY, TURNING
from tests.plans.test_carrying import COUPLING_ROD
from tests.rows import over


def study(path: Path, plans: tuple[str, ...] = studies.ALL) -> LinkageStudy:
    return LinkageStudy(read_scene(path), plans)


def constant(one: LinkageStudy) -> Pace:
    """Give the rates of a study's drive as rows."""
    drive = one.mechanism.drive
    return lambda phi: Rates(np.full(len(phi), drive.omega), np.full(len(phi), drive.epsilon))


def uneven(one: LinkageStudy) -> Pace:
    """Give rates as of a machine with a light flywheel: omega = w (1 + 0.1 sin phi), epsilon = omega domega/dphi."""
    speed = one.mechanism.drive.omega

    def pace(phi: Floats) -> Rates:
        omega = speed * (1 + 0.1 * np.sin(phi))
        return Rates(omega, omega * speed * 0.1 * np.cos(phi))

    return pace


@cache
def forces(path: Path, how: str) -> ForceComparison:
    one = study(path)
    paces = {"scene": None, "constant": constant(one), "uneven": uneven(one)}
    pace = paces[how]
    statics = Statics(one if pace is None else one.paced(pace))
    return compare_forces(statics, compare(statics.study))


@pytest.mark.part
@over("path", TURNING if parts.whole else TURNING[::4])
def test_both_roads_agree_at_uneven_rates(path: Path) -> None:
    one = study(path)
    assert compare(one.paced(uneven(one))).agrees


def test_plans_of_some_positions_have_their_rates(monkeypatch: pytest.MonkeyPatch) -> None:
    one = study(GALLERY / "shaper-loaded.toml")
    paced = one.paced(uneven(one))
    whole = paced.motion().points["D"]
    picked = paced.drafts([3, 9])
    assert np.array_equal(picked.positions.point("D").point, whole.r[[3, 9]])
    assert np.array_equal(picked.accelerations.point("D").point, whole.a[[3, 9]])  # drawn over the positions
    monkeypatch.setattr(studies, "BLOCK", 5)
    again = LinkageStudy(one.scene, pace=uneven(one)).motion()
    assert np.array_equal(again.points["D"].a, whole.a)


def test_the_efficiency_of_a_turn_is_of_works_and_not_of_powers() -> None:
    """Where the crank is slow a power lasts longer."""
    one = study(GALLERY / "shaper-loaded.toml")
    both = forces(GALLERY / "shaper-loaded.toml", "uneven").friction
    assert both is not None
    omega, _ = uneven(one)(one.turn.phi)
    for told in both:
        used, lost = (float((power / omega).sum()) for power in (told.useful, told.lost))
        assert told.cycle == pytest.approx(used / (used + lost), rel=1e-12)
        assert told.cycle != pytest.approx(told.useful.sum() / (told.useful + told.lost).sum(), rel=1e-4)
        shares = {key: float((power / omega).sum()) / lost for key, power in told.powers.items()}
        assert told.wear == pytest.approx(shares, rel=1e-12)


def test_a_linkage_carried_through_its_change_points_has_the_rates_of_each_position() -> None:
    text = COUPLING_ROD.format(through='through = "parallel"', speed=2, start=10)
    one = LinkageStudy(parse_scene(text))
    paced = one.paced(uneven(one))
    motion, (omega, epsilon) = paced.motion(), paced.turn.rates or (0, 0)
    assert compare_forces(Statics(paced), compare(paced)).agrees
    # Coupling rod and cranks stay parallel: the other crank has the rates of this one.
    assert motion.links[3].omega == pytest.approx(omega, rel=1e-12)
    # Ten degrees from a change point an acceleration feels each rounding by the square of kappa, some thirty times.
    assert motion.links[3].epsilon == pytest.approx(epsilon, rel=1e-12, abs=1e-11)


def test_the_sheets_say_the_rates_of_all_positions_and_of_the_one_that_they_show() -> None:
    def pace(phi: Floats) -> Rates:
        return Rates(np.linspace(-9, -11, len(phi)), np.linspace(2, -3, len(phi)))

    one = study(GALLERY / "slider-crank.toml").paced(pace)
    told = motion_notes(one, compare(one), "en")
    assert any(note.startswith("ω_1 = −11 … −9 rad/s, ε_1 = −3 … 2 rad/s²") for note in told)
    statics = Statics(one)
    forces = compare_forces(statics, compare(one))
    assert force_notes(statics, forces, 11, "en")[0].startswith("ω_1 = −11 rad/s, ε_1 = −3 rad/s² (of the machine's")
    assert force_notes(statics, forces, 0, "ru")[0].startswith("ω_1 = −9 рад/с, ε_1 = 2 рад/с² (")
