"""The form of a scene as a JSON Schema (2020-12), for editors: keys, units and words are told while one writes."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from plans import units
from plans.faults import Path
from plans.fields import ENTRIES_LIMIT, LINKS_LIMIT, NAME_LIMIT, POSITIONS_LIMIT, TITLE_LIMIT
from plans.loads import DURING
from plans.scene import (
    FORMATS,
    LANGUAGES,
    LETTERINGS,
    NOTATIONS,
    ORIENTATIONS,
    SHEETS,
    STANDARDS,
    TABLES,
)
from plans.tables import REQUIRED
from plans.units import ANGLE_LIMIT, LENGTH_LEAST, LENGTH_LIMIT, RATE_LIMIT, Kind

Form = dict[str, Any]

DRAFT = "https://json-schema.org/draft/2020-12/schema"
NUMBER = r"\s*[+-]?[0-9]+(\.[0-9]+)?([eE][+-]?[0-9]+)?\s*"
# Any letter of any alphabet, in what the regular expressions of all editors understand: no class of signs in ASCII.
ANY_LETTER = r"[A-Za-z\u00aa-\uffff]"
POINT = rf"{ANY_LETTER}[0-9A-Za-z_\u00aa-\uffff]*['\u2032]*"
LETTER = r"[A-ZА-ЯЁ][0-9]*['\u2032]*"
LINK = r"^[1-9][0-9]{0,5}$"


def text_with_unit(kind: Kind) -> str:
    """Give the pattern of a number with a unit; kg·m², kg*m^2 and kg m2 are one unit.

    >>> import re
    >>> [bool(re.search(text_with_unit(units.MOMENT), text)) for text in ("3 N·m", "3 N m", "3 N", "3 m*N")]
    [True, True, False, False]
    """
    written = [
        "".join({"*": r"(\s*[*·⋅]\s*|\s+)", "/": r"\s*/\s*", "2": r"(2|²|\^2|\*\*2)"}.get(sign, sign) for sign in unit)
        for unit in kind.units
    ]
    return rf"^{NUMBER}({'|'.join(written)})\s*$"


def quantity(kind: Kind, **bounds: float) -> Form:
    """Give the form of a quantity: a bare number in SI units (angles: degrees), or text with a unit."""
    number: Form = {"type": "number", **bounds}
    if not kind.units:
        return number
    return {"anyOf": [number, {"type": "string", "pattern": text_with_unit(kind)}]}


def rate(kind: Kind) -> Form:
    """Give the form of an angular velocity or acceleration."""
    return quantity(kind, minimum=-float(RATE_LIMIT), maximum=float(RATE_LIMIT))


def whole(least: int) -> Form:
    """Give the form of a whole number."""
    return {"type": "integer", "minimum": least}


def entries(form: Form, least: int = 0, most: int = ENTRIES_LIMIT, **more: Any) -> Form:
    """Give the form of a list."""
    return {"type": "array", "items": form, "minItems": least, "maxItems": most, **more}


def pair(form: Form) -> Form:
    """Give the form of two numbers."""
    return entries(form, 2, 2)


def named(form: Form, pattern: str, most: int = ENTRIES_LIMIT, **more: Any) -> Form:
    """Give the form of a table whose keys are names or numbers of one pattern."""
    table = {"type": "object", "patternProperties": {pattern: form}, "additionalProperties": False}
    return {**table, "maxProperties": most, **more}


LENGTH = quantity(units.LENGTH, exclusiveMinimum=0, minimum=float(LENGTH_LEAST), maximum=float(LENGTH_LIMIT))
COORDINATE = quantity(units.LENGTH, minimum=-float(LENGTH_LIMIT), maximum=float(LENGTH_LIMIT))
ANGLE = quantity(units.ANGLE, minimum=-float(ANGLE_LIMIT), maximum=float(ANGLE_LIMIT))
FORCE, GRAVITY = quantity(units.FORCE), quantity(units.ACCELERATION)
PLACE = pair(COORDINATE)
NAME = {"type": "string", "pattern": f"^{POINT}$", "maxLength": NAME_LIMIT}
NAMES = entries(NAME, 1, LINKS_LIMIT, uniqueItems=True)
LETTERS = {"anyOf": [{"type": "string", "pattern": f"^({LETTER})+$"}, NAMES]}
LINE = {"anyOf": [{"type": "string", "pattern": f"^({LETTER}){{2}}$"}, {**NAMES, "minItems": 2, "maxItems": 2}]}
TEXT = {"type": "string", "maxLength": TITLE_LIMIT}
MOVING, ANY_LINK, POSITION = whole(1), whole(0), whole(0)
LENGTH_NAME = f"^({LETTER}{LETTER}|{POINT}-{POINT})$"


def choice(words: tuple[str, ...], **more: Any) -> Form:
    """Give the form of one of some words."""
    return {"enum": list(words), **more}


# Each key of each table: what it means, and its form; a table within it is that of the longer path.
KEYS: Mapping[Path, Mapping[str, tuple[str, Form]]] = {
    (): {
        "title": ("Title of the sheet and the report.", TEXT),
        "sheets": ("The sheets that are wanted.", entries(choice(SHEETS), 1, uniqueItems=True)),
        "mechanism": ("The linkage: frame, links, lengths, slides and a rough sketch.", {}),
        "drive": ("The drive (начальное звено): crank, speed and positions.", {}),
        "output": ("The output link (выходное звено); default: the last link of the last group.", {}),
        "masses": ("Masses of links, by their numbers.", {}),
        "loads": ("Gravity, forces and moments.", {}),
        "sheet": ("What stands on the sheet: language, format, positions, title block.", {}),
    },
    ("mechanism",): {
        "frame": ("Fixed points (стойка), metres: O = [0, 0].", named(PLACE, f"^{POINT}$", minProperties=1)),
        "links": (
            'Moving links (звенья): number = the letters of its points, 1 = "OA", or a list of longer names.',
            named(LETTERS, LINK, LINKS_LIMIT, minProperties=1),
        ),
        "lengths": ('Lengths, m or text with a unit: OA = 0.110 or "110 mm".', named(LENGTH, LENGTH_NAME)),
        "points": ("Points by their place in a link's own frame: first point 0, second on +x.", {}),
        "slides": ("Sliding pairs (поступательные пары).", {}),
        "sketch": ("Rough places at the first position, m: they choose the assembly.", named(PLACE, f"^{POINT}$")),
    },
    ("mechanism", "slides", "*"): {
        "link": ("Number of the sliding link.", MOVING),
        "along": ('The line it slides along: two letters of another link, "CB", or a line of the frame.', LINE),
        "point": ("Point of the link on that line; default: its first.", NAME),
        "offset": ("Distance of that point to the left of the line, m.", COORDINATE),
        "angle": ("Angle of the link to the line, degrees.", ANGLE),
    },
    ("mechanism", "slides", "*", "along"): {
        "through": ("A point of the line, m.", PLACE),
        "angle": ("Angle of the line from +x, degrees.", ANGLE),
    },
    ("mechanism", "points", "*"): {
        "on": ("Number of the link.", ANY_LINK),
        "at": ("Place in the link's own frame, m.", PLACE),
    },
    ("drive",): {
        "link": ("Number of the crank (кривошип).", MOVING),
        "speed": ('Angular speed, rad/s or "60 rpm"; positive is counter-clockwise.', rate(units.SPEED)),
        "acceleration": ("Angular acceleration, rad/s2.", rate(units.ANGULAR_ACCELERATION)),
        "start": ('First crank angle, degrees from +x, or "extreme".', {"anyOf": [{"const": "extreme"}, ANGLE]}),
        "positions": (
            "Number of equal steps over a turn, or a list of crank angles in degrees (then no start).",
            {"anyOf": [{**whole(1), "maximum": POSITIONS_LIMIT}, entries(ANGLE, 1, POSITIONS_LIMIT)]},
        ),
        "gear": ("The gear that drives the machine; without it the drive is a pure moment.", {}),
    },
    ("drive", "gear"): {
        "radius": ("Pitch radius, m.", LENGTH),
        "at": ("Where the driving pinion meets the wheel, degrees.", ANGLE),
        "pressure_angle": ("Pressure angle of the teeth (угол зацепления), degrees.", ANGLE),
    },
    ("output",): {
        "link": ("Number of the output link.", MOVING),
        "point": ("A point of the output link.", NAME),
    },
    ("masses", "*"): {
        "mass": ("Mass, kg.", quantity(units.MASS, minimum=0)),
        "inertia": ("Moment of inertia about the mass centre, kg*m2.", quantity(units.INERTIA, minimum=0)),
        "centre": ('Mass centre in the link\'s own frame, m, or "middle".', {"anyOf": [{"const": "middle"}, PLACE]}),
    },
    ("loads",): {
        "gravity": ("Gravity, m/s2: downward, or [gx, gy].", {"anyOf": [GRAVITY, pair(GRAVITY)]}),
        "forces": ("Forces on points of links.", {}),
        "moments": ("Moments on links.", {}),
    },
    ("loads", "forces", "*"): {
        "on": ("Number of the link.", MOVING),
        "point": ("Point of the link.", NAME),
        "value": ("Force [Fx, Fy], N; or its size, against the motion.", {"anyOf": [FORCE, pair(FORCE)]}),
        "against": ("The force acts against the motion of its point.", choice(("motion",))),
        "during": ("Which part of the turn.", choice(DURING)),
        "diagram": ("The size of the force over the working stroke.", {}),
    },
    ("loads", "forces", "*", "diagram"): {
        "travel": ("Shares of the working stroke, rising from 0 to 1.", entries({"type": "number"}, 2)),
        "force": ("The force at each, N.", entries(FORCE, 2)),
    },
    ("loads", "moments", "*"): {
        "on": ("Number of the link.", MOVING),
        "value": ("Moment, N*m, positive counter-clockwise.", quantity(units.MOMENT)),
        "during": ("Which part of the turn.", choice(DURING)),
    },
    ("sheet",): {
        "language": ("Language of sheets and messages.", choice(LANGUAGES)),
        "standard": ("Standard of the drawing.", choice(STANDARDS)),
        "format": ("Format of the sheet.", choice(FORMATS)),
        "orientation": ("Default: landscape, and portrait for A4.", choice(ORIENTATIONS)),
        "lettering": ("Lettering as strokes of our own alphabet, or as text.", choice(LETTERINGS)),
        "notation": ("Scale factors mu (true units a mm), or K = 1/mu.", choice(NOTATIONS)),
        "plans": ("Positions whose plans are drawn.", entries(POSITION, uniqueItems=True)),
        "position": ("The position in full lines.", POSITION),
        "designation": ("Designation of the document, for the title block.", TEXT),
        "drawn": ("Who drew the sheet.", TEXT),
        "checked": ("Who checked it.", TEXT),
        "approved": ("Who approved it.", TEXT),
        "date": ("Date, as it shall stand on the sheet.", TEXT),
        "group": ("Group of students.", TEXT),
        "organisation": ("Organisation.", TEXT),
    },
}
_LIST = {"type": "array"}
# What keys of one table mean for each other.
RULES: Mapping[Path, Form] = {
    ("drive",): {"not": {"required": ["start", "positions"], "properties": {"positions": _LIST}}},
    ("output",): {"oneOf": [{"required": ["link"]}, {"required": ["point"]}]},
    ("loads", "forces", "*"): {
        "oneOf": [{"required": ["value"]}, {"required": ["diagram"]}],
        "if": {"required": ["against"]},
        "then": {"not": {"required": ["value"], "properties": {"value": _LIST}}},
        "else": {"required": ["value"], "properties": {"value": _LIST}},
    },
}


def schema() -> Form:
    """Give the JSON Schema of a scene."""
    return {"$schema": DRAFT, "title": "plandraft scene", **_table(())}


def _table(path: Path) -> Form:
    """Give the form of a table: its keys, which of them it must have, and no others."""
    keys = TABLES[path].form
    properties = {key: {"description": KEYS[path][key][0], **_form(path, key)} for key in keys}
    required = [key for key, known in keys.items() if known.default is REQUIRED]
    table: Form = {"type": "object", "properties": properties, "additionalProperties": False}
    return {**table, **({"required": required} if required else {}), **RULES.get(path, {})}


def _form(path: Path, key: str) -> Form:
    """Give the form of a key: its own, a table, a list of tables, or a table of tables by number or name."""
    within, many = (*path, key), (*path, key, "*")
    if many in TABLES:
        if key in ("slides", "forces", "moments"):
            return entries(_table(many))
        return named(_table(many), LINK, LINKS_LIMIT) if key == "masses" else named(_table(many), f"^{POINT}$")
    own = KEYS[path][key][1]
    if within not in TABLES:
        return own
    return {"anyOf": [own, _table(within)]} if own else _table(within)
