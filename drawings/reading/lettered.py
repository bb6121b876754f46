"""Lettered paths: the data of a path as letters, each piece of it looked up once (надписи линиями)."""

import cmath
import math
import re
from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache
from itertools import pairwise
from operator import attrgetter
from typing import NamedTuple, TypeAlias

from drawings.paper.limits import SheetRefused
from drawings.paper.strokes import LEAN, LOWERED, RAISED, LineStyle, Text
from drawings.reading.alphabet import (
    ASKEW,
    NEAR,
    STANCES,
    UNREAD,
    LetterReading,
    Stance,
    Trail,
    angles,
    picked,
    readings,
)
from drawings.reading.pathdata import PathStep, centred, handles, steps
from drawings.reading.transform import Affine

# The end of a straight piece, three points of a cubic; of an arc its middle and its end.
Piece: TypeAlias = tuple[complex] | tuple[complex, complex, complex] | tuple[complex, complex]

_NUMBER = r"-?+[0-9]{1,7}+(?:\.[0-9]{1,12}+)?+"
# Straight chains as a plain pen writes them; all else is for the strict reader.
_CHAINS = re.compile(rf"(?:M{_NUMBER} {_NUMBER}(?:L{_NUMBER} {_NUMBER})++Z?+)++")
_ROUND = 1e-5  # Editors write about six digits of a radius: an arc with more between its two is of an ellipse.


class PenTrack(NamedTuple):
    """What a pen goes through without being lifted: from its start by pieces, and whether it is closed."""

    start: complex
    pieces: tuple[Piece, ...]
    closed: bool = False

    @property
    def points(self) -> tuple[complex, ...]:
        """All its points, handles and middles too."""
        return (self.start, *(point for piece in self.pieces for point in piece))

    def mapped(self, place: Affine) -> "PenTrack":
        """Give it on paper: an affine map takes each point where it belongs, but of arcs when it stretches."""
        pieces = tuple(tuple(place(point) for point in piece) for piece in self.pieces)
        return PenTrack(place(self.start), pieces, self.closed)  # type: ignore[arg-type]


def tracks(path: str) -> list[PenTrack]:
    """Read path data; a move that nothing follows leaves no track.

    >>> tracks("m1 1h2v2z")
    [PenTrack(start=(1+1j), pieces=(((3+1j),), ((3+3j),)), closed=True)]
    """
    found: list[PenTrack] = []
    start, pieces, closed = 0j, list[Piece](), False
    for step in steps(path):
        letter = step.letter.upper()
        if (letter == "M" or closed) and pieces:
            found.append(PenTrack(start, tuple(pieces), closed))
            pieces = []
        if letter == "M" or closed:
            start = step.end if letter == "M" else step.start
        closed = letter == "Z"
        if letter not in "MZ":
            pieces += _pieces(step, pieces)
    return [*found, PenTrack(start, tuple(pieces), closed)] if pieces else found


def chains(path: str) -> list[tuple[list[complex], bool]] | None:
    """Read path data of straight chains at once: the points of each, and whether it is closed; None of all else.

    >>> chains("M1 1L3 1L3 3Z")
    [([(1+1j), (3+1j), (3+3j)], True)]
    """
    if _CHAINS.fullmatch(path) is None:
        return None
    found = []
    for part in path[1:].split("M"):
        flat = list(map(float, part.rstrip("Z").replace("L", " ").split(" ")))
        found.append((list(map(complex, flat[::2], flat[1::2])), part[-1] == "Z"))
    return found


def _pieces(step: PathStep, before: list[Piece]) -> list[Piece]:
    start, end = step.start, step.end
    match step.letter.upper():
        case "A":
            return list(_arc(start, end, step.values))
        case "C":
            first, second = handles(step)
            return [(first, second, end)]
        case "S":
            (second,) = handles(step)
            mirrored = 2 * start - before[-1][1] if before and len(before[-1]) == 3 else start
            return [(mirrored, second, end)]
        case "T":
            raise SheetRefused("smooth_quadratic")
        case "Q":
            (near,) = handles(step)
            return [(start + 2 / 3 * (near - start), end + 2 / 3 * (near - end), end)]
    return [(end,)]


def _arc(start: complex, end: complex, values: list[float]) -> Iterator[Piece]:
    """Give an arc by its middle and end, that of an ellipse by cubics; one without a radius is straight."""
    across, up, tilt, large, positive = values[:5]
    across, up = abs(across), abs(up)
    if start == end:
        return
    if not (across and up):
        yield (end,)
    elif abs(across - up) <= _ROUND * max(across, up):
        centre, sweep = centred(start, end, across, bool(large), bool(positive))
        yield centre + (start - centre) * cmath.exp(0.5j * sweep), end
    else:
        yield from _ellipse(start, end, complex(across, up), tilt, (bool(large), bool(positive)))


def _ellipse(start: complex, end: complex, radii: complex, tilt: float, flags: tuple[bool, bool]) -> Iterator[Piece]:
    """Go along an arc of an ellipse as along that of a circle, which is stretched then."""
    turn = cmath.rect(1, math.radians(tilt))

    def pressed(point: complex) -> complex:
        local = point / turn
        return complex(local.real / radii.real, local.imag / radii.imag)

    def stretched(point: complex) -> complex:
        return turn * complex(point.real * radii.real, point.imag * radii.imag)

    first = pressed(start)
    centre, sweep = centred(first, pressed(end), 1.0, *flags)
    count = max(1, math.ceil(abs(sweep) / (math.pi / 2) - 1e-9))
    handle, step = 4 / 3 * math.tan(sweep / count / 4), cmath.exp(1j * sweep / count)
    a = first - centre
    for _ in range(count):
        b = a * step
        yield stretched(centre + a + handle * 1j * a), stretched(centre + b - handle * 1j * b), stretched(centre + b)
        a = b


# Of letters' places, which are written in thousandths of a millimetre: half of one in x and in y, twice.
EVEN = 0.002
# d of the smaller letter: between letters, and what a thin space adds; half of the gap where lines are not parallel.
_GAP, _THIN = 2.0, 2.0
# Thin spaces: across an A0 sheet in the smallest letters are under 4,000; more is no line of writing.
_WIDEST = 4000
# mm: what is added to it has its digits to two millionths, so that letters of one text stand alike wherever that is.
_FAR = complex(2**33, 2**33)
_RISES = ((0, 0.0), (-1, -LOWERED), (1, RAISED))  # how high levels lie, in sizes


class SeenGlyph:
    """What a pen went through in a letter, and what that may be; of letters that are drawn alike it is one."""

    __slots__ = ("known", "trail")

    def __init__(self, trail: Trail, known: Mapping[Stance, Sequence[LetterReading]]) -> None:
        self.trail, self.known = trail, known


class PathLetters(NamedTuple):
    """Letters of one pen on paper: the first point of each (mm, y up), the width of the pen, mm, how they are drawn."""

    places: tuple[complex, ...]
    unit: float
    glyphs: tuple[SeenGlyph, ...]


class _SetLetter(NamedTuple):
    """A letter set on a line: what it is, how far along and how high, its width, its pen, mm, and its level."""

    letter: str
    along: float
    rise: float
    width: float
    unit: float
    level: int = 0


_Letter: TypeAlias = tuple[complex, float, SeenGlyph]  # its first point, the width of its pen, how it is drawn
_Turned: TypeAlias = tuple[complex, float, Sequence[LetterReading]]  # a letter as if its line of writing went along
_Line: TypeAlias = tuple[Stance, list[_SetLetter]]
_ALONG = attrgetter("along")


def written(rows: Sequence[PathLetters], said: str, ink: LineStyle) -> Text:
    """Read letters as one text; those that are none are unread in it."""
    first = rows[0].places[0]
    off = [PathLetters(tuple([place - first + _FAR for place in places]), unit, drawn) for places, unit, drawn in rows]
    at, runs, size, anchor, slanted, rotation, _ = _written(tuple(off), said)
    return Text(first + at, runs, size, anchor, slanted, rotation, ink)


@lru_cache(maxsize=4096)  # a sheet writes the same in many places
def _written(rows: tuple[PathLetters, ...], said: str) -> Text:
    """Read letters by how far they are from the first, as a text that begins from there."""
    letters = [(corner - _FAR, pen, glyph) for at, pen, drawn in rows for corner, glyph in zip(at, drawn, strict=True)]
    size = 10 * max(row.unit for row in rows)
    stance, row = _straight(letters, size) or _askew(letters, size) or _unread(letters)
    spaces = (0, *_spaces(row, size))
    glyphs = [(letter[0] if space >= 0 else UNREAD, letter[5]) for letter, space in zip(row, spaces, strict=True)]
    runs = picked(glyphs, [max(space, 0) for space in spaces], said)
    at = stance.turn * complex(row[0][1], next((letter[2] for letter in row if letter[5] == 0), 0.0))
    return Text(at, runs, round(size, 6), "start", stance.slanted, stance.rotation)


def _straight(letters: Sequence[_Letter], size: float, even: float = EVEN) -> _Line | None:
    """Set letters on one line of writing along or up a sheet, the most usual first."""
    for stance in letters[0][2].known:
        back = stance.turn.conjugate()
        along = [(place * back, unit, glyph.known.get(stance, ())) for place, unit, glyph in letters]
        for low in _lows(along, size):
            row = _levelled(along, low, size, stance, even)
            if len(row) == len(letters):
                return stance, sorted(row, key=_ALONG)
    return None


def _lows(letters: Sequence[_Turned], size: float) -> list[float]:
    """Give how high a line of writing may lie: by that of the largest letters which may be the fewest."""
    fewest: list[float] = []
    for place, unit, known in letters:
        if unit * 10 == size:
            lows = [(place + reading.corner).imag for reading in known]
            if len(lows) <= 1:
                return lows
            fewest = lows if not fewest or len(lows) < len(fewest) else fewest
    return fewest


def _askew(letters: Sequence[_Letter], size: float) -> _Line | None:
    """Set letters on a line of writing in another direction: by that of one letter first, then by all together."""
    # As far as any two are apart: a lowered letter may be written last and stand between.
    loose = ASKEW * max(abs(corner - other) for corner, _, _ in letters for other, _, _ in letters) + EVEN
    for angle in angles([(glyph.trail, unit) for _, unit, glyph in letters]):
        rough = _straight([_turned_back(letter, angle, 2 * NEAR) for letter in letters], size, loose)
        if rough is None or rough[0].rotation:
            continue
        row = rough[1]
        low = [letter.rise - dict(_RISES)[letter.level] * size for letter in row]
        finer = angle + (math.atan2(low[-1] - low[0], row[-1].along - row[0].along) if len(row) > 1 else 0.0)
        line = _straight([_turned_back(letter, finer, 2 * NEAR) for letter in letters], size, 4 * EVEN)
        if line is not None and line[0].rotation == 0:
            return Stance(math.degrees(finer) % 360, line[0].slanted), line[1]
    return None


def _turned_back(letter: _Letter, angle: float, near: float) -> _Letter:
    turn, (place, unit, glyph) = cmath.rect(1, -angle), letter
    trail = Trail(glyph.trail.signature, tuple(turn * point for point in glyph.trail.points))
    return turn * place, unit, SeenGlyph(trail, readings(trail, unit, near))


def _levelled(letters: Sequence[_Turned], low: float, size: float, stance: Stance, even: float) -> list[_SetLetter]:
    """Set letters on a line of writing until one is none: each the first that it may be, on the level where it is."""
    row: list[_SetLetter] = []
    for count, (place, unit, known) in enumerate(letters):
        for name, _, corner, width in known:
            spot = place + corner
            rise = spot.imag - low
            if abs(rise) <= even and unit * 10 == size:
                row.append(_SetLetter(name, spot.real, spot.imag, width, unit))
                break
            level, share = (1, RAISED) if rise > 0 else (-1, -LOWERED)
            if abs(rise - share * size) <= even:
                lean = LEAN * share * size if stance.slanted else 0.0
                row.append(_SetLetter(name, spot.real - lean, spot.imag, width, unit, level))
                break
        if len(row) == count:
            break
    return row


def _unread(letters: Sequence[_Letter]) -> _Line:
    """Set letters that do not stand on one line: those that are one, wherever it is, and the others unread."""
    stance = next((stance for _, _, glyph in letters for stance in glyph.known), STANCES[0])
    row = []
    for place, unit, glyph in letters:
        found = glyph.known.get(stance, ())
        name, corner, width = next(((reading[0], reading[2], reading[3]) for reading in found), (UNREAD, 0j, 0.0))
        spot = place * stance.turn.conjugate() + corner
        row.append(_SetLetter(name, spot.real, spot.imag, width, unit))
    return stance, sorted(row, key=_ALONG)


def _spaces(row: Sequence[_SetLetter], size: float) -> Iterator[int]:
    """Give how many thin spaces are between letters; below 0, where a letter runs into the one before it."""
    for (_, start, _, width, before, _), (_, end, _, _, after, _) in pairwise(row):
        gap, free = _GAP * (before if before < after else after), end - start - width
        if abs(free - gap) <= EVEN:
            yield 0
        elif free <= gap:
            yield 0 if free >= gap / 2 - EVEN else -1
        else:
            # A space has the width of its level, which may be that of either letter or of the text.
            off, count = min(_space(free, before, after, unit) for unit in {before, after, size / 10})
            yield count if off <= EVEN and count <= _WIDEST else -1


def _space(free: float, before: float, after: float, unit: float) -> tuple[float, int]:
    """Give how far a gap is from being spaces written by a pen, and how many thin ones they are."""
    thin = _THIN * unit
    count = (free - _GAP * (min(before, unit) + min(unit, after))) / thin + 1 if thin else math.inf
    if not math.isfinite(count):  # of letters that are as small as a point
        return math.inf, 0
    return abs(count - round(count)) * thin, round(count)


# Letters as a plain pen writes them: where each begins, and from there by steps.
_LETTERS = re.compile(rf"M({_NUMBER}) ({_NUMBER})([lcm][^M]*)")
_MOST = 6  # strokes of a letter with its accents
_KNOWN = 4096  # letters of a pen that are remembered: a sheet of ours has some hundreds, a stranger's any number

_BLANK = SeenGlyph(Trail((), ()), {})


class _Pen(dict[str, SeenGlyph]):
    """The letters that a pen has drawn, each by its steps from its first point; blank where it left no trace."""

    def __init__(self, p: complex, q: complex, unit: float) -> None:
        super().__init__()
        self.linear, self.unit = Affine(p, q), unit

    def __missing__(self, steps: str) -> SeenGlyph:
        trail = _trail([track.mapped(self.linear) for track in tracks(f"M0 0{steps}")])
        if len(self) >= _KNOWN:
            self.clear()
        self[steps] = SeenGlyph(trail, readings(trail, self.unit)) if trail.points else _BLANK
        return self[steps]


_pen = lru_cache(maxsize=64)(_Pen)


def plain_letters(path: str, place: Affine, style: LineStyle) -> PathLetters | None:
    """Read path data that is written letter by letter; None, if it is not."""
    parts = _LETTERS.split(path)
    if any(parts[::4]):
        return None
    glyphs = tuple(map(_pen(place.p, place.q, style.width).__getitem__, parts[3::4]))
    if _BLANK in glyphs:
        return None
    p, q, t = place
    spots = map(complex, map(float, parts[1::4]), map(float, parts[2::4]))
    return PathLetters(tuple([p * spot + q * spot.conjugate() + t for spot in spots]), style.width, glyphs)


def any_letters(path: str, place: Affine, style: LineStyle) -> PathLetters | None:
    """Read path data as an editor may have rewritten it: as many strokes as make a letter are one."""
    left = [track.mapped(place) for track in tracks(path)]
    places, glyphs = list[complex](), list[SeenGlyph]()
    while left:
        places.append(left[0].start)
        trails = [_trail(left[:count]) for count in range(min(_MOST, len(left)), 0, -1)]
        looked_up = ((trail, readings(trail, style.width, 2 * NEAR)) for trail in trails)
        trail, found = next((pair for pair in looked_up if pair[1]), (trails[-1], {}))
        glyphs.append(SeenGlyph(trail, found))
        left = left[len(glyphs[-1].trail.signature) :]
    return PathLetters(tuple(places), style.width, tuple(glyphs)) if places else None


def pen_of_letters(style: LineStyle) -> bool:
    """Tell whether a line may be that of a letter: round at its ends, without gaps, not filled."""
    return style.cap == "round" and not style.dash and style.fill == "none" and style.colour != "none"


def _trail(tracks: Sequence[PenTrack]) -> Trail:
    """Give tracks on paper as one trail from their first point."""
    first = tracks[0].start if tracks else 0j
    # A straight piece has one point after its start, an arc two, a cubic three.
    signature = tuple("".join("lac"[len(piece) - 1] for piece in track.pieces) + "z" * track.closed for track in tracks)
    return Trail(signature, tuple(point - first for track in tracks for point in track.points))
