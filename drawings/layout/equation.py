"""Equations of forces and moments in lettering: bars over vectors, one or two lines under terms (уравнения)."""

from collections.abc import Iterable, Iterator, Sequence
from functools import lru_cache
from typing import NamedTuple, TypeAlias

from drawings.layout.picture import TextBlock
from drawings.lettering.lettering import text_width
from drawings.lettering.words import joined, telling
from drawings.page.page import Field
from drawings.paper.hand import Hand
from drawings.paper.strokes import Group, Line, Statement, Stroke, Text
from drawings.paper.walk import stating

BAR = "\N{COMBINING MACRON}"
UNKNOWN, DIRECTION, FULL = 0, 1, 2  # lines under a term: nothing known, its direction only, or all of it
# In sizes of the letters, from the line of writing: up to the bar over a letter with its superscript, the first line
# under a term, and the step from line to line, which leaves a raised index clear of the lines above it.
ASCENT, UNDER, STEP = 1.3, 0.62, 2.5
APART = 0.8  # mm between two lines under a term: the least that GOST 2.303-68 allows
NARROWEST = 24  # sizes: in a narrower column every term has a line of its own
LAPSE = 0.35  # gap on either side of a sign, in sizes
DESCENT = 1.0  # sizes below the last line of writing


class Term(NamedTuple):
    """A term of an equation of vectors: its letter, marked up, what is known of it, and the sign before it."""

    letter: str
    known: int = FULL
    sign: str = "+"
    vector: bool = True

    @property
    def written(self) -> str:
        """Its letter, with a bar over a vector's.

        >>> Term("R^t_{34}", DIRECTION).written == "R" + BAR + "^t_{34}"
        True
        """
        return self.letter[0] + BAR + self.letter[1:] if self.vector else self.letter


class Unbroken(NamedTuple):
    """What is never broken: a sign with the term after it, and the lines under the term."""

    sign: str
    text: str
    under: int
    states: Statement | None = None


class WrittenEquation(NamedTuple):
    """An equation as pieces between which its lines may be broken, and a heading before it such as ΣM_D:."""

    pieces: tuple[Unbroken, ...]


Row: TypeAlias = tuple[Unbroken, ...]


def forces(terms: Sequence[Term], right: str = "0") -> WrittenEquation:
    """Write that the forces of a group balance: their sum is zero."""
    first, *others = terms
    pieces = [Unbroken("−" if first.sign == "−" else "", first.written, first.known)]
    pieces += [Unbroken(term.sign, term.written, term.known) for term in others]
    return WrittenEquation((*pieces, Unbroken("=", right, UNKNOWN)))


def moments(
    about: str, terms: Sequence[tuple[str, str]], right: str = "0", states: Sequence[Statement] = ()
) -> WrittenEquation:
    """Write the moments about a point by sign and product: ΣM_D: R^t_34·BD + G_4·h_1 − ... = 0; each states its own.

    >>> [piece.text for piece in moments("D", [("+", "G_4·h_1"), ("−", "Φ_4·h_2")]).pieces]
    ['ΣM_{D}:', 'G_4·h_1', 'Φ_4·h_2', '0']
    """
    pieces = [Unbroken("", f"ΣM_{{{about}}}:", UNKNOWN)]
    for k, (sign, product) in enumerate(terms):
        said = states[k] if states else None
        pieces.append(Unbroken("" if k == 0 and sign == "+" else sign, product, UNKNOWN, said))
    return WrittenEquation((*pieces, Unbroken("=", right, UNKNOWN)))


def plain(*parts: str) -> WrittenEquation:
    """Write a line of parts between which it may be broken: a solution such as R^t_34 = ... = 12 N."""
    return WrittenEquation(tuple(Unbroken("", part, UNKNOWN) for part in parts))


def listed(*parts: str) -> WrittenEquation:
    """Write statements after one another, a comma after each but the last."""
    return plain(*(joined("", (part, ",")) for part in parts[:-1]), *parts[-1:])


class EquationBlock(NamedTuple):
    """Equations under each other, in letters of one size; `figure` is what their numbers are stated of."""

    name: str
    equations: tuple[WrittenEquation, ...]
    size: float
    narrowest: float = NARROWEST  # sizes
    figure: str = ""

    def rows(self, width: float) -> list[Row]:
        """Break the equations at a width, mm, before their signs."""
        return [row for equation in self.equations for row in _broken(equation, width, self.size)]

    def block(self) -> TextBlock:
        """Measure the ways to break it, each at the least width for its number of lines."""
        least = max(_length(whole, self.size) for equation in self.equations for whole in _unbroken(equation))
        width = max(_length(equation.pieces, self.size) for equation in self.equations)
        widths: dict[float, float] = {}
        while not widths or width >= max(least, self.narrowest * self.size):
            rows = self.rows(width)
            width = max(_length(row, self.size) for row in rows)
            high = self.size * (ASCENT + STEP * (len(rows) - 1) + DESCENT)
            widths[high] = width  # the last is the least width for this height
            width -= self.size / 10  # narrower by a pen's width: a line must break
        return TextBlock(self.name, tuple((wide, high) for high, wide in reversed(widths.items())))

    def write(self, box: Field, hand: Hand) -> Group:
        """Write the equations from the top of their box downwards."""
        strokes: list[Stroke] = []
        for k, row in enumerate(self.rows(box.width + self.size / 100)):
            start = complex(box.left, box.top - self.size * (ASCENT + STEP * k))
            strokes += _written(self, row, start, hand)
        return Group(tuple(strokes), self.name)


def _broken(equation: WrittenEquation, width: float, size: float) -> Iterator[Row]:
    row: Row = ()
    for whole in _unbroken(equation):
        if row and _length((*row, *whole), size) > width:
            yield row
            row = ()
        row = (*row, *whole)
    yield row


def _unbroken(equation: WrittenEquation) -> Iterator[Row]:
    """Give what stands on one line; the right side stays with the last term, for "= 0" alone is no line."""
    kept = 2 if len(equation.pieces) > 1 and equation.pieces[-1].sign == "=" else 1
    yield from ((piece,) for piece in equation.pieces[:-kept])
    yield equation.pieces[-kept:]


@lru_cache(maxsize=4096)
def _wide(text: str, size: float) -> float:
    return text_width(Text(0j, text, size))


def _length(row: Iterable[Unbroken], size: float) -> float:
    length = 0.0
    for piece in row:
        length += _sign(piece, size, bool(length)) + _wide(piece.text, size)
    return length


def _sign(piece: Unbroken, size: float, within: bool) -> float:
    """Give the width of a sign with its gaps; without a sign, only a gap within the line."""
    gap = LAPSE * size
    if not piece.sign:
        return 2 * gap if within else 0.0
    return _wide(piece.sign, size) + (2 * gap if within else gap)


def _written(passage: EquationBlock, row: Row, start: complex, hand: Hand) -> Iterator[Stroke]:
    """Write one line from its start, each term over its lines."""
    along, size = 0.0, passage.size
    for piece in row:
        strokes = list[Stroke]()
        if piece.sign:
            strokes.append(Text(start + along + (LAPSE * size if along else 0.0), piece.sign, size, "start", True))
        along += _sign(piece, size, bool(along))
        strokes.append(telling(passage.figure, Text(start + along, piece.text, size, "start", True)))
        yield from strokes if piece.states is None else (stating(piece.states, *strokes),)
        width = _wide(piece.text, size)
        for k in range(piece.under):
            low = start + along - 1j * (UNDER * size + APART * k)
            yield Line(low, low + width, hand.other)
        along += width
