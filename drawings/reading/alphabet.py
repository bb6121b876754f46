"""Letters as an eye knows them: the shapes of the alphabet's data, and which letters look alike (начертания букв).

The unit is d, the width of the pen. A shape is what a pen goes through, from the corner of the letter's cell. What is
drawn alike cannot be told apart: A is Latin, Cyrillic and Greek at once. What a file says of a text picks among letters
that look alike, and nothing else.
"""

import cmath
import json
import math
import unicodedata
from bisect import bisect_left, bisect_right
from collections.abc import Iterator, Mapping, Sequence
from functools import cache, lru_cache
from itertools import pairwise
from pathlib import Path
from typing import NamedTuple, TypeAlias

from drawings.paper.strokes import LEAN, Run
from geometry.curve import CubicPiece

DATA = Path(__file__).parents[1] / "lettering" / "alphabet.json"
# From the corner of a cell to the middle of the pen there.
_MIDDLE = 0.5 + 0.5j
# The notation writes angles with two decimals: ends that are nearer than this are one.
_SAME = 1e-3
_SMALL = 6.0  # d, how high the pen goes in small letters, over which accents stand
DOTLESS = {"i": "ı", "j": "ȷ"}
_STEPS = 32
ABOVE = 230  # the class of accents over a letter, as Unicode counts them

# Of each stroke its pieces, "l" straight and "c" cubic, and "z" if it is closed.
Signature: TypeAlias = tuple[str, ...]


class LetterShape(NamedTuple):
    """A letter as it is drawn: the first of those that look alike, the width of its cell, d, and its points."""

    letter: str
    width: float
    signature: Signature
    points: tuple[complex, ...]


@cache
def shapes() -> Mapping[Signature, tuple[LetterShape, ...]]:
    """Give all letters that are seen, without accents, by the kinds of their strokes."""
    found: dict[Signature, list[LetterShape]] = {}
    for letter in notations():
        letter_shape = shape(letter)
        if letter_shape.signature and letter_shape.letter == letter and not unicodedata.combining(letter):
            found.setdefault(letter_shape.signature, []).append(letter_shape)
    return {signature: tuple(letters) for signature, letters in found.items()}


@cache
def accented(signature: Signature) -> tuple[LetterShape, ...]:
    """Give the letters with an accent whose strokes are of these kinds."""
    rests = ((accent, signature[: len(signature) - len(accent.signature)]) for accent in _accents())
    bases = ((base, a) for a, rest in rests if rest + a.signature == signature for base in shapes().get(rest, ()))
    return tuple(_stacked(base, accent) for base, accent in bases if base.letter.isalpha())


@cache
def _accents() -> tuple[LetterShape, ...]:
    return tuple(shape(accent) for accent in notations() if unicodedata.combining(accent))


@cache
def notations() -> Mapping[str, str]:
    """Give the notation of every letter of the alphabet."""
    read: dict[str, str] = json.loads(DATA.read_bytes())
    return {letter: notation for letter, notation in read.items() if letter}


@cache
def shape(letter: str) -> LetterShape:
    """Give the shape of a letter, by the name of the first that is drawn so.

    >>> shape("Г")
    LetterShape(letter='Г', width=5.0, signature=('ll',), points=((0.5+0.5j), (0.5+9.5j), (4.5+9.5j)))
    >>> shape("Т").letter
    'T'
    """
    notation = notations()[letter]
    if notation[0] in "=^_":
        return shape(notation[1])
    width, _, drawn = notation.partition(":")
    strokes = [tuple(_pieces(stroke)) for stroke in drawn.split("|") if stroke.strip()]
    signature = tuple(
        "".join("l" if len(piece) == 1 else "c" for piece in points[1:]) + "z" * stroke.rstrip().endswith("z")
        for points, stroke in zip(strokes, drawn.split("|"), strict=False)
    )
    return LetterShape(letter, float(width), signature, tuple(p + _MIDDLE for path in strokes for q in path for p in q))


def _pieces(stroke: str) -> Iterator[tuple[complex, ...]]:
    """Give the start of a stroke, then its pieces: one point for a straight one, three for a cubic."""
    here: complex | None = None
    for piece in _read(stroke):
        if here is None or abs(piece[-1] - here) > _SAME:
            yield piece
        here = piece[-1]


def _read(stroke: str) -> Iterator[tuple[complex, ...]]:
    for token in stroke.split():
        if token[0] == "@":
            yield from _arc(*map(float, token[1:].split(",")))
        elif token != "z":
            values = [float(number) for number in token.lstrip("~").split(",")]
            yield tuple(map(complex, values[::2], values[1::2]))


def _arc(x: float, y: float, across: float, *rest: float) -> Iterator[tuple[complex, ...]]:
    """Go to the start of an arc of an ellipse, then along it by cubics of a quarter at the most."""
    up, first, last = rest if len(rest) == 3 else (across, *rest)
    count = math.ceil(abs(last - first) / 90)
    step = math.radians(last - first) / count
    handle = 4 / 3 * math.tan(step / 4)
    turns = [cmath.exp(1j * (math.radians(first) + k * step)) for k in range(count + 1)]

    def placed(turn: complex) -> complex:
        return complex(x + across * turn.real, y + up * turn.imag)

    yield (placed(turns[0]),)
    for a, b in pairwise(turns):
        yield placed(a + handle * 1j * a), placed(b - handle * 1j * b), placed(b)


def _stacked(base: LetterShape, accent: LetterShape) -> LetterShape:
    """Set an accent over a letter, or under it: in the middle of the wider of both cells."""
    above = unicodedata.combining(accent.letter) == ABOVE
    width = max(base.width, accent.width)
    rise = _top(base) - _MIDDLE.imag - _SMALL if above else 0.0
    shifted = [point + (width - base.width) / 2 for point in base.points]
    over = [point + complex((width - accent.width) / 2, rise) for point in accent.points]
    return LetterShape(base.letter + accent.letter, width, base.signature + accent.signature, (*shifted, *over))


def _top(letter: LetterShape) -> float:
    """Give how high the pen goes in a letter: beside the handles of its cubics, in steps that miss it by 0.001 d."""
    high, place = -math.inf, 0
    for stroke in letter.signature:
        here, place = letter.points[place], place + 1
        for kind in stroke.rstrip("z"):
            count = 1 if kind == "l" else 3
            piece, place = letter.points[place : place + count], place + count
            high = max(high, here.imag, piece[-1].imag)
            if count > 1:
                curve = CubicPiece(here, *piece)
                high = max(high, *(curve.at(k / _STEPS).imag for k in range(_STEPS)))
            here = piece[-1]
    return high


_LEVELS = {"^": 1, "_": -1}
# A space is as wide as two thin ones, with the gaps between letters counted.
THIN = 1
_SPACES = {" ": 2 * THIN, "\u00a0": 2 * THIN, "\u2009": THIN, "\u202f": THIN}


class Sign(NamedTuple):
    """A letter with its accents: as it is written, as it is seen, its own level, and how much space is before it."""

    written: str
    seen: str
    level: int = 0
    space: str = ""

    @property
    def thin(self) -> int:
        """The space before it, in thin spaces."""
        return width(self.space)


def folded(plain: str) -> str:
    """Write a text as it is seen: in the first of the letters that look alike, each space as two thin ones.

    >>> folded("ВОТ") == folded("BOT"), folded("О") == folded("0"), folded("м²")
    (True, False, 'м2')
    """
    return "".join("\u2009" * sign.thin + sign.seen for sign in signs(plain))


@cache
def width(space: str) -> int:
    """Give the width of a space, in thin ones."""
    return sum(_SPACES[sign] for sign in space)


@lru_cache(maxsize=4096)
def signs(plain: str) -> tuple[Sign, ...]:
    """Take a text apart into letters; spaces at its end are not seen.

    >>> [(sign.seen, sign.level, sign.space) for sign in signs("5 м²")]
    [('5', 0, ''), ('м', 0, ' '), ('2', 1, '')]
    """
    return tuple(_signs(plain))


def _signs(plain: str) -> Iterator[Sign]:
    space, letter = "", ""
    for sign in (*plain, ""):
        if letter and sign and unicodedata.combining(sign):
            letter += sign
            continue
        if letter:
            yield Sign(letter, *_glyph(letter), space)
            space, letter = "", ""
        if sign in _SPACES:
            space += sign
        else:
            letter = sign


@cache
def _glyph(letter: str) -> tuple[str, int]:
    """Give the first letter that looks like one, and its level; of a letter that no alphabet has, the letter."""
    letter = unicodedata.normalize("NFC", letter)
    if (notation := notations().get(letter)) is not None:
        return shape(letter).letter, _LEVELS.get(notation[0], 0)
    base, *accents = list(unicodedata.normalize("NFD", letter))
    body = shape(base).letter if base in notations() else base
    if any(unicodedata.combining(accent) == ABOVE for accent in accents):
        body = DOTLESS.get(body, body)
    return "".join((body, *accents)), 0


def picked(glyphs: Sequence[tuple[str, int]], spaces: Sequence[int], said: str, fonts: bool = False) -> tuple[Run, ...]:
    """Give letters as they are said to be, if they look so, or else as they are seen; each with its level as seen.

    In a viewer's fonts spaces have no width of their own, and are as they are said to be.
    """
    return _picked(tuple(glyphs), (0, *spaces[1:]), said, fonts)


@lru_cache(maxsize=4096)  # a sheet says the same in many places, and what was laid out is read as its file is
def _picked(glyphs: tuple[tuple[str, int], ...], spaces: tuple[int, ...], said: str, fonts: bool) -> tuple[Run, ...]:
    return tuple(_runs(_signs_of(glyphs, spaces, said, fonts)))


@lru_cache(maxsize=4096)
def regular(runs: tuple[Run, ...]) -> tuple[Run, ...]:
    """Give runs as the eye sees them: signs that are raised by themselves where they stand, no spaces at the ends."""
    glyphs = [(sign.seen, run.level or sign.level) for run in runs for sign in signs(run.text)]
    plain = "".join(run.text for run in runs)
    return picked(glyphs, [sign.thin for sign in signs(plain)], plain)


def _signs_of(glyphs: Sequence[tuple[str, int]], spaces: Sequence[int], said: str, fonts: bool) -> tuple[Sign, ...]:
    expected = signs(said.lstrip(" \u00a0\u2009\u202f"))
    alike = len(expected) == len(glyphs) and all(
        sign.seen == letter and (fonts or sign.thin == space)
        for sign, (letter, _), space in zip(expected, glyphs, spaces, strict=True)
    )
    if not alike:
        return tuple(
            Sign(letter, letter, level, " " * (space // 2) + "\u2009" * (space % 2))
            for (letter, level), space in zip(glyphs, spaces, strict=True)
        )
    return tuple(_as_said(sign, level) for sign, (_, level) in zip(expected, glyphs, strict=True))


def _as_said(sign: Sign, level: int) -> Sign:
    """A raised sign is said so only where it is seen on a level of its own: in a subscript it stays."""
    if not sign.level:
        return sign._replace(level=level) if level else sign
    if level == 0:
        return Sign(sign.seen, sign.seen, 0, sign.space)
    return sign._replace(level=0 if level == sign.level else level)


def _runs(signs: Sequence[Sign]) -> Iterator[Run]:
    """Write letters on their levels; a space is on that of the letter before it, or of the text between levels."""
    text, level = "", 0
    for sign in signs:
        if sign.level != level:
            space = sign.space if sign.level == 0 else ""
            before = "" if space else sign.space
            if text or before:
                yield Run(text + before, level)
            text, level = space, sign.level
        else:
            text += sign.space
        text += sign.written
    if text:
        yield Run(text, level)


# A letter's points are written in hundredths of a millimetre: none is off by more than half of one in x and in y.
NEAR = math.sqrt(2) * 0.005 + 1e-6
# The angle (rad) by which that may turn a letter: of the lowest ones, x at the smallest size, 1.3 mm high.
ASKEW = 2 * NEAR / 1.3
UNREAD = "\ufffd"


class Stance(NamedTuple):
    """How a text stands: turned by so many degrees, upright or slanted."""

    rotation: float
    slanted: bool

    @property
    def turn(self) -> complex:
        """The direction of its line of writing."""
        return _turned(self.rotation)


@lru_cache(maxsize=256)
def _turned(rotation: float) -> complex:
    quarters, rest = divmod(rotation, 90)
    return complex(1j ** int(quarters)) * cmath.rect(1, math.radians(rest))


# As texts of a drawing stand, the most usual way first: along it, up its left side, upside down, down its right side.
STANCES = tuple(Stance(rotation, slanted) for rotation in (0.0, 90.0, 180.0, 270.0) for slanted in (False, True))


class LetterReading(NamedTuple):
    """What letter a shape may be, from its first point the corner of its cell along its line, mm, and its width, mm."""

    letter: str
    stance: Stance
    corner: complex
    width: float


class Trail(NamedTuple):
    """What a pen went through in one letter: the kinds of its strokes, its points from the first one (mm, y up)."""

    signature: Signature
    points: tuple[complex, ...]


@lru_cache(maxsize=16384)
def readings(trail: Trail, unit: float, near: float = NEAR) -> Mapping[Stance, Sequence[LetterReading]]:
    """Give by stances what letters a trail may be that a pen of a width in mm has drawn; nothing if it is none."""
    fit = tuple(_of(trail, unit, near, False)) or tuple(_of(trail, unit, near, True))
    return {stance: [way for way in fit if way.stance is stance] for stance in dict.fromkeys(way.stance for way in fit)}


def angles(trails: Sequence[tuple[Trail, float]]) -> Iterator[float]:
    """Give the angles (rad) at which the largest of some trails, with its pen, is a letter; readable ones first."""
    trail, unit = max(trails, key=lambda pair: max(map(abs, pair[0].points)))
    stood = (*_stood(trail.signature, False), *_stood(trail.signature, True))
    upright = (_standing(letter, stance)[1] for letter, stance, _ in stood if stance in STANCES[:2])
    found = (_angle(points, trail, unit) for points in upright)
    yield from sorted(dict.fromkeys(angle for angle in found if angle is not None), key=abs)


def _angle(corners: Sequence[complex], trail: Trail, unit: float) -> float | None:
    """Give the angle at which a trail is a letter of some points, if it is: that of its farthest one."""
    far = max(range(len(corners)), key=lambda k: abs(corners[k]))
    if corners[far] == 0 or trail.points[far] == 0:
        return None
    turn = trail.points[far] / corners[far]
    turn *= unit / abs(turn)
    fits = all(abs(turn * point - spot) <= 2 * NEAR for point, spot in zip(corners, trail.points, strict=True))
    return cmath.phase(turn) if fits else None


def _of(trail: Trail, unit: float, near: float, accents: bool) -> Iterator[LetterReading]:
    last, off = trail.points[-1] / unit if unit and trail.points else 0j, near / unit if unit else 0.0
    stood, (along, order) = _stood(trail.signature, accents), _ends(trail.signature, accents)
    here = sorted(order[bisect_left(along, last.real - off) : bisect_right(along, last.real + off)])
    for letter, stance, end in (stood[k] for k in here):
        if abs(end - last) > off:
            continue
        found, points = _standing(letter, stance)
        if all(abs(point * unit - spot) <= near for point, spot in zip(points, trail.points, strict=True)):
            yield found._replace(corner=found.corner * unit, width=found.width * unit)


@cache
def _stood(signature: Signature, accents: bool) -> tuple[tuple[LetterShape, Stance, complex], ...]:
    """Give the letters of a signature in all stances, and where each ends from its first point, d."""
    letters = accented(signature) if accents else shapes().get(signature, ())
    ways = [(letter, letter.points[-1] - letter.points[0]) for letter in letters]
    turns = [(stance, stance.turn) for stance in STANCES]
    return tuple((letter, stance, turn * _leaning(way, stance)) for stance, turn in turns for letter, way in ways)


@cache
def _ends(signature: Signature, accents: bool) -> tuple[list[float], list[int]]:
    """Give how far to the right those letters end, rising, and their places among them."""
    right = [end.real for _, _, end in _stood(signature, accents)]
    order = sorted(range(len(right)), key=right.__getitem__)
    return [right[k] for k in order], order


def _standing(letter: LetterShape, stance: Stance) -> tuple[LetterReading, tuple[complex, ...]]:
    """Give what a letter is in a stance, and its points from the first one, d."""
    points = [_leaning(point, stance) for point in letter.points]
    found = LetterReading(letter.letter, stance, -points[0], letter.width)
    return found, tuple(stance.turn * (point - points[0]) for point in points)


def _leaning(point: complex, stance: Stance) -> complex:
    return point + LEAN * point.imag if stance.slanted else point
