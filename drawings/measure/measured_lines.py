"""What a sheet shows, line by line in the words of a language: its marks, profiles, what is left aside (таблица)."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from drawings.measure.measure import Measured
from drawings.measure.measured import MarkKey
from plans.words.words import message, term, word, words

WIDTH = 14  # letters of the column of plans, at the least


def lines(measured: Measured, off: Collection[MarkKey], language: str) -> Iterator[str]:
    """Give a line of each mark in true units, of each profile, and of all that is left aside; `off` differ."""
    names = {one.plan: plan_name(one.plan, language) for one in (*measured.marks, *measured.profiles)}
    wide = max((WIDTH, *map(len, names.values())))
    for mark in measured.marks:
        value = word(language, "measure.value", x=f"{mark.value.real:.6g}", y=f"{mark.value.imag:.6g}")
        position = "" if mark.position is None else str(mark.position)
        unit, sign = term(language, "text_unit", mark.unit), _sign(mark.key, off, language)
        yield f"{names[mark.plan]:<{wide}} {position:>4}  {mark.name:<10} {value:<26} {unit:<6} {sign}".rstrip()
    for one in measured.profiles:
        within, to = f"{one.deviation:.2g}", f"{one.quantum:.1g}"
        told = word(language, "measure.profile", count=len(one.pieces), within=within, to=to)
        sign = _sign(one.key, off, language)
        yield f"{names[one.plan]:<{wide}} {'':>4}  {one.name:<10} {told}  {sign}".rstrip()
    yield from (message("aside.note", note=note).worded(language) for note in measured.notes)


def plan_name(plan: str, language: str) -> str:
    """Name a plan, or a figure of a group, in the words of a language.

    >>> plan_name("velocities", "ru"), plan_name("forces-2-3", "ru"), plan_name("v", "ru")
    ('план скоростей', 'план сил 2-3', 'v')
    """
    kind, _, which = plan.partition("-")
    if which and f"figure.{kind}" in words(language) and f"plan.{plan}" not in words(language):
        return word(language, f"figure.{kind}", which=which)
    return term(language, "plan", plan)


def _sign(key: MarkKey, off: Collection[MarkKey], language: str) -> str:
    return word(language, "measure.off") if key in off else ""
