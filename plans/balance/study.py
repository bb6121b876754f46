"""The study of a balance: main points, counterweights, the machine before and after, each made once (баланс)."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import replace
from functools import cached_property

from plans.balance import shares as states
from plans.balance.mass_centre import EMPTY, Drawing, MainPoints
from plans.balance.shares import Superposition
from plans.balance.substitution import KINDS, Substitution, instead_of_crank
from plans.balance.sums import SumTerm
from plans.balance.weights import IDLE, NO_SHARE, Tree, Unmade, begins, tree_of
from plans.forces.statics import Statics
from plans.linkage.drafts import Drafts
from plans.linkage.study import LinkageStudy
from plans.model.balance.linkage import (
    CONSTRUCTION,
    NONE,
    SHARE,
    Balance,
    BalanceTask,
    Choice,
    Counterweight,
    Shares,
    State,
)
from plans.model.dyad import Assur, Dyad
from plans.model.machine import Body, Machine
from plans.model.mechanism import FRAME, Mechanism
from plans.words.words import because


def substituted(
    mechanism: Mechanism, groups: Sequence[Assur], bodies: Mapping[int, Body], task: BalanceTask, share: float = 0.0
) -> Substitution:
    """Find the counterweights that a task asks for, the crank's with a share of the reciprocating mass."""
    found = Substitution(mechanism, bodies, task)
    if task.aim == NONE:
        return found
    points = begins(mechanism, groups)
    for place in task.places:
        if place.link not in points:
            raise Unmade(IDLE, place.link, links=tuple(str(link) for link in sorted(points)))
    for group in reversed(groups):
        assert isinstance(group, Dyad)  # the only groups that a mechanism is broken into
        KINDS[group.kind](found, group)
    drive = mechanism.drive
    if task.aim == SHARE:
        _share(found, groups, share)
    for rod in (dyad for dyad in groups if isinstance(dyad, Dyad) and instead_of_crank(mechanism, task, dyad)):
        found.balance_by_rod(rod, drive.pivot)
    found.balance(drive.link, drive.pivot, (drive.link,))
    return found


def counterweights(found: Substitution, groups: Sequence[Assur]) -> tuple[Counterweight, ...]:
    """Give a counterweight for each link that may carry one, in the order of the scene; one not needed has no mass."""
    task, mechanism = found.task, found.mechanism
    if task.aim == NONE:
        return ()
    points = begins(mechanism, groups)
    none = {
        place.link: Counterweight(place, points[place.link], found.at_point(place.link, points[place.link]), 0j, 0.0)
        for place in task.places
    }
    return tuple((none | found.counterweights)[place.link] for place in task.places)


def reciprocating(mechanism: Mechanism, groups: Sequence[Assur], task: BalanceTask) -> dict[str, str]:
    """Give the sliders of the frame whose rods hang on the crank and carry nothing, each with the crank's pin."""
    crank = mechanism.links[mechanism.drive.link].points
    rods = (group for group in groups if isinstance(group, Dyad) and group.kind == "RRP")
    hung = (rod for rod in rods if rod.hosts[1] == FRAME and rod.hinge(0) in crank)
    return {rod.pin: rod.hinge(0) for rod in hung if task.place(rod.links[0]) is None}


def _share(found: Substitution, groups: Sequence[Assur], share: float) -> None:
    """Load the crank with a share of the masses that are left at the sliders whose rods hang on it."""
    crank, hung = found.mechanism.drive.link, reciprocating(found.mechanism, groups, found.task)
    if not hung:
        raise Unmade(NO_SHARE)
    for slider, pin in hung.items():
        whole = found.left.get(slider, found.sums.no_mass)
        mark = found.sums.masses.turn(f"k·m_{slider}", whole.mark, share, because("share_of_mass", point=slider))
        found.put(crank, pin, found.at_point(crank, pin), SumTerm(mark, whole.size * share))


def loaded(machine: Machine, counterweights: Iterable[Counterweight]) -> Machine:
    """Put the counterweights that are needed on the links of a machine."""
    bodies = dict(machine.bodies)
    for weight in counterweights:
        if weight.needed:
            bodies[weight.link] = _with(bodies.get(weight.link, EMPTY._replace(link=weight.link)), weight)
    return replace(machine, bodies=dict(sorted(bodies.items())))


def _with(body: Body, weight: Counterweight) -> Body:
    """Join a counterweight to a link: the new centre divides their distance, and inertia counts about it (Steiner)."""
    mass = body.mass + weight.mass
    apart = weight.centre - body.centre
    # Of a heavy one on a light link nothing is lost.
    centre = (body.mass * body.centre + weight.mass * weight.centre) / mass
    inertia = body.inertia + weight.inertia + abs(apart) ** 2 * (body.mass * weight.mass / mass)
    return Body(body.link, mass, inertia, centre)


PLANS = CENTRE, COUNTERWEIGHTS, COSTS = "centre", "counterweights", "costs"


class BalanceStudy:
    """A mechanism with its masses, and what balances it by construction; nothing is made before it is asked for."""

    def __init__(self, linkage: LinkageStudy, statics: Statics, task: BalanceTask) -> None:
        self.linkage, self.statics, self.task = linkage, statics, task
        self.made: dict[str, None] = {}  # what was made, in order

    def construct(self, plans: Collection[str]) -> None:
        """Make what is asked for, at all positions of the scene."""
        if CENTRE in plans:
            _ = self.before
        if COUNTERWEIGHTS in plans:
            _ = self.counterweights
        if COSTS in plans:
            _ = self.after, self.shares

    @cached_property
    def machine(self) -> Machine:
        """The machine as the scene has it."""
        return self.statics.machine

    @cached_property
    def tree(self) -> Tree:
        """The stems of all moving links."""
        return tree_of(self.linkage.mechanism)

    @cached_property
    def substitution(self) -> Substitution:
        """The masses on their way to the crank, with what the counterweights must be."""
        self.made.setdefault(COUNTERWEIGHTS)
        return self._substituted(self.task, self.share)

    def _substituted(self, task: BalanceTask, share: float) -> Substitution:
        """Find the counterweights with a share of the reciprocating mass; what cannot be is a SceneError."""
        linkage = self.linkage
        try:
            return substituted(linkage.mechanism, linkage.groups, self.machine.bodies, task, share)
        except Unmade as refused:
            raise refused.fault(linkage.scene, task) from None

    @cached_property
    def share(self) -> float:
        """The share of the reciprocating mass: the given one, or that by which a largest force is least; 0 of none."""
        return (self.task.share or 0.0) if self.task.share is not None or self.best is None else self.best.share

    @property
    def best(self) -> Choice | None:
        """The choice of a share that makes least what the task asks for; None where none is asked for."""
        return self.shares.best(self.task.least) if self.shares else None

    def at_share(self, share: float) -> Machine:
        """Give the machine balanced with a share, on whichever side of the shaft its counterweight then lies."""
        places = tuple(p if p.at is None else p._replace(at=None, radius=abs(p.at)) for p in self.task.places)
        found = self._substituted(self.task._replace(places=places), share)
        return loaded(self.machine, counterweights(found, self.linkage.groups))

    @cached_property
    def counterweights(self) -> tuple[Counterweight, ...]:
        """The counterweights, in the order of the scene."""
        return counterweights(self.substitution, self.linkage.groups)

    @property
    def left(self) -> Mapping[str, complex]:
        """The masses kg that stay at sliders, by letter."""
        return {point: term.value for point, term in self.substitution.left.items()}

    @cached_property
    def loaded(self) -> Machine:
        """The machine with its counterweights on."""
        return loaded(self.machine, self.counterweights)

    @cached_property
    def loaded_statics(self) -> Statics:
        """The forces with the counterweights on."""
        return self.statics.bearing(self.loaded)

    @cached_property
    def points_before(self) -> MainPoints:
        """The main points of the mechanism as it is."""
        self.made.setdefault(CENTRE)
        return MainPoints(self.tree, self.machine.bodies)

    @cached_property
    def points_after(self) -> MainPoints:
        """The main points with the counterweights on."""
        return MainPoints(self.tree, self.loaded.bodies)

    def points(self, after: bool = False) -> MainPoints:
        """Give the main points before or after balancing."""
        return self.points_after if after else self.points_before

    def drawing(self, after: bool = False, position: int | None = None) -> Drawing:
        """Draw the mass centre over all positions of the scene, or at one."""
        chosen = slice(None) if position is None else [position]
        return states.drawing(self.points(after), Drafts(self.linkage, self.linkage.turn.part(chosen)))

    @cached_property
    def before(self) -> State:
        """The machine as it is."""
        return states.state(self.points_before, self.statics)

    @cached_property
    def after(self) -> State | None:
        """The machine with its counterweights on; None where nothing is asked for."""
        if self.task.aim == NONE:
            return None
        self.made.setdefault(COSTS)
        after = states.state(self.points_after, self.loaded_statics)
        return replace(after, beside=self.before.forces.largest)

    @cached_property
    def shares(self) -> Shares | None:
        """The share of the reciprocating mass as a choice; None where it is not asked for."""
        if self.task.aim != SHARE:
            return None
        return Superposition(self.statics, self.tree, self.at_share).shares

    @cached_property
    def balance(self) -> Balance:
        """What balances the mechanism."""
        gaps = self.linkage.motion(2).gaps
        states = self.before, self.after
        return Balance(CONSTRUCTION, self.task, self.counterweights, self.left, *states, self.shares, gaps)
