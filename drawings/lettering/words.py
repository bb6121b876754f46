"""The words and phrases of a sheet in its language, its letters as that language writes them, its numbers (надписи).

The template of a phrase (фраза) is its text with ⟨name⟩ where the number of a quantity stands.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable
from functools import lru_cache
from typing import NamedTuple

from drawings.paper.strokes import Kind, SheetError, Statement, Stroke, Text
from drawings.paper.walk import stating, texts
from plans.words import words

ROUNDING = 2.0**-40  # of the largest of a row: some thousand roundings, far below the digits that are printed
GROUPS = ("sheet", "unit", "reason")  # of words that stand on sheets
# Indices that each language has letters of its own for: of useful resistance, of balance, of a tangential part,
# of what is reduced, of the drive, of the flywheel, of the steady motion; of a cam's phases, which may be numbered.
_INDEX = re.compile(
    r"(?<=\^)t(?![a-z])|(?<=[_{])(?:us|bal|red|dr|fly|st|fr)(?=}|$|,)"
    r"|(?<=_{)(?:rise|dwell|return|rest|rol|hol)(?=[ \u00a0}])"
)


def word(language: str, key: str, **values: object) -> str:
    """Give a phrase, a unit or a reason in the sheet's language; words of other groups by their full keys.

    >>> word("ru", "velocities", position=2), word("ru", "rad/s")
    ('План скоростей, положение 2', 'рад/с')
    """
    catalogue = words.words(language)
    found = next(name for name in (*(f"{group}.{key}" for group in GROUPS), key) if name in catalogue)
    return words.word(language, found, **values)


def letter(language: str, markup: str) -> str:
    """Write a letter of a force sheet as courses of a language do.

    >>> letter("ru", "R^t_{34}"), letter("ru", "M_{bal}"), letter("ru", "F_{us}"), letter("en", "M_{bal}")
    ('R^τ_{34}', 'M_{ур}', 'F_{п.с}', 'M_{bal}')
    """
    return _INDEX.sub(lambda found: words.word(language, f"index.{found[0]}"), markup)


def verbatim(text: str) -> str:
    r"""Write a user's text so that lettering has it as it stands.

    >>> print(verbatim("valve_in"))
    valve\_in
    """
    return re.sub(r"([_^{}\\])", r"\\\1", text)


RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
LEVEL = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹−,", "-0123456789-.")
LEAST = 1e-5  # a smaller number is written by its power of ten: of more zeros none is counted
WRITTEN = r"\d+(?:[.,]\d+)?(?:·10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)?"  # a number without its sign, as it is read again


def number(value: float, language: str = "en", digits: int = 4) -> str:
    """Write a number of a sheet with some significant digits, no -0, the language's mark, or by a power of ten.

    >>> number(-0.00012344), number(1234567.0), number(0.5, "ru"), number(1.2393e-7, "ru", 5)
    ('−0.0001234', '1235000', '0,5', '1,2393·10⁻⁷')
    """
    if not math.isfinite(value):
        raise SheetError(f"{value} cannot be written on a sheet: a gap must be said in words")
    mantissa, exponent = f"{abs(value):.{digits - 1}e}".split("e")
    small = 0.0 < abs(value) < LEAST
    places = max(digits - 1 - (0 if small else int(exponent)), 0)
    text = f"{float(mantissa if small else f'{mantissa}e{exponent}'):.{places}f}"
    if "." in text:
        text = text.rstrip("0").rstrip(".")
    sign = "−" if value < 0 and float(text) != 0 else ""
    return decimal(sign + text, language) + (f"·10{str(int(exponent)).translate(RAISED)}" if small else "")


def numerals(text: str) -> str:
    """Give a number that is written on a sheet as a machine reads it.

    >>> numerals("−1,2393·10⁻⁷")
    '-1.2393e-7'
    """
    return text.translate(LEVEL).replace("·10", "e")


def last_place(text: str) -> int:
    """Give the power of ten that the last digit of a written number counts.

    >>> last_place("−1,2393·10⁻⁷"), last_place("0.02"), last_place("350")
    (-11, -2, 0)
    """
    digits, _, power = text.partition("·10")
    return int(power.translate(LEVEL) or 0) - len(digits.replace(",", ".").partition(".")[2])


def span(values: Iterable[float], language: str = "en") -> str:
    """Write the least and the greatest of some numbers, once where they are written alike.

    >>> span([11.0, -9.0, 10.0]), span([5.0, 5.00001])
    ('−9 … 11', '5')
    """
    row = sorted(values)
    return " … ".join(dict.fromkeys(number(end, language) for end in (row[0], row[-1])))


def decimal(text: str, language: str) -> str:
    """Give a number's text the decimal mark of a language.

    >>> decimal("1.50e-09", "ru")
    '1,50e-09'
    """
    return text.replace(".", words.word(language, "number.decimal"))


def fixed(value: float, language: str = "en", places: int = 2) -> str:
    """Write a number with a fixed number of decimals, no -0, and the language's decimal mark."""
    text = f"{abs(value):.{places}f}"
    sign = "−" if value < 0 and float(text) != 0 else ""
    return decimal(sign + text, language)


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


SLOT = re.compile("⟨(.*?)⟩")
NUMBER, BLANKS = re.compile(rf"[−-]?{WRITTEN}|—"), re.compile(r"\s+")


class Slot(NamedTuple):
    """A number of a phrase: the quantity that it is, its value, and how many significant digits are written."""

    quantity: str
    value: float
    digits: int = 4


class Phrase(str):
    """A sentence with its template; without any number of a quantity the template is the sentence."""

    __slots__ = ("template",)
    template: str

    def __new__(cls, text: str, template: str) -> Phrase:
        """Write a sentence."""
        made = super().__new__(cls, text)
        made.template = template
        return made


def phrase(language: str, key: str, **parts: object) -> Phrase:
    """Say a sentence of a sheet in a language; its parts are slots, other phrases, or words as they are.

    >>> said = phrase("en", "permissible in one", grade="G6.3", letters="e", permissible=Slot("U_per", 12.5))
    >>> said.template == str(said).replace("12.5", "⟨U_per⟩")
    True
    """
    text = {name: _text(part, language) for name, part in parts.items()}
    template = {name: _template(part) for name, part in parts.items()}
    return Phrase(word(language, key, **text), word(language, key, **template))


def numbered(language: str, slot: Slot) -> Phrase:
    """Write the number of a quantity alone.

    >>> numbered("ru", Slot("h_1", 2.5)).template
    '⟨h_1⟩'
    """
    return Phrase(str(_text(slot, language)), str(_template(slot)))


def slotted(before: str, quantity: str, number: str, after: str = "") -> Phrase:
    """Write the number of a quantity that is rounded in its own way.

    >>> slotted("K = ", "K", "1.500").template
    'K = ⟨K⟩'
    """
    return Phrase(f"{before}{number}{after}", f"{before}⟨{quantity}⟩{after}")


def joined(between: str, parts: Iterable[str]) -> Phrase:
    """Join phrases and words to one phrase."""
    pieces = [*parts]
    return Phrase(between.join(pieces), between.join(map(template_of, pieces)))


def template_of(text: str) -> str:
    """Give the template of a phrase; of plain words they are it themselves."""
    return text.template if isinstance(text, Phrase) else text


def telling(figure: str, stroke: Stroke, content: str = "") -> Stroke:
    """Give lettering of a figure as what it states, where its content is a phrase with slots."""
    contents = (content,) if content else (text.content for text in texts((stroke,)))
    template = " ".join(template_of(part) for part in contents if isinstance(part, str))
    return stating(Statement(Kind.PHRASE, figure, template), stroke) if SLOT.search(template) else stroke


def _text(part: object, language: str) -> object:
    return number(part.value, language, part.digits) if isinstance(part, Slot) else part


def _template(part: object) -> object:
    if isinstance(part, Slot):
        return f"⟨{part.quantity}⟩"
    return template_of(part) if isinstance(part, str) else part


def read_back(template: str, text: str, markup: bool = True) -> list[tuple[str, str]]:
    """Read the numbers of a phrase off a text that is written by its template; none where it says something else.

    The template of a phrase on a sheet is marked up as lettering; that of one in a report is as the text.

    >>> read_back("m_{II} = ⟨m_II⟩ kg,  D = ⟨D⟩ mm", "mII = 0.25 kg, D = 40 mm")
    [('m_II', '0.25'), ('D', '40')]
    """
    names, pieces = SLOT.findall(template), SLOT.split(template)[::2]
    pieces = [Text(0j, piece).plain for piece in pieces] if markup else pieces
    first, *others = (BLANKS.sub(" ", piece) for piece in pieces)
    text = BLANKS.sub(" ", text)
    start = text.find(first)
    while start >= 0:
        found, end = [], start + len(first)
        for piece in others:
            amount = NUMBER.match(text, end)
            if amount is None or not text.startswith(piece, amount.end()):
                break
            found.append(amount[0])
            end = amount.end() + len(piece)
        else:
            return [*zip(names, found, strict=True)]
        start = text.find(first, start + 1)
    return []


@lru_cache(maxsize=4096)
def with_index(letter: str) -> str:
    """Write a mark's letter with its index lowered: b, a_3, n_BA.

    >>> with_index("a3"), with_index("n_BA"), with_index("s12'")
    ('a_{3}', 'n_{BA}', "s_{12}'")
    """
    if "_" in letter:
        head, index = letter.split("_", 1)
        return f"{head}_{{{index}}}"
    digits = "".join(sign for sign in letter if sign.isdigit())
    return letter.replace(digits, f"_{{{digits}}}", 1) if digits else letter


CENTRE, FORCE, MOMENT, RESULT = "S", "Φ", "M^Φ", "mr_S"
INDEX = re.compile(r"_([^_]+?)(?=r_|$)")


def counterweight(link: int, language: str) -> str:
    """Letter the mass of a link's counterweight.

    >>> counterweight(1, "en"), counterweight(12, "ru")
    ('m_{cw1}', 'm_{пр12}')
    """
    return f"m_{{{word(language, 'counterweight index')}{link}}}"


def lowered(name: str) -> str:
    """Mark up the letters of a main-point vector or a static moment, each index lowered.

    >>> lowered("h_2"), lowered("m_3r_S3"), lowered("mr_S")
    ('h_{2}', 'm_{3}r_{S3}', 'mr_{S}')
    """
    return INDEX.sub(lambda found: f"_{{{found[1]}}}", name)


def lowered_bank(name: str) -> str:
    """Mark up the letters of a vector or a mass, its index lowered, its prime above.

    >>> lowered_bank("F_-II,12"), lowered_bank("mr_M,I"), lowered_bank("m_M,II'")
    ('F_{−II,12}', 'mr_{M,I}', "m_{M,II}'")
    """
    letter, _, index = name.rstrip("'").partition("_")
    return (f"{letter}_{{{index.replace('-', '−')}}}" if index else letter) + "'" * name.count("'")
