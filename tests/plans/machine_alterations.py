"""A machine altered as a whole: turned, mirrored, enlarged, driven faster, made heavier, renamed, split in parts."""

from __future__ import annotations

import cmath
from collections.abc import Callable
from dataclasses import replace
from math import degrees

from plans.model.machine import Body, Force, Machine, Moment, Spring
from tests.plans.alterations import moved
from tests.plans.loaded import Loaded
from tests.plans.studies import driven


def altered(
    machine: Machine,
    body: Callable[[Body], Body] = lambda body: body,
    force: Callable[[Force], Force] = lambda force: force,
    moment: Callable[[Moment], Moment] = lambda moment: moment,
    spring: Callable[[Spring], Spring] = lambda spring: spring,
) -> Machine:
    """Change all bodies and loads of a machine, each in its own way."""
    return replace(
        machine,
        bodies={one.link: one for one in map(body, machine.bodies.values())},
        forces=tuple(map(force, machine.forces)),
        moments=tuple(map(moment, machine.moments)),
        springs=tuple(map(spring, machine.springs)),
    )


def turned(one: Loaded, angle: float) -> Loaded:
    """Turn frame, gravity, loads and the gear's place by an angle, rad."""
    turn, gear = cmath.rect(1.0, angle), one.machine.transmission
    its = altered(one.machine, force=lambda f: f._replace(direction=f.direction and f.direction * turn))
    its = replace(its, gravity=its.gravity * turn, transmission=gear._replace(at=gear.at + angle))
    return Loaded(moved(one.mechanism, lambda z: z * turn), its, one.phi + degrees(angle))


def mirrored(one: Loaded) -> Loaded:
    """Mirror everything in the x axis, links and all; the crank turns the other way."""
    mechanism, drive = moved(one.mechanism, complex.conjugate, complex.conjugate), one.mechanism.drive
    its = altered(
        one.machine,
        body=lambda b: b._replace(centre=b.centre.conjugate()),
        force=lambda f: f._replace(at=f.at.conjugate(), direction=f.direction and f.direction.conjugate()),
        # Against the motion is against the mirrored motion.
        moment=lambda m: m if m.against else m._replace(size=-m.size),
        spring=lambda s: s._replace(at=(s.at[0].conjugate(), s.at[1].conjugate())),
    )
    gear = its.transmission
    its = replace(its, gravity=its.gravity.conjugate(), transmission=gear._replace(at=-gear.at))
    return Loaded(driven(mechanism, -drive.omega, -drive.epsilon), its, -one.phi)


def enlarged(one: Loaded, times: float, force: float, moment: float) -> Loaded:
    """Multiply all lengths, masses staying as they are; forces and gravity, and moments, by their own factors."""
    its = altered(
        one.machine,
        body=lambda b: b._replace(inertia=b.inertia * times**2, centre=b.centre * times),
        force=lambda f: f._replace(at=f.at * times, size=f.size * force),
        moment=lambda m: m._replace(size=m.size * moment),
        spring=lambda s: s._replace(
            at=(s.at[0] * times, s.at[1] * times), free=s.free * times, stiffness=s.stiffness * force / times
        ),
    )
    gear = its.transmission
    its = replace(its, gravity=its.gravity * force, transmission=gear._replace(radius=gear.radius * times))
    return Loaded(moved(one.mechanism, lambda z: z * times, lambda z: z * times), its, one.phi)


def quickened(one: Loaded, times: float) -> Loaded:
    """Drive the crank so many times as fast, gravity and loads the square of it as large."""
    drive = one.mechanism.drive
    its = replace(loads_times(one.machine, times**2), gravity=one.machine.gravity * times**2)
    return replace(one, mechanism=driven(one.mechanism, times * drive.omega, times**2 * drive.epsilon), machine=its)


def loads_times(machine: Machine, factor: float) -> Machine:
    """Multiply all loads and springs."""
    return altered(
        machine,
        force=lambda f: f._replace(size=f.size * factor),
        moment=lambda m: m._replace(size=m.size * factor),
        spring=lambda s: s._replace(stiffness=s.stiffness * factor),
    )


def massless(machine: Machine) -> Machine:
    """Take all masses away; loads and springs are left."""
    return replace(machine, bodies={}, gravity=0j)
