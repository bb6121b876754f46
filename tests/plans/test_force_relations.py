"""Relations that the forces of any machine obey: turned, mirrored, enlarged, split, and summed up; no second solver.

Every difference is measured against the largest force of the plan, never against a value itself.
"""

from __future__ import annotations

import cmath
from collections.abc import Callable, Mapping
from dataclasses import replace
from math import radians

from hypothesis import given
from hypothesis import strategies as st

from plans.model.machine import FORCE, MOMENT
from plans.model.mechanism import FRAME
from tests.plans import machine_alterations as altered
from tests.plans.chains import numbers
from tests.plans.loaded import Told, loaded, push


def alike(
    old: Told, new: Told, force: Callable[[complex], complex] = lambda f: f, moment: float = 1.0, times: float = 1.0
) -> None:
    """See that forces are those of before, mapped, and moments `moment` times those; both may grow `times`."""
    assert old.forces.keys() == new.forces.keys()
    slack, turning = 2 * times * old.slack, 2 * abs(moment) * old.turning
    for joint, told in old.forces.items():
        assert abs(new.forces[joint] - force(told)) <= slack, joint
    for joint, twist in old.moments.items():
        assert abs(new.moments[joint] - moment * twist) <= turning, joint
    assert abs(new.driving - force(old.driving)) <= slack
    assert abs(new.balancing - moment * old.balancing) <= turning


@push
@given(loaded(), numbers(-180, 180))
def test_everything_turned_turns_the_forces_and_leaves_the_moments(one, angle):
    turn = cmath.exp(1j * radians(angle))
    alike(one.told, altered.turned(one, radians(angle)).told, lambda force: force * turn)


@push
@given(loaded())
def test_everything_mirrored_mirrors_the_forces_and_reverses_the_moments(one):
    alike(one.told, altered.mirrored(one).told, complex.conjugate, -1.0)


@push
@given(loaded(), st.sampled_from((2.0**-20, 0.37, 2.0**20)))
def test_a_machine_enlarged_bears_more_inertia_and_the_square_of_it_in_moments(one, times):
    alike(one.told, altered.enlarged(one, times, times, times**2).told, lambda f: times * f, times**2, times)


@push
@given(loaded(), st.sampled_from((0.01, 3.0)))
def test_a_crank_driven_faster_with_its_loads_multiplies_all_forces_by_the_square(one, times):
    alike(one.told, altered.quickened(one, times).told, lambda f: times**2 * f, times**2, times**2)


@push
@given(loaded())
def test_the_forces_of_two_load_cases_add_up(one):
    """Masses with one force, and all else alone: inertia counts once."""
    some = replace(one.machine, forces=one.machine.forces[:1], moments=(), springs=())
    rest = replace(altered.massless(one.machine), forces=one.machine.forces[1:])
    parts = [replace(one, machine=its).told for its in (some, rest)]
    summed = Told(
        *({joint: sum(told[joint] for told in tables) for joint in tables[0]} for tables in _tables(parts)),
        sum(part.driving for part in parts),
        sum(part.balancing for part in parts),
        max(part.slack for part in parts),
        max(part.turning for part in parts),
    )
    alike(summed, one.told)


def _tables(parts: list[Told]) -> tuple[list[Mapping], ...]:
    return [part.forces for part in parts], [part.moments for part in parts]


@push
@given(loaded(), st.randoms(use_true_random=False))
def test_other_names_and_numbers_and_another_order_change_nothing(one, chance):
    names = sorted({name for link in one.mechanism.links.values() for name in link.points})
    links = [number for number in sorted(one.mechanism.links) if number != FRAME]
    points = dict(zip(names, chance.sample(names, len(names)), strict=True))
    figures = {FRAME: FRAME} | dict(zip(links, chance.sample(links, len(links)), strict=True)) | {-1: -1}
    new, old = altered.called(one, points, figures).told, one.told
    forces, moments = (
        {(figures[link], points[point], figures[other]): told for (link, point, other), told in table.items()}
        for table in (old.forces, old.moments)
    )
    alike(old._replace(forces=forces, moments=moments), new)


@push
@given(loaded(kinds=(MOMENT, FORCE)))
def test_a_steady_crank_reversed_reverses_only_what_is_against_the_motion(one):
    """Inertia goes by the square of the speed; a load against the motion turns about with it."""
    one = replace(one, mechanism=altered.driven(one.mechanism, one.mechanism.drive.omega, 0.0))
    back = replace(one, mechanism=altered.driven(one.mechanism, -one.mechanism.drive.omega, 0.0))
    its = one.machine
    fixed = replace(
        its,
        forces=tuple(f for f in its.forces if f.direction is not None),
        moments=tuple(m for m in its.moments if not m.against),
    )
    alike(replace(one, machine=fixed).told, replace(back, machine=fixed).told)
    against = replace(
        altered.massless(its),
        forces=tuple(f._replace(direction=None) for f in its.forces),
        moments=tuple(m._replace(against=True) for m in its.moments),
        springs=(),
    )
    alike(replace(one, machine=against).told, replace(back, machine=against).told, lambda f: -f, -1.0)
