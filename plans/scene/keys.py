"""The keys of a scene: what each means and the form of its value, as editors tell it (ключи исходных данных)."""

from __future__ import annotations

from collections.abc import Mapping

from plans.model.machine import IDLE, WORKING
from plans.model.mechanism import THROUGH
from plans.scene import units
from plans.scene.faults import Path
from plans.scene.fields import LINKS_LIMIT, POSITIONS_LIMIT
from plans.scene.forms import (
    ANGLE,
    ANY_LINK,
    COORDINATE,
    FORCE,
    FRICTION,
    GRAVITY,
    LENGTH,
    LENGTH_NAME,
    LETTERS,
    LINE,
    LINK,
    MOVING,
    NAME,
    PAIR,
    PLACE,
    POINT,
    POSITION,
    SHARE,
    SYMBOL,
    TEXT,
    Form,
    choice,
    entries,
    named,
    pair,
    quantity,
    rate,
    whole,
)
from plans.scene.loads import DURING
from plans.scene.scene import (
    BALANCINGS,
    FORMATS,
    LANGUAGES,
    LETTERINGS,
    NOTATIONS,
    ORIENTATIONS,
    REACTIONS,
    SHEETS,
    STANDARDS,
)
from plans.scene.units import PRESSURE_LIMIT

LETTERED = ("Its letters on the sheet; default: F_us, F_D, M_3, F_s.", SYMBOL)
# What forces and moments have in common.
WHEN: Mapping[str, tuple[str, Form]] = {
    "during": ("Which part of the turn.", choice(DURING)),
    "overrun": (
        "Shares of the stroke at its ends (перебег) in which the load rests: one, or [start, end].",
        {"anyOf": [SHARE, pair(SHARE)]},
    ),
    "stroke": ("The point whose stroke counts; default: the output's.", NAME),
    "useful": ("Whether its work is the machine's purpose.", {"type": "boolean"}),
    "name": LETTERED,
}
# Each key of each table: what it means, and its form; a table within it is that of the longer path.
KEYS: Mapping[Path, Mapping[str, tuple[str, Form]]] = {
    (): {
        "title": ("Title of the sheet and the report.", TEXT),
        "sheets": ("The sheets that are wanted.", entries(choice(SHEETS), 1, uniqueItems=True)),
        "mechanism": ("The linkage: frame, links, lengths, slides and a rough sketch.", {}),
        "drive": ("The drive (начальное звено): crank, speed and positions.", {}),
        "output": ("The output link (выходное звено); default: the last link on the frame of the last group.", {}),
        "masses": ("Masses of links, by their numbers.", {}),
        "loads": ("Gravity, forces, moments and springs.", {}),
        "friction": ("Friction of the pairs (трение).", {}),
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
        "through": ("What carries the linkage through its change points; default: nothing.", choice(THROUGH)),
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
        "balancing": (
            "What balances the crank: a moment, a coupling (муфта), or a force at its end, square to it.",
            choice(BALANCINGS),
        ),
        "gear": ("The gear that drives the machine; without it the drive is a pure moment.", {}),
    },
    ("drive", "gear"): {
        "radius": ("Pitch radius, m.", LENGTH),
        "at": ("Where the driving pinion meets the wheel, degrees.", ANGLE),
        "pressure_angle": (
            "Pressure angle of the teeth (угол зацепления), degrees.",
            quantity(units.ANGLE, minimum=0, maximum=float(PRESSURE_LIMIT)),
        ),
    },
    ("output",): {
        "link": ("Number of the output link.", MOVING),
        "point": ("A point of the output link.", NAME),
    },
    ("masses", "*"): {
        "mass": ("Mass, kg.", quantity(units.MASS, minimum=0)),
        "inertia": ("Moment of inertia about the mass centre, kg*m2.", quantity(units.INERTIA, minimum=0)),
        "centre": (
            'Mass centre in the link\'s own frame, m; "middle", or a point of the link.',
            {"anyOf": [NAME, PLACE]},
        ),
    },
    ("loads",): {
        "gravity": (
            "Gravity, m/s2: downward, or [gx, gy]; without it links have no weight.",
            {"anyOf": [GRAVITY, pair(GRAVITY)]},
        ),
        "forces": ("Forces on points of links.", {}),
        "moments": ("Moments on links.", {}),
        "springs": ("Springs between points of two links (пружины).", {}),
    },
    ("loads", "forces", "*"): {
        "on": ("Number of the link.", MOVING),
        "point": ("Point of the link.", NAME),
        "value": (
            "Force [Fx, Fy], N; or its size, against the motion or in a direction.",
            {"anyOf": [FORCE, pair(FORCE)]},
        ),
        "against": ("The force acts against the motion of its point.", choice(("motion",))),
        "direction": ("The direction of the force, degrees from +x.", ANGLE),
        "diagram": ("The size of the force over the stroke.", {}),
        **WHEN,
    },
    ("loads", "forces", "*", "diagram"): {
        "travel": (
            "Shares of the stroke, rising from 0, where the working stroke begins, to 1.",
            entries({"type": "number", "minimum": 0, "maximum": 1}, 2),
        ),
        "force": ("The force at each, N.", entries(FORCE, 2)),
        "back": ("The force at each on the idle stroke, N, as of an indicator diagram.", entries(FORCE, 2)),
    },
    ("loads", "moments", "*"): {
        "on": ("Number of the link.", MOVING),
        "value": (
            "Moment, N*m, positive counter-clockwise; or its size, against the rotation.",
            quantity(units.MOMENT),
        ),
        "against": ("The moment acts against the rotation of its link.", choice(("motion",))),
        **WHEN,
    },
    ("loads", "springs", "*"): {
        "between": ('Its two ends: points of two links, ["B", "O"].', NAME),
        "stiffness": ("Stiffness, N/m.", quantity(units.STIFFNESS, exclusiveMinimum=0)),
        "free": ("Free length, m.", quantity(units.LENGTH, minimum=0, maximum=float(units.LENGTH_LIMIT))),
        "name": LETTERED,
    },
    ("loads", "springs", "*", "between", "*"): {
        "on": ("Number of the link, where several have the point.", ANY_LINK),
        "point": ("Point of the link.", NAME),
    },
    ("friction",): {
        "coefficient": ("Reduced coefficient of friction of all pairs (приведённый коэффициент трения).", FRICTION),
        "radius": ("Journal radius of the hinges (радиус цапфы), m.", LENGTH),
        "length": ("Length of contact of the slides, m; without it reactions do not lean on edges.", LENGTH),
        "pairs": ('What differs in single pairs, by their links: "0-1".', {}),
    },
    ("friction", "pairs", "*"): {
        "coefficient": ("Reduced coefficient of friction.", FRICTION),
        "radius": ("Journal radius of a hinge, m.", LENGTH),
        "length": ("Length of contact of a sliding pair, m.", LENGTH),
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
        "forces": (
            "Positions of the force sheets; default: the one in full lines.",
            entries(POSITION, uniqueItems=True),
        ),
        "reactions": ("The letter of reactions.", choice(REACTIONS)),
        "hodographs": (
            'Pairs whose reaction is drawn over the turn (годограф): "0-1".',
            entries({"type": "string", "pattern": PAIR}, uniqueItems=True),
        ),
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
_ASIDE: list[Form] = [{"required": ["against"]}, {"required": ["direction"]}]
_PART: Form = {"required": ["during"], "properties": {"during": {"enum": [WORKING, IDLE]}}}
_BACK = {"diagram": {"required": ["back"]}}


def _strokes(*others: Form) -> Form:
    """Give the rule that only a load which changes over a stroke names one."""
    return {"dependentSchemas": {"stroke": {"anyOf": [_PART, {"required": ["overrun"]}, *others]}}}


# What keys of one table mean for each other.
RULES: Mapping[Path, Form] = {
    ("drive",): {
        "not": {
            "anyOf": [
                {"required": ["start", "positions"], "properties": {"positions": _LIST}},
                {"required": ["balancing", "gear"]},
            ]
        }
    },
    ("output",): {"oneOf": [{"required": ["link"]}, {"required": ["point"]}]},
    ("loads", "forces", "*"): {
        "oneOf": [{"required": ["value"]}, {"required": ["diagram"]}],
        "if": {"required": ["value"], "properties": {"value": _LIST}},
        "then": {"not": {"anyOf": _ASIDE}},
        "else": {"oneOf": _ASIDE},
        "not": {"required": ["diagram", *_PART["required"]], "properties": _PART["properties"] | _BACK},
        **_strokes({"required": ["diagram"]}),
    },
    ("loads", "moments", "*"): _strokes(),
}
