"""The judge: what a mechanism does at one crank angle, in 60 digits, and what one rounding of its data does to that.

Nothing here is taken from either road but a first guess. The unknowns are the origin of every link and its direction, a
complex number of length 1, so that all equations are of the second degree; they are differentiated as power series of
time. They are solved by iterative refinement: residuals in 60 digits, corrections by an inverse in 16.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import mpmath
import numpy as np

from plans.model.mechanism import FRAME, Mechanism
from plans.model.motion import Motion
from tests.trials.rates import AT_REST, Series

MP = mpmath.mp.clone()
MP.dps = 60
ORDERS = 3
ROUNDS = 12  # each gains 16 digits less those of the condition: enough up to a condition of 1e11
CLOSED = MP.mpf(10) ** -50
SAME = 1e-6  # of the mechanism's size: a solution farther than this from the road's is another assembly's
STEP = 2.0**-20  # of a datum: by a central difference a yardstick is true to some percent up to a condition of 1e5
NOTHING = 1e-7  # of the most of its kind: such a difference is the rounding of numbers that do not move
EPS = float(np.finfo(np.float64).eps)

Answers = dict[tuple[str, str], Any]


class Lost(ArithmeticError):  # noqa: N818  (an end, not an error of the judge)
    """The judge found no solution near the road's."""


class Case(NamedTuple):
    """A mechanism's data as numbers, and what its equations do with them, by places in that list."""

    data: list[complex]
    links: list[int]  # the moving ones
    points: dict[tuple[int, str], int]  # a link's point in its own frame
    hinges: list[tuple[int, int, str]]
    slides: list[tuple[tuple[int, int, int], tuple[int, int, int]]]  # link, a point of its line, its direction
    crank: int
    arm: tuple[int, int]  # pivot and end
    drive: tuple[int, int, int]  # crank angle, omega, epsilon
    e: Any  # the crank's direction, of 60 digits, where its angle is as it is given


def case(mechanism: Mechanism, e: Any, phi: float) -> Case:
    """List the data of a mechanism at a crank direction; one rounding of its angle is eps of phi, rad."""
    data: list[complex] = []

    def put(number: complex) -> int:
        data.append(complex(number))
        return len(data) - 1

    points = {(n, p): put(z) for n, link in mechanism.links.items() for p, z in link.points.items()}
    hinges = [(links[0], link, p) for p, links in mechanism.hinges.items() for link in links[1:]]
    slides = [
        ((s.slider, put(s.on_slider.through), put(s.on_slider.direction)),
         (s.owner, put(s.on_owner.through), put(s.on_owner.direction)))
        for s in mechanism.slides
    ]  # fmt: skip
    drive, links = mechanism.drive, [n for n in mechanism.links if n != FRAME]
    arm = points[drive.link, drive.pivot], points[drive.link, drive.end]
    return Case(
        data, links, points, hinges, slides, drive.link, arm, (put(phi), put(drive.omega), put(drive.epsilon)), e
    )


def lead(case: Case, data: Sequence[Any], e: Any, size: Any) -> Series:
    """Give the crank's arm of a size as the drive turns it; e is the crank's direction."""
    arm, (_, omega, epsilon) = size * e, (data[k].real for k in case.drive)
    return Series(arm, 1j * omega * arm, (1j * epsilon - omega * omega) * arm / 2)


def failures(case: Case, data: Sequence[Any], q: Sequence[Series], led: Series) -> list[Series]:
    """Tell by how much the equations fail; those of a hinge and of the crank are two in one, the others real."""
    origins = {FRAME: Series(0j), **dict(zip(case.links, q[: len(case.links)], strict=True))}
    turns = {FRAME: AT_REST, **dict(zip(case.links, q[len(case.links) :], strict=True))}

    def place(link: int, datum: int) -> Series:
        return origins[link].plus(turns[link].by(data[datum]))

    rows = [place(a, case.points[a, p]).less(place(b, case.points[b, p])) for a, b, p in case.hinges]
    rows.append(turns[case.crank].by(data[case.arm[1]] - data[case.arm[0]]).less(led))
    for (slider, on, way), (owner, line, course) in case.slides:
        across = turns[owner].by(data[course]).conjugate
        rows += [
            _real(turns[slider].by(data[way]).times(across)),
            _real(place(slider, on).less(place(owner, line)).times(across)),
        ]
    unit = [turns[link].times(turns[link].conjugate).less(AT_REST) for link in case.links if link != case.crank]
    return rows + unit


def _real(row: Series) -> Series:
    """Turn a row whose imaginary part must vanish into a real one."""
    return Series(*((a + 0j).imag for a in row))


def _columns(case: Case, rows: Sequence[Series], order: int) -> Any:
    """Write the coefficients of an order as one column (or columns) of float64: x and y of the double equations."""
    double = len(case.hinges) + 1
    values = [_plain(row[order]) for row in rows]
    parts = [part for value in values[:double] for part in (value.real, value.imag)]
    return np.array(np.broadcast_arrays(*parts, *(value.real for value in values[double:])))


def _plain(value: Any) -> Any:
    return value if isinstance(value, np.ndarray) else np.complex128(complex(value))


def inverse(case: Case, q: Sequence[complex]) -> Any:
    """Invert the equations' Jacobian at some place, in float64."""
    count = len(q)
    units = np.concatenate((np.eye(count), 1j * np.eye(count)), axis=1)
    moved = [Series(np.full(2 * count, z), units[k]) for k, z in enumerate(q)]
    return np.linalg.inv(_columns(case, failures(case, case.data, moved, Series(np.zeros(2 * count))), 1))


def _corrected(q: Sequence[Series], order: int, step: Any) -> list[Series]:
    """Take a correction from the coefficients of an order."""
    both = step[: len(q)] + 1j * step[len(q) :]
    return [z._replace(**{Series._fields[order]: z[order] - _digits(d)}) for z, d in zip(q, both, strict=True)]


def _digits(value: Any) -> Any:
    return value if np.ndim(value) else MP.mpc(complex(value))


def solved(case: Case, guess: Sequence[complex], same: float = SAME) -> list[Series]:
    """Solve the equations near a guess, to 50 digits, up to accelerations."""
    back = inverse(case, guess)
    data = [MP.mpc(z) for z in case.data]
    led = lead(case, data, case.e, abs(data[case.arm[1]] - data[case.arm[0]]))
    q = [Series(MP.mpc(z), MP.mpc(0), MP.mpc(0)) for z in guess]
    for order in range(ORDERS):
        for _ in range(ROUNDS):
            step = back @ _columns(case, failures(case, data, q, led), order)
            q = _corrected(q, order, step)
            if np.abs(step).max() <= CLOSED * max(1.0, *(float(abs(z[order])) for z in q)):
                break
        else:
            raise Lost(f"the corrections of order {order} do not end")
    apart = max(float(abs(z.z - own)) for z, own in zip(q, guess, strict=True))
    if not apart <= same * max(1.0, *map(abs, guess)):
        raise Lost(f"the solution is {apart:.3g} from the road's")
    return q


def guess(case: Case, motion: Motion, mechanism: Mechanism, position: int) -> list[complex]:
    """Read origins and directions of the links off a road's motion."""
    turns = {link: cmath.exp(1j * float(motion.links[link].angle[position])) for link in case.links}
    first = {link: next(iter(mechanism.links[link].points.items())) for link in case.links}
    origins = [complex(motion.points[p].r[position]) - own * turns[link] for link, (p, own) in first.items()]
    return [*origins, *turns.values()]


def answers(case: Case, data: Sequence[Any], q: Sequence[Series]) -> Answers:
    """Give places, velocities and accelerations of points, directions and rates of links."""
    found: Answers = {}
    for k, link in enumerate(case.links):
        origin, turn = q[k], q[k + len(case.links)]
        back = (turn.z + 0j).conjugate()
        found["angle", str(link)] = turn.z
        found["omega", str(link)] = (turn.first * back).imag
        found["epsilon", str(link)] = 2 * (turn.half * back).imag
        for (owner, point), datum in case.points.items():
            if owner == link and (FRAME, point) not in case.points:
                r, v, half = origin.plus(turn.by(data[datum]))
                found["r", point], found["v", point], found["a", point] = r, v, 2 * half
    return found


def roundings(case: Case, q: Sequence[Series]) -> dict[tuple[str, str], float]:
    """Tell what one rounding of the data does to every answer: eps of each, their effects added up.

    What no datum moves, as the turn of a block in a guide of the frame, is moved as much as the most of its kind: its
    true nought is the difference of such numbers. And an answer is itself rounded: a direction to eps.
    """
    moved = np.array([*_moved(case)]).T  # (data, twice the number of coordinates that are not nought)
    back = inverse(case, [complex(z.z) for z in q])
    e = complex(case.e) * np.exp(1j * (moved[case.drive[0]] - case.data[case.drive[0]]))
    led = lead(case, moved, e, np.abs(moved[case.arm[1]] - moved[case.arm[0]]))
    still = [Series(*(np.full(moved.shape[1], complex(c)) for c in z)) for z in q]
    for order in range(ORDERS):
        still = _corrected(still, order, back @ _columns(case, failures(case, moved, still, led), order))
    found = answers(case, moved, still)
    one = {key: _summed(values) for key, values in found.items()}
    most = {kind: max(value for (k, _), value in one.items() if k == kind) for kind, _ in one}
    # A link that gains no speed is found to gain none by differences of numbers of the size of omega squared.
    most["epsilon"] = max(most["epsilon"], EPS * abs(case.data[case.drive[1]]) ** 2)
    own = {key: EPS * float(np.abs(values).mean()) for key, values in found.items()}
    return {key: own[key] + (value if value > NOTHING * most[key[0]] else most[key[0]]) for key, value in one.items()}


def _moved(case: Case) -> Iterator[list[complex]]:
    """Move each coordinate of the data by a small share of it, to and fro."""
    for k, number in enumerate(case.data):
        for part in (number.real, 1j * number.imag):
            for sign in (1, -1) if part else ():
                yield [*case.data[:k], number + sign * STEP * part, *case.data[k + 1 :]]


def _summed(values: Any) -> float:
    there, back = np.reshape(values, (-1, 2)).T
    return float(np.abs(there - back).sum() / (2 * STEP) * EPS)
