"""Likenesses of balances: machines turned, mirrored, enlarged, heavier, faster, described otherwise, balanced twice."""

from __future__ import annotations

import cmath
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from math import radians

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from plans.analytic.balance.counterweights import FoundWeights, sought
from plans.analytic.balance.counterweights import counterweights as by_vectors
from plans.balance.mass_centre import MainPoints
from plans.balance.shares import mass_centre
from plans.balance.study import BalanceStudy, counterweights, substituted
from plans.balance.study import loaded as with_weights
from plans.balance.substitution import Substitution
from plans.balance.weights import Unmade, tree_of
from plans.model.balance.linkage import FULL, PARTIAL, BalanceTask, Counterweight, MassCentre, Site
from plans.model.decomposition import decompose
from plans.model.dyad import Assur
from plans.model.machine import Body, Machine
from plans.model.mechanism import FRAME, Mechanism
from tests.parts import examples
from tests.plans import machine_alterations as altered
from tests.plans.balanced import ENGINE, FOUR_BAR, SHAPER, asked, study
from tests.plans.chains import chains, numbers
from tests.plans.loaded import Loaded, loaded, machines
from tests.plans.machines import machine, pointed
from tests.plans.test_balance_construction import inertia_alone

TIMES = st.sampled_from((2.0**-20, 0.37, 2.0**20))
few = examples(2, 60)


# The mass centre, its acceleration and the main moment at one position


@st.composite
def weighed(draw: st.DrawFn) -> Loaded:
    """Draw a machine of which some link has mass."""
    one = draw(loaded())
    assume(any(body.mass for body in one.machine.bodies.values()))
    return one


def centre(one: Loaded) -> MassCentre:
    """Find the mass centre of a machine at its crank angle by main points."""
    return mass_centre(MainPoints(tree_of(one.mechanism), one.machine.bodies), one.study, one.study.turn)


@dataclass(frozen=True)
class Slack:
    """How far rounding may have moved a mass centre m, its force N and its moment N*m."""

    place: float
    force: float
    moment: float

    @classmethod
    def of(cls, one: Loaded) -> Slack:
        """Take a share of the largest of each sum."""
        motion, bodies = one.motion, one.machine.bodies.values()
        far = one.size + max(abs(body.centre) for body in bodies)
        bent = max(float(abs(point.a[0])) for point in motion.points.values())
        spun = max(float(abs(1j * turn.epsilon[0] - turn.omega[0] ** 2)) for turn in motion.links.values())
        force = sum(body.mass for body in bodies) * (bent + 2 * far * spun)
        turning = sum(body.inertia for body in bodies) * spun
        return cls(one.margin * far, one.margin * force, one.margin * (far * force + turning))


def alike(
    one: Loaded,
    new: MassCentre,
    place: Callable[[complex], complex] = lambda r: r,
    force: Callable[[complex], complex] = lambda f: f,
    moment: float = 1.0,
) -> None:
    """See that a mass centre is that of a machine, mapped; a map enlarges all that it maps alike."""
    old, slack = centre(one), Slack.of(one)
    assert abs(new.r[0] - place(old.r[0])) <= 2 * abs(place(1 + 0j)) * slack.place
    assert abs(new.force[0] - force(old.force[0])) <= 2 * abs(force(1 + 0j)) * slack.force
    assert abs(new.moment[0] - moment * old.moment[0]) <= 2 * abs(moment) * slack.moment


@few
@given(weighed(), numbers(-180, 180))
def test_everything_turned(one: Loaded, degrees: float) -> None:
    turn = cmath.exp(1j * radians(degrees))
    alike(one, centre(altered.turned(one, radians(degrees))), lambda r: r * turn, lambda f: f * turn)


@few
@given(weighed())
def test_everything_mirrored(one: Loaded) -> None:
    alike(one, centre(altered.mirrored(one)), complex.conjugate, complex.conjugate, -1.0)


@few
@given(weighed(), TIMES)
def test_everything_enlarged(one: Loaded, times: float) -> None:
    new = centre(altered.enlarged(one, times, times, times**2))
    alike(one, new, lambda r: times * r, lambda f: times * f, times**2)


@few
@given(weighed(), st.sampled_from((-1.0, 0.01, 3.0, -3.0)))
def test_a_crank_driven_faster_or_the_other_way_shakes_as_the_square(one: Loaded, times: float) -> None:
    alike(one, centre(altered.quickened(one, times)), force=lambda f: times**2 * f, moment=times**2)


@few
@given(weighed(), st.data())
def test_links_add_their_own(one: Loaded, data: st.DataObject) -> None:
    """What the masses of some links give is the same whether the others have any; links without mass give nothing."""
    bodies = dict(one.machine.bodies)
    chosen = data.draw(st.sets(st.sampled_from(sorted(bodies))))
    parts = [{n: b for n, b in bodies.items() if (n in chosen) == taken} for taken in (True, False)]
    found = [centre(replace(one, machine=replace(one.machine, bodies=part))) for part in parts if part]
    slack, whole = Slack.of(one), centre(one)
    assert abs(sum(part.mass * part.r[0] for part in found) - whole.mass * whole.r[0]) <= 2 * whole.mass * slack.place
    assert abs(sum(part.force[0] for part in found) - whole.force[0]) <= 2 * slack.force
    assert abs(sum(part.moment[0] for part in found) - whole.moment[0]) <= 2 * slack.moment


# Counterweights


@dataclass(frozen=True)
class Asking:
    """A chain with masses and what is asked of it."""

    mechanism: Mechanism
    machine: Machine
    task: BalanceTask

    @property
    def groups(self) -> tuple[Assur, ...]:
        """The groups."""
        return decompose(self.mechanism)

    @property
    def bodies(self) -> Mapping[int, Body]:
        """The masses of the links."""
        return self.machine.bodies

    @cached_property
    def substitution(self) -> Substitution:
        """The masses substituted by construction."""
        return substituted(self.mechanism, self.groups, self.bodies, self.task)

    @cached_property
    def weights(self) -> tuple[Counterweight, ...]:
        """The counterweights by construction."""
        return counterweights(self.substitution, self.groups)

    @property
    def left(self) -> dict[str, complex]:
        """What stays at sliders by construction."""
        return {point: term.value for point, term in self.substitution.left.items()}

    @property
    def by_analysis(self) -> FoundWeights:
        """The counterweights by analysis."""
        return by_vectors(self.mechanism, self.machine, sought(self.mechanism, self.groups, self.task))

    @property
    def size(self) -> float:
        """The largest static moment kg*m of any link's own mass and of the counterweights."""
        far = max(abs(place) for link in self.mechanism.links.values() for place in link.points.values())
        centres = max(abs(body.centre) for body in self.bodies.values())
        return (far + centres) * (sum(b.mass for b in self.bodies.values()) + sum(one.mass for one in self.weights))


@st.composite
def asking(draw: st.DrawFn) -> Asking:
    """Draw a chain that some counterweights balance, in full where they can."""
    mechanism = pointed(draw(chains(most=3)).mechanism)
    its = draw(machines(mechanism))
    assume(any(body.mass for body in its.bodies.values()))
    size = max(abs(place) for link in mechanism.links.values() for place in link.points.values())
    hinged = {mechanism.drive.link} | {
        pair.taker for group in decompose(mechanism) for pair in group.outer_pairs if isinstance(pair.joint, str)
    }
    places = [Site(link, **draw(_weight(size))) for link in sorted(hinged) if draw(st.integers(0, 5))]
    one = Asking(mechanism, its, BalanceTask(draw(st.sampled_from((FULL, PARTIAL))), tuple(places)))
    try:
        _ = one.weights
    except Unmade:
        assume(False)
    return one


def _weight(size: float) -> st.SearchStrategy[dict[str, float]]:
    return st.one_of(
        numbers(0.5, 20).map(lambda mass: {"mass": mass}), numbers(0.1, 1).map(lambda share: {"radius": share * size})
    )


ROUNDINGS = 2.0**12  # of the sum of all static moments: in a chain of groups each divides by its arms once more


few_weights = examples(3, 200)


@few_weights
@given(asking())
def test_both_roads_find_the_same_counterweights(one: Asking) -> None:
    found, slack = one.by_analysis, ROUNDINGS * 2.0**-52 * one.size
    for ours, theirs in zip(one.weights, found.counterweights, strict=True):
        assert (ours.link, ours.begin, ours.origin) == (theirs.link, theirs.begin, theirs.origin)
        assert abs(ours.moment - theirs.moment) <= slack, ours.link
    for point in {*one.left, *found.left}:
        assert one.left.get(point, 0j) == pytest.approx(found.left.get(point, 0j), abs=slack / 0.3), point


@few_weights
@given(asking())
def test_what_is_balanced_already_needs_nothing(one: Asking) -> None:
    """With its counterweights as bodies of its own it needs none, and nothing points anywhere."""
    again = replace(one, machine=with_weights(one.machine, one.weights))
    assert [(new.mass, new.moment) for new in again.weights] == [(0.0, 0j)] * len(one.weights)
    told = again.by_analysis.counterweights
    assert [(new.mass, new.moment) for new in told] == [(0.0, 0j)] * len(one.weights)


WHOLE = {
    "four-bar": (FOUR_BAR, (Site(1, mass=9), Site(2, radius=0.1))),
    "engine": (ENGINE, (Site(1, radius=0.2), Site(2, mass=16))),
    "shaper": (SHAPER, (Site(1, mass=6), Site(3, mass=160), Site(4, radius=0.1))),
}
MASSES = st.lists(numbers(0.1, 9), min_size=5, max_size=5)
CENTRES = st.lists(st.builds(complex, numbers(-0.3, 0.3), numbers(-0.3, 0.3)), min_size=5, max_size=5)


@pytest.mark.parametrize("name", WHOLE)
@few
@given(MASSES, CENTRES)
def test_balanced_in_full_the_frame_holds_nothing(name: str, masses: list[float], centres: list[complex]) -> None:
    """The reactions of the frame sum up to nothing in all positions, where nothing but inertia acts."""
    text, places = WHOLE[name]
    first = study(text, positions=24)
    links = [link for link in first.linkage.mechanism.links if link != FRAME]
    bodies = {n: Body(n, m, 0.01, z) for n, m, z in zip(links, masses, centres, strict=False)}
    its = BalanceStudy(first.linkage, first.statics.bearing(machine(bodies, gravity=0j)), asked(FULL, *places))
    before, after = inertia_alone(its), inertia_alone(BalanceStudy(its.linkage, its.loaded_statics, its.task))
    frame = [one.force for key, one in after.reactions.items() if key.startswith("0-")]
    most = max(np.abs(one.force).max() for held in (before, after) for one in held.reactions.values())
    assert np.abs(np.sum(frame, axis=0)).max() <= 1e-12 * most
