"""The hand that a sheet is drawn in: formats, borders, line widths, kinds of lines, letter sizes (форматы, линии).

By GOST 2.301-68 and 2.303-68, and by ISO 5457:1999 and ISO 128-2.
"""

from typing import NamedTuple

from drawings.paper.strokes import LineStyle, SheetError
from plans.words.words import message

# Width and height of a sheet that stands upright, mm; GOST 2.301-68 and ISO 216 agree.
SIZES = {"A1": (594.0, 841.0), "A2": (420.0, 594.0), "A3": (297.0, 420.0), "A4": (210.0, 297.0)}
# The border on the left, which is for filing, and on the other three sides.
BORDERS = {"GOST": (20.0, 5.0), "ISO": (20.0, 10.0)}
# Title blocks: form 1 of GOST 2.104-2006; ISO 7200:2004 sets the width only.
BLOCKS = {"GOST": (185.0, 55.0), "ISO": (180.0, 52.0)}
# Which way a format may lie, the customary way first. The block of ISO 5457 is at the lower right of a sheet that lies
# along its long side, and along the short side of an A4 only.
LANDSCAPE, PORTRAIT = "landscape", "portrait"
WAYS = {"GOST": (LANDSCAPE, PORTRAIT), "ISO": (LANDSCAPE,)}
WAYS_OF_A4 = (PORTRAIT,)
SAID_BY = {"GOST": "GOST 2.301-68", "ISO": "ISO 5457"}


class Field(NamedTuple):
    """A rectangle of paper, mm."""

    left: float
    bottom: float
    right: float
    top: float

    @property
    def width(self) -> float:
        """Width, mm."""
        return self.right - self.left

    @property
    def height(self) -> float:
        """Height, mm."""
        return self.top - self.bottom

    @property
    def centre(self) -> complex:
        """Centre."""
        return complex(self.left + self.right, self.bottom + self.top) / 2

    def holds(self, spot: complex) -> bool:
        """Tell whether a place lies in it."""
        return self.left <= spot.real <= self.right and self.bottom <= spot.imag <= self.top

    def inset(self, by: float) -> "Field":
        """Give the rectangle without a border."""
        return Field(self.left + by, self.bottom + by, self.right - by, self.top - by)


def lies(name: str, standard: str, wanted: str | None = None) -> str:
    """Tell which way a format lies: as it is wanted if its standard has it so, or else its customary way.

    >>> lies("A1", "GOST"), lies("A4", "ISO"), lies("A3", "GOST", "portrait")
    ('landscape', 'portrait', 'portrait')
    """
    ways = WAYS_OF_A4 if name == "A4" else WAYS[standard]
    if wanted is None or wanted in ways:
        return wanted or ways[0]
    key = "refused.orientation_a4" if name == "A4" else "refused.orientation"
    raise SheetError(message(key, given=wanted, way=ways[0], standard=SAID_BY[standard], format=name))


def size_of(name: str, orientation: str) -> tuple[float, float]:
    """Give width and height of a format, mm.

    >>> size_of("A3", "landscape")
    (420.0, 297.0)
    """
    width, height = SIZES[name]
    return (width, height) if orientation == PORTRAIT else (height, width)


Dash = tuple[float, ...]

# ISO 128-2: dash 12, gap 3, long dash 24, dot 0.5, in units of the line's own width; lines 02, 04, 05.
ISO_DASHES = ((12, 3), (24, 3, 0.5, 3), (24, 3, 0.5, 3, 0.5, 3))


class Hand(NamedTuple):
    """Widths of a sheet's lines and sizes of its letters, mm, and the factor of its symbols' sizes."""

    main: float  # s, the main line
    thin: float
    construction: float
    heading: float = 7.0  # the title of the largest figure
    title: float = 5.0  # titles of the other figures
    letter: float = 5.0  # letters of points
    number: float = 3.5  # numbers of positions
    text: float = 3.5  # tables, notes, scales
    symbol: float = 1.0  # of kinematic symbols and arrowheads
    medium: float = 0.5  # the pen between main and thin
    dashed: Dash = (5.0, 1.5)
    dash_dot: Dash = (15.0, 1.5, 0.5, 1.5)
    dash_two_dots: Dash = (15.0, 1.5, 0.5, 1.5, 0.5, 1.5)

    @property
    def result(self) -> LineStyle:
        """Solid main line."""
        return LineStyle(self.main)

    @property
    def relative(self) -> LineStyle:
        """Solid line between main and thin: relative vectors."""
        return LineStyle(self.medium)

    @property
    def other(self) -> LineStyle:
        """Solid thin line: other positions, dimensions, leaders."""
        return LineStyle(self.thin)

    @property
    def drafted(self) -> LineStyle:
        """Construction line."""
        return LineStyle(self.construction)

    @property
    def axis(self) -> LineStyle:
        """Thin dash-dot line: axes of guides."""
        return LineStyle(self.construction, self.dash_dot)

    @property
    def path(self) -> LineStyle:
        """Dashed thin line: trajectories."""
        return LineStyle(self.thin, self.dashed)

    @property
    def extreme(self) -> LineStyle:
        """Thin dash-two-dots line: the other extreme position."""
        return LineStyle(self.thin, self.dash_two_dots)

    @property
    def body(self) -> LineStyle:
        """Main line of a symbol, filled with paper."""
        return LineStyle(self.main, fill="#ffffff")


def _iso(narrow: float) -> Hand:
    """Make the hand of a line group: wide is twice narrow; dashes and gaps go by the narrow line's own width."""
    dashed, dash_dot, dash_two_dots = (tuple(part * narrow for part in units) for units in ISO_DASHES)
    between = {0.25: 0.35, 0.35: 0.5}[narrow]  # the line group's own, for lettering
    return Hand(
        2 * narrow, narrow, narrow, medium=between, dashed=dashed, dash_dot=dash_dot, dash_two_dots=dash_two_dots
    )


# GOST 2.303-68: s from 0.5 to 1.4, thin from s/3 to s/2; a dash-dot line's gap, its dot within, is 3 to 5.
GOST_LARGE = Hand(0.7, 0.35, 0.25)
GOST_SMALL = Hand(
    0.5, 0.25, 0.2, medium=0.35, dashed=(4.0, 1.5),
    dash_dot=(10.0, 1.25, 0.5, 1.25), dash_two_dots=(10.0, 1.5, 0.5, 1.5, 0.5, 1.5),
)  # fmt: skip
# The line groups 0.7 and 0.5 of ISO 128-2: the wider one for A1.
HANDS = {
    "GOST": {"A1": GOST_LARGE, "A2": GOST_LARGE, "A3": GOST_SMALL, "A4": GOST_SMALL},
    "ISO": {"A1": _iso(0.35), "A2": _iso(0.25), "A3": _iso(0.25), "A4": _iso(0.25)},
}


def hand_of(name: str, standard: str = "GOST") -> Hand:
    """Give the hand for a format by a standard.

    >>> hand_of("A1").main, hand_of("A3", "ISO").path.dash, hand_of("A4").text
    (0.7, (3.0, 0.75), 2.5)
    """
    hand = HANDS[standard][name]
    if name in ("A1", "A2"):
        return hand
    # What is read at the desk has letters, and with them symbols, one step smaller than what hangs on a wall.
    return hand._replace(heading=5.0, title=3.5, letter=3.5, number=2.5, text=2.5, symbol=0.7)
