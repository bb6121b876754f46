"""The lever's equation with the numbers of one position put in: forces, their arms, the moment (рычаг Жуковского)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from drawings.note.cut_equations import CutEquations
from drawings.report.formula import display, inline
from drawings.report.markdown import header, row
from geometry.board import Mark
from plans.forces.lever import Lever
from plans.model.kinetostatics import NOTHING
from plans.words.words import word


def lever_equation(lever: Lever, written: CutEquations, mu: float) -> Iterator[str]:
    """Write the moments of all forces about the pole of the turned plan, and the balancing moment that they ask for.

    `mu` is the lever's scale, (m/s)/mm: the moments on paper, N*mm, times the scale are powers, W.
    """
    formula, drive = written.formula, written.values.plan.mechanism.drive
    language, sigma = formula.drafting.language, formula.letter("Σ")
    powers = _powers(lever, written)
    yield word(language, "report.lever")
    yield from display(rf"{sigma} M_{{p}}(F_{{i}}) + M_{{p}}({formula.letter('P_bal')}) = 0")
    yield from header([word(language, f"table.{head}") for head in ("force", "size", "lever_arm", "lever_moment")])
    forces = {one.name: one.force for one in lever.loads}
    for name, power in powers.items():
        yield _row(name, power / mu, forces.get(name), written)
    whole, omega = _sum(powers), written.values.rate
    yield row([f"${sigma}$", "", "", f"${formula.number(whole / mu)}$"])
    yield ""
    letters = f"-{formula.letter('μ_v')} {sigma} M_{{p}} / {formula.letter(f'ω_{drive.link}')}"
    product = rf"-{formula.number(mu)} \cdot {formula.factor(whole / mu)} / {formula.factor(omega)}"
    moment = formula.quantity(-whole / omega, "N*m")
    yield f"- {inline(formula.letter('M_bal'), letters, product, moment)}"


def _powers(lever: Lever, written: CutEquations) -> dict[str, float]:
    """Give the powers of all forces and couples, W; one of a moment on the shaft that is none is none either."""
    powers = {name: written.values.power(name, mark) for name, mark in lever.moments}
    least = written.nothing[1] * abs(written.values.rate)
    return {name: power if abs(power) > least else 0.0 for name, power in powers.items()}


def _sum(powers: Mapping[str, float]) -> float:
    """Add powers up; what is but rounding of the largest is none."""
    whole = sum(powers.values())
    return whole if abs(whole) > NOTHING * max(map(abs, powers.values())) else 0.0


def _row(name: str, moment: float, force: Mark | None, written: CutEquations) -> str:
    """Write a force with its arm, mm; a couple has its moment alone."""
    formula = written.formula
    size = 0.0 if force is None else abs(written.values.force(name, force))
    cells = ["", ""]
    if size > written.nothing[0]:
        cells = [f"${formula.number(size)}$", f"${formula.number(abs(moment) / size)}$"]
    return row([f"${written.letter(name)}$", *cells, f"${formula.number(moment)}$"])
