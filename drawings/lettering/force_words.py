"""The words of a force sheet, English and Russian, and its letters as either language writes them (силовой расчёт)."""

from __future__ import annotations

import re
from typing import Final

FORCES: Final[dict[str, tuple[str, str]]] = {
    "forces sheet title": ("Force analysis of the mechanism", "Силовой расчёт механизма"),
    "loading scheme": ("Loading scheme of group {group}", "Схема нагружения группы {group}"),
    "primary scheme": ("Loading scheme of the primary link", "Схема нагружения начального звена"),
    "force plan": ("Force plan of group {group}", "План сил группы {group}"),
    "primary force plan": ("Force plan of the primary link", "План сил начального звена"),
    "group": ("group {group}", "группа {group}"),
    "primary link": ("primary link", "начальное звено"),
    "balancing moment": ("balancing moment", "уравновешивающий момент"),
    "balancing force": ("balancing force", "уравновешивающая сила"),
    "balancing swing": ("Balancing moment over the swing", "График уравновешивающего момента"),
    "balancing graph": ("Balancing moment over a turn", "График уравновешивающего момента"),
    "lever": ("Zhukovsky's lever", "Рычаг Жуковского"),
    "turned velocity plan": ("turned velocity plan", "повёрнутый план скоростей"),
    "by lever": ("by the lever", "по рычагу"),
    "by power": ("by power", "по мощностям"),
    "by energy": ("by energy", "по энергии"),
    "hodograph": ("Hodograph of {letter}", "Годограф реакции {letter}"),
    "hodographs": ("Hodographs of reactions", "Годографы реакций"),
    "reaction": ("reaction", "реакция"),
    "reactions": ("Reactions", "Реакции"),
    "not to scale": ("forces not to scale", "силы не в масштабе"),
    "arm": ("arm", "плечо"),
    "arms": ("Arms, mm:  {arms}", "Плечи, мм:  {arms}"),
    "weights": ("Weights, N:  {weights}", "Силы тяжести, Н:  {weights}"),
    "inertia": ("Inertia:  {forces}", "Силы инерции:  {forces}"),
    "couples": ("Moments of inertia forces, N·m:  {moments}", "Моменты сил инерции, Н·м:  {moments}"),
    "gear force": ("force in the gear", "сила в зацеплении"),
    "pressure angle": ("pressure angle", "угол давления"),
    "line of action": ("line of action", "линия зацепления"),
    "friction": ("Friction", "Трение"),
    "friction index": ("power lost {power}", "теряется {power}"),
    "useful index": ("useful power {power}", "полезная мощность {power}"),
    "cycle efficiency": ("over the cycle η = {eta}", "за цикл η = {eta}"),
    "wear": ("Shares of the work of friction by pairs", "Доли работы трения по парам"),
    "jams": (
        "Jams by friction: pairs {pairs}, positions {positions}", "Самоторможение: пары {pairs}, положения {positions}",
    ),
    "spring": ("spring", "пружина"),
    "coupling": ("coupling", "муфта"),
    "forces of lever": (
        "Lever: F·h·μ_v, W:  {powers};  together {total};  {force}·h·μ_v = {drive}",
        "Рычаг: F·h·μ_v, Вт:  {powers};  вместе {total};  {force}·h·μ_v = {drive}",
    ),
    "known lines": (
        "Under a force: one line where only its direction is known, two where all of it is. Lengths and arms are true",
        "Под силой одна черта - известно её направление, две - известна вся. Длины и плечи натуральные",
    ),
    "load always": ("{name} = {size}", "{name} = {size}"),
    "load against": ("{name} = {size} against the motion of {point}", "{name} = {size} против движения точки {point}"),
    "load diagram": ("{name} by its diagram over the stroke", "{name} по диаграмме на ходу"),
    "working stroke": ("working stroke", "рабочий ход"),
    "idle stroke": ("idle stroke", "холостой ход"),
    "overrun": ("overrun {share} H", "перебег {share} H"),
    "spring given": ("{name}: c = {stiffness}, free length {free}", "{name}: c = {stiffness}, свободная длина {free}"),
    "gear given": (
        "gear: r = {radius}, at {at}°, α = {pressure}°", "колесо: r = {radius}, полюс под {at}°, α = {pressure}°",
    ),
    "coefficients": ("Friction, f = {f}", "Трение, f = {f}"),
    "unlettered": ("too short to be lettered: {names}", "слишком коротки для обозначения: {names}"),
    "no forces": (
        "no force plan in position {position}: {reason}", "план сил в положении {position} не строится: {reason}",
    ),
    "unloaded": ("no force acts: every reaction is zero", "силы не действуют: все реакции равны нулю"),
    "kg": ("kg", "кг"), "W": ("W", "Вт"), "N/m": ("N/m", "Н/м"), "°": ("°", "°"),
}  # fmt: skip
# Letters of Russian courses: the index of the useful resistance (полезное сопротивление), of balance, and of the
# tangential part of a reaction.
RUSSIAN: Final = {"us": "п.с", "bal": "ур", "t": "τ"}
_INDEX = re.compile(r"(?<=\^)t(?![a-z])|(?<=[_{])(?:us|bal)(?=}|$)")


def letter(language: str, markup: str) -> str:
    """Write a letter of a force sheet as courses of a language do.

    >>> letter("ru", "R^t_{34}"), letter("ru", "M_{bal}"), letter("ru", "F_{us}"), letter("en", "M_{bal}")
    ('R^τ_{34}', 'M_{ур}', 'F_{п.с}', 'M_{bal}')
    """
    return _INDEX.sub(lambda found: RUSSIAN[found[0]], markup) if language == "ru" else markup
