"""Students who draw on the form of a scene, as an editor draws: arrows with markers, letters in a font."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cache

from drawings.form.blank_file import blank_file
from drawings.form.form import form_of
from drawings.grading.asked import PlanAsked
from drawings.grading.form_place import FormPlace, form_places
from drawings.paper.strokes import Leaf
from tests.drawings.students import lettered, task, true_places
from tests.drawings.vector_students import laid

MARKER = '<defs><marker id="head" orient="auto"><path d="M0 0L5 2"/></marker></defs>'
LOOK = 'style="stroke:#000;fill:none;stroke-width:0.7;marker-end:url(#head)"'


@cache
def form_leaf(scene: str) -> Leaf:
    """Give the first sheet of the form of a scene of the gallery."""
    return next(iter(form_of(task(scene).originals.study).values()))[0]


def on_form(leaf: Leaf, plans: Iterable[PlanAsked], scale: float) -> bytes:
    """Draw plans at their poles on a form."""
    places = {one.plan: one for one in form_places(leaf)}
    own = "".join(_plan(plan, places[plan.place], scale, leaf.height) for plan in plans)
    return blank_file(leaf).replace(b"</svg>", f"{MARKER}{own}</svg>".encode())


def polygon_on_form(leaf: Leaf, plan: PlanAsked, share: float) -> bytes:
    """Draw a polygon about the middle of its place on a form, so much of the place wide or high."""
    place = next(one for one in form_places(leaf) if one.plan == plan.place)
    own = laid((plan,), {})
    ends = [
        spot for start, value in ((one.start, one.value) for one in own.values()) for spot in (start, start + value)
    ]
    low = complex(min(one.real for one in ends), min(one.imag for one in ends))
    size, room = max(one.real for one in ends) + 1j * max(one.imag for one in ends) - low, place.high - place.low
    scale = max(size.real / room.real, size.imag / room.imag) / share
    parts = [f'<text x="{place.low.real}" y="{leaf.height - place.high.imag}">mu_{plan.symbol} = {scale:.9g}</text>']
    for one in plan.vectors:
        vector, start = own[plan.plan, one.name]
        begun = (place.low + place.high) / 2 + (start - low - size / 2) / scale
        at, by = begun.conjugate() + 1j * leaf.height, vector.conjugate() / scale
        parts.append(f'<path {LOOK} d="m {at.real:.4f},{at.imag:.4f} {by.real:.4f},{by.imag:.4f}"/>')
        beside = at + by / 2 + 1 - 1j
        parts.append(f'<text x="{beside.real}" y="{beside.imag}" style="font-size:3.5px">{lettered(one.letter)}</text>')
    return blank_file(leaf).replace(b"</svg>", f"{MARKER}{''.join(parts)}</svg>".encode())


def _plan(plan: PlanAsked, place: FormPlace, scale: float, high: float) -> str:
    assert place.pole is not None
    spots = {letter: place.pole + value / scale for letter, value in true_places(plan).items()}
    at = {letter: complex(spot.real, high - spot.imag) for letter, spot in spots.items()}
    lines = (
        f'<path {LOOK} d="M {at[one.start].real:.4f},{at[one.start].imag:.4f} '
        f'L {at[one.end].real:.4f},{at[one.end].imag:.4f}"/>'
        for one in plan.vectors
    )
    letters = (
        f'<text x="{spot.real + 1:.2f}" y="{spot.imag - 1:.2f}" style="font-size:3.5px">{letter}</text>'
        for letter, spot in at.items()
    )
    return "".join((*lines, *letters))


SHAPES = re.compile(r"<(?:path|line|circle)\b[^>]*?/>|<text\b.*?</text>", re.DOTALL)


def edited(source: bytes, how: str) -> bytes:
    """Give a sheet as an editor leaves it: all of it in groups, moved, or taken out of its groups into another one."""
    text = source.decode()
    begun, ended = text.index("<g"), text.rindex("</svg>")
    inner = text[begun:ended]
    if how == "regrouped":
        inner = inner.replace(MARKER, "")
        inner = (
            f'{MARKER}{SHAPES.sub("", inner)}<g transform="translate(5.3 -2.6)">{"".join(SHAPES.findall(inner))}</g>'
        )
        return f"{text[:begun]}{inner}</svg>".encode()
    return f'{text[:begun]}<g transform="{how}"><g>{inner}</g></g></svg>'.encode()


def position_on_form(leaf: Leaf, plan: PlanAsked, moved: complex = 0j) -> bytes:
    """Draw the points of a plan of positions on a form, each with a circle and its letter; the first is moved, m."""
    place = next(one for one in form_places(leaf) if one.plan == plan.place)
    assert place.pole is not None
    parts = []
    for k, one in enumerate(plan.vectors):
        at = (place.pole + (one.true + (moved if k == 0 else 0) - place.value) / place.scale).conjugate()
        at += 1j * leaf.height
        parts.append(f'<circle cx="{at.real:.3f}" cy="{at.imag:.3f}" r="1" style="fill:none;stroke:#000"/>')
        parts.append(f'<text x="{at.real + 1.5:.2f}" y="{at.imag - 1.5:.2f}">{lettered(one.title)}</text>')
    return blank_file(leaf).replace(b"</svg>", f"{''.join(parts)}</svg>".encode())
