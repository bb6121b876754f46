"""Fields of a linkage: letters of links and lines, numbers of links and pairs, positions of the crank (поля)."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from decimal import Decimal
from functools import partial
from itertools import pairwise
from typing import Any, Final, Literal

from geometry.errors import LimitError
from plans.model.mechanism import FRAME
from plans.scene import fields as f
from plans.scene import forms, units
from plans.scene.faults import Wrong, wrong
from plans.scene.fields import ANGLE, NAME_LIMIT, check_name, choice, few, no_repeats, sample, whole
from plans.scene.forms import Form
from plans.scene.readers import Check, either, many, one
from plans.scene.tables import Missing, Table, key
from plans.scene.units import type_name
from plans.words.words import message, placed

POSITIONS_LIMIT = 100_000
MANY = message("limit.more", name="POSITIONS_LIMIT", limit=POSITIONS_LIMIT)
LINKS_LIMIT = 60

LETTER = re.compile(r"[A-ZА-ЯЁ][0-9]*[′']*")
LINK = re.compile(r"[1-9][0-9]{0,5}")
LINKS_OF_PAIR = re.compile(r"(0|[1-9][0-9]{0,5})-(0|[1-9][0-9]{0,5})")
EXTREME: Final = "extreme"


def split_letters(text: str) -> tuple[str, ...]:
    """Split the letters of a link or a line into its points; nothing where they are no letters.

    >>> split_letters("OAB1"), split_letters("O'B"), split_letters("crank")
    (('O', 'A', 'B1'), ("O'", 'B'), ())
    """
    points = LETTER.findall(text)
    return tuple(points) if "".join(points) == text else ()


def split_line(text: str) -> tuple[str, ...]:
    """Split the key of a length: two letters, or two longer names with a hyphen between them."""
    return split_letters(text) or tuple(text.split("-"))


def check_letters(value: object) -> tuple[str, ...]:
    """Read the points of a link or a line: letters in a row, or a list of longer names."""
    if isinstance(value, list) and value:
        few(value, LINKS_LIMIT, "LINKS_LIMIT")
        names = tuple(check_name(name) for name in value)
    elif isinstance(value, str):
        names = split_letters(value)
        few(list(names), LINKS_LIMIT, "LINKS_LIMIT")
        if not names:
            raise wrong("letters")
    else:
        raise wrong("wrong_type", wanted="letters of points", found=type_name(value), example=sample("OA"))
    return no_repeats(names)


def check_line(value: object) -> tuple[str, ...]:
    """Read a line named by two points, as along = "CB"; equal points have no direction."""
    if isinstance(value, int | Decimal) and not isinstance(value, bool):
        wanted, example = "letters of points", f"along = {{ through = [0, 0], angle = {value} }}"
        raise wrong("wrong_type", wanted=wanted, found=type_name(value), example=example)
    if isinstance(value, str) and len(set(split_letters(value))) == 1 == len(split_letters(value)) - 1:
        raise wrong("no_direction", first=value[: len(value) // 2], second=value[len(value) // 2 :])
    names = check_letters(value)
    if len(names) != 2:
        raise wrong("two_letters")
    return names


def check_pair_name(value: object) -> str:
    """Read the name of a pair of links, the lower number first: 0-1."""
    found = LINKS_OF_PAIR.fullmatch(value) if isinstance(value, str) else None
    low, high = sorted((int(found[1]), int(found[2]))) if found else (0, 0)
    if low == high or value != f"{low}-{high}":
        raise wrong("pair_name", example="0-1" if low == high else f"{low}-{high}")
    return f"{low}-{high}"


def moving_link(value: object) -> int:
    """Read the number of a moving link."""
    if value == 0 and not isinstance(value, bool):
        raise wrong("frame_moves")
    return whole(value, 1)


def link_key(key: object) -> int:
    """Read a key that is a link's number; 0 is the frame."""
    if not LINK.fullmatch(str(key)):
        raise wrong("link_number")
    return int(str(key))


def start_angle(value: object) -> Decimal | Literal["extreme"]:
    """Read the first crank angle, or the word extreme."""
    if isinstance(value, str) and re.fullmatch(r"[A-Za-z_ ]+", value):
        choice(value, (EXTREME,))
        return EXTREME
    return units.angle(value)


def count_positions(value: object) -> int:
    """Read the number of positions, before anything of that size is made."""
    if isinstance(value, Decimal) or (isinstance(value, int) and not isinstance(value, bool)):
        value = whole(value, 1)
    else:
        wanted = "a whole number, or a list of crank angles"
        raise wrong("wrong_type", wanted=wanted, found=type_name(value), example="positions = 12")
    if value > POSITIONS_LIMIT:
        raise LimitError(placed(f"drive.positions = {value}", MANY))
    return value


def position_list(value: tuple[Decimal, ...]) -> tuple[Decimal, ...]:
    """See that no position of a list is given twice, a turn more or less included."""
    if not value:
        raise wrong("empty")
    if len(value) > POSITIONS_LIMIT:
        raise LimitError(placed("drive.positions", MANY))
    met: dict[Decimal, Decimal] = {}
    for place in value:
        # In EXACT the remainder is exact; a whole turn more is the same position of the crank.
        turn = units.EXACT.remainder(place, Decimal(360))
        turn = units.EXACT.add(turn, Decimal(360)) if turn < 0 else turn
        if turn in met:
            raise wrong("repeated", entry=f"{place.normalize(units.WORKING):f} deg", at=(len(met),))
        met[turn] = place
    return value


FEW_LINKS = Check(partial(few, limit=LINKS_LIMIT, name="LINKS_LIMIT"), most=LINKS_LIMIT)

# What editors are told of letters: their regular expressions know no class of signs by meaning.
_LETTER = r"[A-ZА-ЯЁ][0-9]*['\u2032]*"


def _letters(pattern: str, least: int, most: int) -> forms.Form:
    names = forms.entries(forms.text(f"^{forms.POINT}$", NAME_LIMIT), least, most, uniqueItems=True)
    return {"anyOf": [forms.text(pattern), names]}


LETTERS = one(check_letters, lambda: _letters(f"^({_LETTER})+$", 1, LINKS_LIMIT), "points")
LINE = one(check_line, lambda: _letters(f"^({_LETTER}){{2}}$", 2, 2), "two points")
LENGTH_NAME = one(
    lambda key: key, lambda: forms.text(f"^({_LETTER}{_LETTER}|{forms.POINT}-{forms.POINT})$"), "two points"
)
LINK_NUMBER = one(link_key, lambda: forms.text(r"^[1-9][0-9]{0,5}$"), "link")  # as a key
PAIR = one(check_pair_name, lambda: forms.text(r"^(0|[1-9][0-9]{0,5})-[1-9][0-9]{0,5}$"), '"0-1"')
MOVING_LINK = one(moving_link, lambda: forms.whole(1), "link")
ANY_LINK = one(whole, lambda: forms.whole(0), "link", least=0)
START = one(start_angle, lambda: {"anyOf": [{"const": EXTREME}, ANGLE.form()]}, f'degrees, or "{EXTREME}"')
COUNT = one(count_positions, lambda: {**forms.whole(1), "maximum": POSITIONS_LIMIT}, "number")
POSITIONS = either(list, many(ANGLE, Check(position_list, least=1, most=POSITIONS_LIMIT)), COUNT)
SPEED = f.not_negative(units.VELOCITY)
ACCELERATION = f.number(units.ACCELERATION)


def law_speed(value: object) -> Decimal:
    """Read a speed of a law over the way, m/s, or rest.

    >>> law_speed("20 mm/s"), law_speed(0)
    (Decimal('0.02'), Decimal('0'))
    """
    found = units.quantity(value, units.VELOCITY)
    return found if found == 0 else units.positive(value, units.VELOCITY)


SPEEDS = one(law_speed, partial(forms.quantity, units.VELOCITY, minimum=0), units.VELOCITY.si)

Place = tuple[Decimal, Decimal]


class LineTable(Table):
    """A line of the frame or of a link: it needs no second point that would show its direction."""

    link: int = key(ANY_LINK, FRAME, meaning="The link that bears the line, its slot or its rod; default: the frame.")
    through: Place | str | None = key(
        either(list, f.PLACE, f.POINT),
        None,
        meaning="A point of the line: its place, of a link in the link's own frame, or the letter of a point of the "
        "link; default: the first point of the link.",
        missing=Missing("point of the line", "through = [0, 0]"),
    )
    angle: Decimal = key(
        f.ANGLE, Decimal(0), meaning="Angle of the line from +x, of a link from the link's own +x, counter-clockwise."
    )

    @property
    def letter(self) -> str | None:
        """The letter that names the point of the line."""
        return self.through if isinstance(self.through, str) else None

    def place(self, points: Mapping[str, Place]) -> Place | None:
        """Give the point of the line, by the places of its link's points."""
        return self.through if isinstance(self.through, tuple) else points.get(self.through or next(iter(points)))

    @classmethod
    def misfits(cls, value: Mapping[str, Any]) -> Iterator[Wrong]:
        """Give the point that a line of the frame lacks."""
        if "through" not in value and value.get("link", FRAME) == FRAME:
            yield wrong("missing", at=("through",))

    @classmethod
    def rules(cls) -> Form:
        """Say that a line of the frame needs a point."""
        return {"anyOf": [{"required": ["through"]}, {"required": ["link"], "properties": {"link": {"minimum": 1}}}]}


class StrokeTable(Table):
    """The stroke of a primary link that slides: places of its point along the guide, metres, and its speed.

    Of a cylinder between two points it is told by their distance.
    """

    between: tuple[str, ...] | None = key(
        LINE,
        None,
        meaning='A cylinder that drives, by the points that it acts between, "EF": of two links, or a fixed one and '
        "one of a link; the stroke is told by their distance. Default: a link that slides on the frame is pushed "
        "along.",
    )
    from_: Decimal = key(
        f.COORDINATE,
        meaning="Where the stroke begins: the slider's point from the point that the guide is given through, along it.",
        missing=Missing("place along the guide", 'from = "100 mm"', 0),
    )
    to: Decimal = key(
        f.COORDINATE, meaning="Where it ends.", missing=Missing("place along the guide", 'to = "500 mm"', 1)
    )
    speed: Decimal | None = key(
        SPEED,
        None,
        meaning='Speed of the slider, also as "40 mm/s", from the one place to the other: the same in all positions.',
        missing=Missing("speed of the slider", 'speed = "40 mm/s"', 1),
    )
    acceleration: Decimal = key(ACCELERATION, Decimal(0), meaning="Acceleration of the slider, in the same sense.")
    speeds: tuple[Decimal, ...] = key(
        many(SPEEDS, first=f.FEW),
        (),
        meaning="In place of a speed its law over the stroke (закон движения): speeds at places, straight lines "
        "between them; the acceleration follows. 0 at an end is rest, with one acceleration from it or to it.",
    )
    places: tuple[Decimal, ...] = key(
        many(f.COORDINATE, first=f.FEW),
        (),
        meaning="The places of these speeds, from the one end to the other; default: evenly over the stroke.",
    )

    @property
    def sense(self) -> int:
        """Whether it goes along the guide, +1, or back, -1."""
        return 1 if self.to > self.from_ else -1

    @property
    def rates(self) -> tuple[float, float]:
        """The signed speed m/s and acceleration m/s2; of a law its first speed alone that is none of rest."""
        speed = next(filter(None, self.speeds), Decimal(0)) if self.speeds else self.speed or Decimal(0)
        return self.sense * float(speed), self.sense * float(self.acceleration)

    @property
    def law(self) -> tuple[tuple[float, float], ...]:
        """The law: places m that rise, and signed speeds m/s there; none where one speed is told."""
        even = [self.from_ + (self.to - self.from_) * k / max(len(self.speeds) - 1, 1) for k in range(len(self.speeds))]
        pairs = zip(self.places or even, self.speeds, strict=True)
        return tuple(sorted((float(place), self.sense * float(speed)) for place, speed in pairs))

    def check(self) -> None:
        """See that the stroke has a length, and that a law is told over the whole of it."""
        if self.from_ == self.to:
            raise wrong("no_stroke", at=("to",))
        if self.speeds and "acceleration" in self.given:
            raise wrong("one_of_two", first="acceleration", second="speeds", found="both", at=("acceleration",))
        if self.places or "speeds" in self.given:
            self._check_law()

    def _check_law(self) -> None:
        places = self.places or (self.from_, self.to)
        steps = [self.sense * (high - low) for low, high in pairwise(places)]
        if (places[0], places[-1]) != (self.from_, self.to) or min(steps, default=Decimal(0)) <= 0:
            raise wrong("law_places", at=("places",))
        if len(self.speeds) < 2 or (self.places and len(self.places) != len(self.speeds)):
            raise wrong("law_speeds", count=max(len(self.places), 2), at=("speeds",))
        rests = [k for k, speed in enumerate(self.speeds) if not speed]
        inside = [k for k in rests if 0 < k < len(self.speeds) - 1] or (rests[1:] if len(self.speeds) == 2 else [])
        if inside:
            raise wrong("law_at_rest", at=("speeds", inside[0]))

    @classmethod
    def misfits(cls, value: Mapping[str, Any]) -> Iterator[Wrong]:
        """Give the speed that a stroke lacks, or has twice."""
        if not {"speed", "speeds"} & value.keys():
            yield wrong("missing", at=("speed",))
        if {"speed", "speeds"} <= value.keys():
            yield wrong("one_of_two", first="speed", second="speeds", found="both", at=("speed",))

    @classmethod
    def rules(cls) -> Form:
        """Say that a stroke has a speed or a law."""
        return {"oneOf": [{"required": ["speed"]}, {"required": ["speeds"]}]}
