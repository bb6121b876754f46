"""The counterweights of a mechanism: its masses substituted group by group, the crank last (8.8), (8.9)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from plans.balance.refusals import IDLE, NO_SHARE, Refused
from plans.balance.substitution import KINDS, Substitution, instead_of_crank
from plans.balance.sums import Term
from plans.balance.weights import begins
from plans.model.balance.linkage import NONE, SHARE, Counterweight, Task
from plans.model.dyad import Dyad
from plans.model.group import Group
from plans.model.machine import Body
from plans.model.mechanism import FRAME, Mechanism
from plans.words.words import because


def substituted(
    mechanism: Mechanism, groups: Sequence[Group], bodies: Mapping[int, Body], task: Task, share: float = 0.0
) -> Substitution:
    """Find the counterweights that a task asks for, the crank's with a share of the reciprocating mass."""
    found = Substitution(mechanism, bodies, task)
    if task.aim == NONE:
        return found
    _check_places(mechanism, groups, task)
    for group in reversed(groups):
        assert isinstance(group, Dyad)  # the only groups that a mechanism is broken into
        KINDS[group.kind](found, group)
    drive = mechanism.drive
    if task.aim == SHARE:
        _share(found, groups, share)
    for rod in (one for one in groups if isinstance(one, Dyad) and instead_of_crank(mechanism, task, one)):
        found.balance_by_rod(rod, drive.pivot)
    found.balance(drive.link, drive.pivot, (drive.link,))
    return found


def counterweights(found: Substitution, groups: Sequence[Group]) -> tuple[Counterweight, ...]:
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


def reciprocating(mechanism: Mechanism, groups: Sequence[Group], task: Task) -> dict[str, str]:
    """Give the sliders of the frame whose rods hang on the crank and carry nothing, each with the crank's pin."""
    crank = mechanism.links[mechanism.drive.link].points
    rods = (group for group in groups if isinstance(group, Dyad) and group.kind == "RRP")
    return {
        rod.pin: rod.hinge(0)
        for rod in rods
        if rod.hosts[1] == FRAME and rod.hinge(0) in crank and task.place(rod.links[0]) is None
    }


def _share(found: Substitution, groups: Sequence[Group], share: float) -> None:
    """Load the crank with a share of the masses that are left at the sliders whose rods hang on it."""
    crank, hung = found.mechanism.drive.link, reciprocating(found.mechanism, groups, found.task)
    if not hung:
        raise Refused(NO_SHARE)
    for slider, pin in hung.items():
        whole = found.left.get(slider, found.sums.no_mass)
        mark = found.sums.masses.turn(f"k·m_{slider}", whole.mark, share, because("share_of_mass", point=slider))
        found.put(crank, pin, found.at_point(crank, pin), Term(mark, whole.size * share))


def _check_places(mechanism: Mechanism, groups: Sequence[Group], task: Task) -> None:
    """Refuse a counterweight on a link that has no hinge to turn it about."""
    points = begins(mechanism, groups)
    for place in task.places:
        if place.link not in points:
            raise Refused(IDLE, place.link, links=tuple(str(link) for link in sorted(points)))
