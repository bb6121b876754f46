"""Faults of a scene (ошибки исходных данных): where, what stands there, what was expected, and what to change."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from geometry.errors import DraftError

Path = tuple[str | int, ...]

SHOWN = 20  # faults that an error message lists before "and n more"
VALUE_WIDTH = 60  # characters of a value that a message quotes
DETAIL_WIDTH = 200  # characters of whatever else of the file a message quotes
NAME_WIDTH = 100  # characters of a misspelt name that are compared with the known ones
BARE = re.compile(r"[A-Za-z0-9_-]+")

# Each kind of fault: what was expected, and the advice. Every word that a reader of faults sees is in this table.
WORDS: Mapping[str, tuple[str, str]] = {
    # the file as bytes and as TOML
    "not_utf8": (
        "text in UTF-8, but byte {offset} is not",
        "save the file as UTF-8 (in Notepad: Save as, Encoding UTF-8)",
    ),
    "utf16": ("text in UTF-8, but the file is in {encoding}", "save the file as UTF-8"),
    "not_text": ("a scene in TOML, but this is not a text file", "give the scene file itself"),
    "json": ("a scene in TOML, but this looks like JSON", 'write "key = value" lines, as in the example scenes'),
    "syntax": ("TOML; {message}", "see the example scenes for the form of a line"),
    "lookalike": (
        "plain signs of the keyboard, but found {code}, which only looks like {twin}",
        "write {twin} instead",
    ),
    "unseen": ("only visible characters, but found {code}", "delete it"),
    "line_ends": ("lines that end with LF or CRLF", "save the file with Unix or Windows line ends"),
    "comma": ("a number with a decimal point", "use a point: {written}"),
    "number_form": ("a number with digits on both sides of the point and no leading zeros", "write {written}"),
    "exponent": ("digits after the e of a number", "write the exponent, as in 1e-3"),
    "hexadecimal": ("a decimal number", "write it with the digits 0 to 9 only"),
    "huge_integer": ("a number of reasonable length", "round it to the digits that you know"),
    "bare_text": ("a number, or text in quotes", 'put text in quotes: "{text}"'),
    "bare_key": ("a name of Latin letters, digits, - and _, or a name in quotes", 'write "{text}" = ... in quotes'),
    "open_bracket": ("the bracket {bracket} that opens here to be closed", "add the closing bracket"),
    "open_quote": ("the quote that opens here to be closed", "add the closing quote"),
    "duplicate": ("each name once, but it is written here and on line {line}", "keep one of the two"),
    # single values
    "missing": ("this {thing}", "add it: {example}"),
    "unknown_key": ("a key of {table}: {known}", "{suggestion}"),
    "wrong_type": ("{wanted}, but found {found}", "write it as {example}"),
    "not_a_number": ("a number ({kind}), but found {found}", "write a number, or a number with its unit in quotes"),
    "not_a_quantity": ("a number with a unit ({kind}; units: {units})", "write it as {example}"),
    "text_number": (
        "a number without quotes, or a unit after it ({kind}; units: {units})",
        "write {number}, or add the unit",
    ),
    "wrong_unit": (
        "a unit of {kind} ({units}), but found {unit}",
        "write it as {example}, or a bare number in SI units",
    ),
    "decimal_comma": ("a number ({kind}) with a decimal point", "use a point: {written}"),
    "not_finite": ("a finite number ({kind})", "write a number that can be measured"),
    "not_positive": ("this {kind} to be greater than 0", "check the value and its unit"),
    "negative": ("this {kind} not to be negative", "check the sign"),
    "out_of_range": ("this {kind} to be between {least} and {most} {unit}", "check the value and its unit"),
    "not_whole": ("a whole number from {least}", "write it without a fraction and without quotes"),
    "pair": ("2 numbers {what}, but found {found}", "{advice}"),
    "choice": ("one of {choices}", "{suggestion}"),
    "sheet_name": ("a sheet that this version draws: {choices}", "{suggestion}"),
    "empty": ("at least one entry", "add one, or leave the key out"),
    "repeated": ("each entry once, but {entry} is repeated", "keep one of them"),
    "text": ("visible text, but found {code}", "delete that character"),
    "text_length": ("text of at most {most} characters", "shorten it"),
    "name": ("the name of a point: letters, then digits or primes, as A, B1, O'", "rename the point"),
    "letters": (
        "letters of points: a capital with digits or primes each, as OA, AB1, O'B",
        'write capitals, or longer names as a list: ["crank", "pin"]',
    ),
    "link_number": ("a link number: 1, 2, 3, ... (0 is the frame)", "number the moving links from 1"),
    "two_letters": ("two points of one link", "name the line by its two ends, as AB"),
    "one_of_two": ("either {first} or {second}, not {found}", "keep one of them"),
    "start_with_list": ("no start beside a list of positions", "leave start out: the list gives the crank angles"),
    "position_number": (
        "a position from 0 to {most}: the drive has {count} positions",
        "give a number of that range, or more positions",
    ),
    "force_value": ("{wanted}", "{advice}"),
    "diagram": ("travel and force lists of one length, travel rising from 0 to 1", "give one force for each travel"),
    "invalid": ("{message}", "compare it with the example scenes"),
    # the mechanism
    "unknown_point": ("a point of the mechanism, but there is no point {name}", "{suggestion}"),
    "unknown_link": ("a link of [mechanism.links], but there is no link {link}", "the links are {links}"),
    "not_of_link": ("a point of link {link}: {points}; {name} is none", "{suggestion}"),
    "no_common_link": ("two points of one link, but no link has both {first} and {second}", "{suggestion}"),
    "fixed_length": ("a length of a moving link, but {first} and {second} are fixed", "their places give the distance"),
    "twice": ("each length once, but {first} is also written on line {line}", "keep one of the two"),
    "spare_length": (
        "only the lengths from a point to the first two points of its link ({needed})",
        "leave this one out, it follows from the others",
    ),
    "no_length": ("the length {name} of link {link}", "add {name} = ... to [mechanism.lengths]"),
    "no_place": (
        "point {name} of link {link} to be placed",
        "add the lengths {lengths}, or [mechanism.points] {name} = {{ on = {link}, at = [x, y] }}",
    ),
    "open_triangle": (
        "a triangle that closes: {name} between {least} m and {most} m",
        "correct this length or {others}",
    ),
    "side": (
        "a sketch that shows on which side of {line} the point {name} lies ({reason})",
        "give {points} in [mechanism.sketch], or place it by [mechanism.points] {name} = {{ on = {link}, "
        "at = [x, y] }} instead of lengths",
    ),
    "second_by_place": (
        "a third point: {name} is among the first two of link {link}, which make its own axis",
        "give the length {line} instead",
    ),
    "on_frame": ("a moving link: link 0 is the frame", "put fixed points into [mechanism.frame]"),
    "placed_twice": ("one way to place {name}: it has a place in [mechanism.points]", "leave out this length"),
    "fixed_sketch": ("a moving point: {name} is fixed", "leave it out, its place is in [mechanism.frame]"),
    "not_itself": ("a line of another link", "the slide joins two different links"),
    "many_owners": ("a line of one link, but links {links} have both points", "name two points of one of them"),
    "no_direction": ("two points apart from each other, but {first} and {second} are in one place", "move one of them"),
    "no_hinge": ("a drive link with a fixed hinge", "give link {link} a point of [mechanism.frame]"),
    "many_hinges": (
        "a drive link with one fixed hinge, but {points} are all fixed",
        "leave one of them in link {link}",
    ),
    "no_end": ("a drive link with a second point", 'write it with two letters, as {link} = "{pivot}A"'),
    "fixed_output": ("a moving point, but {name} is fixed", "name a point of the output link"),
    "island": (
        "every link to be joined to the frame; not joined: {links}",
        "give it a common point with another link, or a slide",
    ),
    "mobility": (
        "mobility 1, but W = 3n - 2p = 3*{n} - 2*{p} = {found} ({hinges} hinges, {slides} slides; a hinge of k links "
        "counts k - 1)",
        "{advice}",
    ),
    "no_line": ("a link with two points, for its middle", "give the centre as [x, y]"),
}


@dataclass(frozen=True, slots=True)
class Fault:
    """One fault of a scene: file, line and column from 1, path of keys, value as written, kind and its details."""

    file: str
    line: int
    column: int
    path: Path
    value: str
    kind: str
    details: Mapping[str, object] = field(default_factory=dict)

    @property
    def expected(self) -> str:
        """What should stand there."""
        return self._worded(0)

    @property
    def advice(self) -> str:
        """What the author of the scene should change."""
        return self._worded(1)

    def _worded(self, part: int) -> str:
        details = {name: quoted(str(value), DETAIL_WIDTH) for name, value in self.details.items()}
        return WORDS[self.kind][part].format_map(details)

    def __str__(self) -> str:
        subject = quoted(dotted(self.path), DETAIL_WIDTH)
        if self.path and self.value:
            subject += f" = {quoted(self.value)}"
        subject += ": " if subject else ""
        end = "" if self.advice.endswith("?") else "."
        where = f"{quoted(self.file, 0)}:{self.line}:{self.column}"
        return f"{where}: {subject}expected {self.expected}. Fix: {self.advice}{end}"


class SceneError(DraftError, ValueError):
    """A scene file with faults; `faults` holds them in the order of the file, `unlisted` counts any beyond them."""

    def __init__(self, faults: Iterable[Fault], unlisted: int = 0) -> None:
        self.faults = tuple(sorted(faults, key=lambda fault: (fault.line, fault.column)))
        self.unlisted = unlisted
        lines = [str(fault) for fault in self.faults[:SHOWN]]
        more = len(self.faults[SHOWN:]) + unlisted
        if more:
            lines.append(f"and {more} more")
        super().__init__("\n".join(lines))


class Wrong(ValueError):  # noqa: N818  (it is caught and worded, never shown)
    """What is wrong with one value: the kind of fault and its details; the reader of the scene adds where it stands."""

    def __init__(self, kind: str, details: Mapping[str, object]) -> None:
        super().__init__(kind)
        self.kind, self.details = kind, details

    @property
    def at(self) -> Path:
        """The keys that lead from the checked value to the part that is wrong."""
        at = self.details.get("at", ())
        return at if isinstance(at, tuple) else ()


def wrong(kind: str, /, **details: object) -> Wrong:
    """Make the error that a check raises, a detail `at` saying which part of the value is wrong."""
    return Wrong(kind, details)


def dotted(path: Path) -> str:
    """Write a path as the file would: mechanism.slides[1].along, with quotes where TOML needs them.

    >>> dotted(("mechanism", "slides", 1, "along")), dotted(("frame", "O'"))
    ('mechanism.slides[1].along', 'frame."O\\'"')
    """
    text = ""
    for part in path:
        if isinstance(part, int):
            text += f"[{part}]"
        else:
            text += ("." if text else "") + (part if BARE.fullmatch(part) else f'"{part}"')
    return text


def quoted(text: str, width: int = VALUE_WIDTH) -> str:
    """Show a text of the file on one line: no control or invisible characters, at most `width` long (0: any)."""
    shown = "".join(
        char if char.isprintable() else " " if char in "\r\n\t" else f"<U+{ord(char):04X}>" for char in text
    )
    return shown[: width - 3] + "..." if width and len(shown) > width else shown


# Capitals that look alike in both alphabets: a Cyrillic А beside a Latin A is the commonest unknown point.
TWINS = str.maketrans("АВЕКМНОРСТУХ", "ABEKMHOPCTYX")


def suggestion(name: str, known: Iterable[str], otherwise: str = "check the spelling") -> str:
    """Name the nearest of the known names, or the same letter of the other alphabet."""
    names = list(known)
    twins = [other for other in names if other != name and other.translate(TWINS) == name.translate(TWINS)]
    if twins:
        return f'write "{twins[0]}": one of the two has a Cyrillic letter that looks Latin'
    found = nearest(name, names)
    return "did you mean " + " or ".join(f'"{other}"' for other in found) + "?" if found else otherwise


def nearest(name: str, known: Iterable[str]) -> list[str]:
    """Give up to three known names that are spelt nearly so, the nearest first."""
    import difflib  # noqa: PLC0415  (only a misspelt name needs it)

    folded = {other.casefold(): other for other in sorted(known)}
    return [folded[match] for match in difflib.get_close_matches(name[:NAME_WIDTH].casefold(), folded)]
