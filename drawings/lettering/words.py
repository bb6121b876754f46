"""The words of a sheet in its language (en, ru), and its numbers: a decimal comma on Russian sheets."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Final

from drawings.lettering.force_words import FORCES
from drawings.lettering.rotor_words import ROTOR
from drawings.paper.strokes import SheetError

# The words of page and title block, and units: English, Russian.
PAGE: Final[dict[str, tuple[str, str]]] = {
    "copied": ("Copied", "Копировал"), "format": ("Format {format}", "Формат {format}"),
    "original": ("Inv. no. orig.", "Инв. № подл."), "signed": ("Sign. and date", "Подп. и дата"),
    "replaces": ("Repl. inv. no.", "Взам. инв. №"), "duplicate": ("Inv. no. dupl.", "Инв. № дубл."),
    "department field": ("Resp. dept.", "Подразд."), "checked by field": ("Checked by", "Проверил"),
    "creator field": ("Created by", "Разработал"), "approval field": ("Approved by", "Утвердил"),
    "scale field": ("Scale", "Масштаб"), "owner field": ("Legal owner", "Владелец"),
    "type field": ("Document type", "Вид документа"), "status field": ("Document status", "Статус документа"),
    "title field": ("Title, supplementary title", "Наименование"), "revision field": ("Rev.", "Изм."),
    "number field": ("Identification number", "Обозначение"), "issued field": ("Date of issue", "Дата выпуска"),
    "code field": ("Lang.", "Язык"), "sheet field": ("Sheet", "Лист"),
    "document type": ("Graphical analysis", "Графический расчёт"),
    "N": ("N", "Н"), "N*m": ("N·m", "Н·м"), "J": ("J", "Дж"), "s": ("s", "с"), "rad": ("rad", "рад"),
    "kg*m2": ("kg·m²", "кг·м²"),
}  # fmt: skip
WORDS: Final[dict[str, dict[str, str]]] = {
    "en": {
        "positions": "Plan of positions",
        "velocities": "Velocity plan, position {position}",
        "accelerations": "Acceleration plan, position {position}",
        "position": "position {position}",
        "quantity": "Quantity",
        "by plan": "by plan",
        "by analysis": "by analysis",
        "difference": "diff., %",
        "structure": "Structure: W = 3·{n} − 2·{p} = {w};  {formula};  class {klass}",
        "lengths": "Lengths, mm:  {lengths}",
        "stroke": "Stroke H = {stroke} m",
        "swing": "Swing of link {link}: ψ = {stroke}°",
        "overlap": "time-ratio angle θ = {overlap}°;  K = {ratio}",
        "reversals": "the output reverses {count} times in a turn: no time ratio",
        "pressure": "Pressure angle of group {group}: {low}° … {high}°",
        "gap": "Gaps: {positions}: {reason} at {where}",
        "crank": "ω_{link} = {omega} rad/s, ε_{link} = {epsilon} rad/s²",
        "at rest": "at rest: every velocity is zero",
        "no plan": "no {plan} in position {position}: {reason}",
        "sheet title": "Kinematics of the mechanism",
        "drawn": "Drawn",
        "checked": "Checked",
        "approved": "Approved",
        "letter": "Lit.",
        "mass": "Mass",
        "scale": "Scale",
        "sheet": "Sheet",
        "sheets": "Sheets",
        "change": "Ch.",
        "page": "Sheet",
        "document": "Doc. no.",
        "signature": "Sign.",
        "date": "Date",
        "technical": "Techn.",
        "norms": "Norms",
        "m/s": "m/s",
        "m/s2": "m/s²",
        "rad/s": "rad/s",
        "rad/s2": "rad/s²",
        "m": "m",
        "mm": "mm",
        **{key: english for key, (english, _) in (PAGE | FORCES | ROTOR).items()},
    },
    "ru": {
        "positions": "План положений механизма",
        "velocities": "План скоростей, положение {position}",
        "accelerations": "План ускорений, положение {position}",
        "position": "положение {position}",
        "quantity": "Величина",
        "by plan": "по плану",
        "by analysis": "аналитически",
        "difference": "расх., %",
        "structure": "Строение: W = 3·{n} − 2·{p} = {w};  {formula};  класс {klass}",
        "lengths": "Длины, мм:  {lengths}",
        "stroke": "Ход H = {stroke} м",
        "swing": "Размах звена {link}: ψ = {stroke}°",
        "overlap": "угол перекрытия θ = {overlap}°;  K = {ratio}",
        "reversals": "выходное звено меняет направление {count} раза за оборот",
        "pressure": "Угол давления группы {group}: {low}° … {high}°",
        "gap": "Разрывы: {positions}: {reason}, {where}",
        "crank": "ω_{link} = {omega} рад/с, ε_{link} = {epsilon} рад/с²",
        "at rest": "механизм неподвижен: все скорости равны нулю",
        "no plan": "{plan} в положении {position} не строится: {reason}",
        "sheet title": "Кинематическое исследование механизма",
        "drawn": "Разраб.",
        "checked": "Пров.",
        "approved": "Утв.",
        "letter": "Лит.",
        "mass": "Масса",
        "scale": "Масштаб",
        "sheet": "Лист",
        "sheets": "Листов",
        "change": "Изм.",
        "page": "Лист",
        "document": "№ докум.",
        "signature": "Подп.",
        "date": "Дата",
        "technical": "Т.контр.",
        "norms": "Н.контр.",
        "m/s": "м/с",
        "m/s2": "м/с²",
        "rad/s": "рад/с",
        "rad/s2": "рад/с²",
        "m": "м",
        "mm": "мм",
        "out of reach": "не собирается",
        "dead centre": "мёртвое положение",
        "change point": "точка ветвления",
        "beyond a change point": "за точкой ветвления",
        "not reachable": "недостижимо",
        "velocities plan": "план скоростей",
        "accelerations plan": "план ускорений",
        **{key: russian for key, (_, russian) in (PAGE | FORCES | ROTOR).items()},
    },
}


def word(language: str, key: str, **values: object) -> str:
    """Give a phrase in the sheet's language; a key that no table has is its own word.

    >>> word("ru", "velocities", position=2)
    'План скоростей, положение 2'
    """
    return WORDS[language].get(key, key).format(**values)


def number(value: float, language: str = "en", digits: int = 4) -> str:
    """Write a number of a sheet with some significant digits, no exponent, no -0, and the language's decimal mark.

    >>> number(-0.00012344), number(1234567.0), number(0.5, "ru")
    ('−0.0001234', '1235000', '0,5')
    """
    if not math.isfinite(value):
        raise SheetError(f"{value} cannot be written on a sheet: a gap must be said in words")
    mantissa, exponent = f"{abs(value):.{digits - 1}e}".split("e")
    places = max(digits - 1 - int(exponent), 0)
    text = f"{float(f'{mantissa}e{exponent}'):.{places}f}"
    if "." in text:
        text = text.rstrip("0").rstrip(".")
    sign = "−" if value < 0 and float(text) != 0 else ""
    return (sign + text).replace(".", "," if language == "ru" else ".")


def fixed(value: float, language: str = "en", places: int = 2) -> str:
    """Write a number with a fixed number of decimals, no -0, and the language's decimal mark."""
    text = f"{abs(value):.{places}f}"
    sign = "−" if value < 0 and float(text) != 0 else ""
    return (sign + text).replace(".", "," if language == "ru" else ".")


def runs(positions: Iterable[int], dash: str = "–") -> str:
    """Write numbers of positions with runs joined.

    >>> runs([1, 2, 3, 7, 9, 10])
    '1–3, 7, 9–10'
    """
    joined: list[list[int]] = []
    for k in positions:
        if joined and k == joined[-1][-1] + 1:
            joined[-1].append(k)
        else:
            joined.append([k])
    return ", ".join(str(run[0]) if len(run) == 1 else f"{run[0]}{dash}{run[-1]}" for run in joined)
