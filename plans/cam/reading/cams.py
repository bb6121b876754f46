"""The cams made from the scene, and all that is wrong with them (кулачки по исходным данным)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from decimal import Decimal
from fractions import Fraction
from itertools import accumulate
from typing import NamedTuple

from plans.cam.reading.entry import CamEntry, Exact, misplaced, pace_of, proportions, shown
from plans.cam.reading.fields import CYCLOGRAM, REST
from plans.cam.reading.form import AGAINST, CamForm
from plans.cam.reading.keyways import keyway, standard
from plans.cam.reading.laws import PhaseWay, law_of, ways_of
from plans.model.cam import DWELL, NO_LIMITS, Cam, Follower, FollowerLoad, GivenSizes, Hub, Limits, Phase
from plans.model.cyclogram import Window
from plans.scene import units
from plans.scene.faults import Fault, Path, SceneError
from plans.scene.scene import Meaning, Scene
from plans.scene.units import within

WHOLE = Fraction(360)
MM = Decimal(1000)  # of a metre
SNAPPED = Fraction(1, 10**6)  # degrees: so near a whole turn a sum is taken for one, and that is said
RADIANS = Fraction("6.283185307179586"), Fraction(1, 100)  # a whole turn, and how near it angles in radians are


def turns_of(entry: CamEntry, window: Fraction | None) -> Exact | None:
    """Give the phases' angles in degrees (travels m), or nothing where they are at fault or wait for the cyclogram."""
    if entry.translates:
        return _travels(entry)
    angles, before = [phase.angle for phase in entry.form.phases], len(entry.faults)
    known = [Fraction(a) if isinstance(a, Decimal) else window if a == CYCLOGRAM else None for a in angles]
    stated = sum(filter(None, known), Fraction(0))
    _words(entry, window, stated)
    if (window is None and CYCLOGRAM in angles) or len(entry.faults) > before:
        return None
    found = [WHOLE - stated if angle is None else angle for angle in known]
    return snapped(found) if _fits(entry, found) else None


def _travels(entry: CamEntry) -> Exact | None:
    for number, phase in enumerate(entry.form.phases):
        if phase.travel is None:
            entry.fault(("phases", number, "angle"), "mixed_phases")
            return None
    return tuple(Fraction(phase.travel or 0) for phase in entry.form.phases)


def _words(entry: CamEntry, window: Fraction | None, stated: Fraction) -> None:
    """See that words stand for one angle each, and that the others leave something to them."""
    angles = [phase.angle for phase in entry.form.phases]
    places = {word: [k for k, angle in enumerate(angles) if angle == word] for word in (REST, CYCLOGRAM)}
    for word, found in places.items():
        for number in found[1:]:
            entry.fault(("phases", number, "angle"), "word_twice", word=word)
    if places[CYCLOGRAM] and not places[REST]:
        entry.fault(("phases", places[CYCLOGRAM][0], "angle"), "no_rest")
    waiting = [*places[REST], *(places[CYCLOGRAM] if window is None else ())]
    if waiting and stated > WHOLE:
        entry.fault(("phases", waiting[0], "angle"), "nothing_left", found=shown(stated))


def _fits(entry: CamEntry, found: Sequence[Fraction]) -> bool:
    """See that the angles make a whole turn, and that none but a dwell's is 0."""
    before = len(entry.faults)
    phases = entry.form.phases
    for number, (phase, angle) in enumerate(zip(phases, found, strict=True)):
        if angle == 0 and phase.kind != DWELL:
            entry.fault(("phases", number, "angle"), "zero_phase")
    total = sum(found, Fraction(0))
    if abs(total - WHOLE) > SNAPPED:
        last = ("phases", len(phases) - 1, "angle")
        kind = "phases_long" if total > WHOLE else "phases_short"
        kind = "phases_radians" if abs(total - RADIANS[0]) < RADIANS[1] else kind
        entry.fault(last, kind, found=shown(total), off=shown(abs(total - WHOLE)))
    return len(entry.faults) == before


def snapped(angles: Sequence[Fraction]) -> Exact:
    """Give angles whose sum is a whole turn exactly: the largest takes what is over.

    >>> [str(one) for one in snapped([Fraction(120), Fraction("240.0000001")])]
    ['120', '240']
    """
    largest = max(range(len(angles)), key=angles.__getitem__)
    over = sum(angles, Fraction(0)) - WHOLE
    return tuple(angle - over if number == largest else angle for number, angle in enumerate(angles))


class CamSurvey(NamedTuple):
    """What the examination of a scene's cams found: those that do not wait for a cyclogram, and the faults of all."""

    cams: tuple[Cam, ...]
    faults: list[Fault]
    waiting: bool  # for the window of a cyclogram


def survey_of(meaning: Meaning) -> CamSurvey:
    """Examine a scene's cams."""
    entries = [*entries_of(meaning.scene, meaning.doubts)]
    cams = [cam for entry in entries if (cam := _cam(entry, None))]
    faults = [fault for entry in entries for fault in entry.faults]
    return CamSurvey(tuple(cams), [*faults, *_one_name(meaning.scene, entries)], any(e.asks_cyclogram for e in entries))


def cams_of(scene: Scene, window: Window | None) -> tuple[Cam, ...]:
    """Give the cams of a scene; those that ask for the cyclogram need its window."""
    entries = [*entries_of(scene)]
    cams = tuple(cam for entry in entries if (cam := _cam(entry, window)))
    faults = [fault for entry in entries for fault in entry.faults]
    if faults:
        raise SceneError(faults)
    return cams


def asked_of(scene: Scene) -> tuple[str, ...]:
    """Name the techniques that a scene's cams ask (row of the table): the cyclogram, or the drive for its speed."""
    entries = [*entries_of(scene)]
    by_drive = any(entry.form.speed is None and not entry.translates for entry in entries) and scene.has(("drive",))
    by_cyclogram = any(entry.asks_cyclogram for entry in entries)
    return tuple(name for name, asked in (("linkage", by_drive), ("cyclogram", by_cyclogram)) if asked)


def entries_of(scene: Scene, doubts: frozenset[Path] = frozenset()) -> Iterator[CamEntry]:
    """Give a scene's cams as they are examined."""
    return (CamEntry(scene, number, form, doubts) for number, form in enumerate(scene.of(CamForm).cam))


def _one_name(scene: Scene, entries: Sequence[CamEntry]) -> Iterator[Fault]:
    for number, entry in enumerate(entries):
        before = [other.number for other in entries[:number] if other.name == entry.name]
        if before:
            yield scene.fault(entry.path("name") if entry.form.name else entry.path(), "cam_twice", name=entry.name)


def _cam(entry: CamEntry, window: Window | None) -> Cam | None:
    """Make one cam, or nothing where it is at fault or waits for the window."""
    if window is None:
        _has_cyclogram(entry)
    misplaced(entry)
    proportions(entry)
    sense, speed = pace_of(entry)
    phases = None if entry.doubted("phases", "follower") else _phases(entry, window)
    load = _load(entry)
    if phases is None or entry.faults or (window is None and entry.form.setting == CYCLOGRAM):
        return None
    form, (turns, made) = entry.form, phases
    return Cam(
        name=entry.name,
        sense=sense,
        speed=speed,
        phases=made,
        follower=_follower(entry),
        closure=form.closure,
        limits=_limits(entry) if entry.form.follower.lift or entry.form.follower.swing else NO_LIMITS,
        given=GivenSizes(_float(form.sizes.base), _float(form.sizes.offset), _float(form.sizes.centre)),
        roller=_float(form.sizes.roller),
        setting=_setting(entry, window, made),
        translates=entry.translates,
        divisions=form.divisions,
        coordinates=form.coordinates,
        load=load,
        hub=_hub(entry),
        angles=() if entry.translates else turns,
    )


def _has_cyclogram(entry: CamEntry) -> None:
    """See that a file whose cam asks for a cyclogram has one."""
    if not entry.asks_cyclogram or entry.scene.has(("cyclogram",)):
        return
    numbers = [number for number, phase in enumerate(entry.form.phases) if phase.angle == CYCLOGRAM]
    path: Path = ("phases", numbers[0], "angle") if numbers else ("setting",)
    entry.fault(path, "needs", tables="[cyclogram]", example=("[cyclogram]",))


def _phases(entry: CamEntry, window: Window | None) -> tuple[Exact, tuple[Phase, ...]] | None:
    """Give the angles and the phases; a dwell of no angle is none."""
    turns = turns_of(entry, None if window is None else Fraction(math.degrees(window.angle)))
    ways = ways_of(entry)
    if turns is None or ways is None:
        return None
    starts = accumulate(turns[:-1], initial=Fraction(0))
    made = [_phase(entry, k, *row) for k, row in enumerate(zip(turns, starts, ways, strict=True)) if row[0]]
    return tuple(turn for turn in turns if turn), tuple(made)


def _phase(entry: CamEntry, number: int, turn: Fraction, start: Fraction, way: PhaseWay) -> Phase:
    def across(size: Fraction) -> float:
        return float(size) if entry.translates else math.radians(float(size))

    def up(size: Fraction) -> float:
        return math.radians(float(size)) if entry.rocks else float(size)

    kind = entry.form.phases[number].kind if way.change else DWELL  # a rise by nothing is a dwell
    law = law_of(entry, number, turn, way)
    moving = None if kind == DWELL else law
    return Phase(kind, across(turn), across(start), up(way.level), up(way.change), moving, across(start + turn))


def _limits(entry: CamEntry) -> Limits:
    limits = entry.form.limits
    return Limits(_radians(limits.rise), _radians(limits.return_), float(limits.curvature))


def _follower(entry: CamEntry) -> Follower:
    follower = entry.form.follower
    return Follower(
        follower.motion,
        follower.end,
        _float(follower.length),
        -1 if follower.turns == AGAINST else 1,
        float(follower.face),
        _float(follower.reach),
    )


def _setting(entry: CamEntry, window: Window | None, phases: Sequence[Phase]) -> float:
    """Give the turn of the main shaft at which the first phase begins, from 0 to a whole turn.

    By the cyclogram the phase that takes its angle from it begins with the window, or else the first that moves.
    """
    if entry.form.setting != CYCLOGRAM:
        return math.radians(float(within(Fraction(entry.form.setting)) % 360))
    assert window is not None  # a cam that waits is not made
    asking = [phase.angle == CYCLOGRAM for phase in entry.form.phases if phase.angle != 0]
    starts = [phase.start for phase, asked in zip(phases, asking, strict=True) if asked]
    moving = [phase.start for phase in phases if phase.kind != DWELL]
    return (window.start - (starts or moving or [0.0])[0]) % math.tau


def _hub(entry: CamEntry) -> Hub | None:
    """Give the hub; what of its keyway is not given by the standard for the bore."""
    hub = entry.form.hub
    if hub is None:
        return None
    usual = keyway(MM * hub.bore)
    width = usual.width / MM if hub.width is None else hub.width
    depth = Decimal(0) if not width else usual.depth / MM if hub.depth is None else hub.depth
    by_rule = standard(MM * hub.bore) and (MM * width, MM * depth) == (usual.width, usual.depth)
    return Hub(
        float(hub.bore),
        float(width),
        float(depth),
        math.radians(float(hub.angle)),
        _float(hub.length),
        by_rule,
        float(depth or usual.depth / MM),  # over a keyway is left what it takes
    )


def _load(entry: CamEntry) -> FollowerLoad | None:
    load = entry.form.load
    if load is None:
        return None
    force, stiff = (units.MOMENT, units.TURNING_STIFFNESS) if entry.rocks else (units.FORCE, units.STIFFNESS)
    mass, acting = (load.inertia, load.moment) if entry.rocks else (load.mass, load.force)
    preload = entry.quantity(load.preload, force, "load", "preload")
    stiffness = entry.quantity(load.stiffness, stiff, "load", "stiffness")
    return FollowerLoad(*(float(size or 0) for size in (mass, acting, preload, stiffness)))


def _radians(degrees: Decimal | None) -> float | None:
    return None if degrees is None else math.radians(float(degrees))


def _float(value: Decimal | None) -> float | None:
    return None if value is None else float(value)
