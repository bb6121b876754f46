"""Random scenes of every technique, each the same for ever by its seed and number (случайные задания)."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, NamedTuple

from geometry.errors import DraftError
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.alarms.cam_scenes import cam
from tests.alarms.lot import CYCLE, Lot
from tests.alarms.machine_scenes import balancing, cyclogram, dynamics, forces, kinematics
from tests.alarms.machines import PAPER, machine, papered
from tests.alarms.neighbours import neighbour
from tests.alarms.rotor_scenes import bank, rotor

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf

TECHNIQUES: Mapping[str, Callable[[Lot], str]] = {
    "kinematics": kinematics, "forces": forces, "dynamics": dynamics, "balancing": balancing, "bank": bank,
    "rotor": rotor, "cyclogram": cyclogram, "cam": cam,
}  # fmt: skip
OTHERS: Mapping[str, Callable[[int, int], str]] = {"chain": machine, "neighbour": neighbour}
SOURCES = (*TECHNIQUES, *OTHERS)
FORMATS = ("A1", "A1", "A1", "A2", "A2", "A2", "A3", "A3", "A4")  # as often as a course asks for them
TITLES = {
    "en": {"designation": "TMM.01.01.00", "drawn": "Archer", "checked": "Fletcher", "group": "M-301"},
    "ru": {"designation": "ТММ.01.01.00", "drawn": "Стрельцов", "checked": "Лучников", "group": "М-302"},
}


class Scene(NamedTuple):
    """A scene that was drawn by lot: its number and technique, and its text."""

    seed: int
    number: int
    technique: str
    text: str

    @property
    def name(self) -> str:
        """What tells it from all others."""
        return f"{self.technique}-{self.seed}-{self.number}"


def scene(seed: int, number: int) -> Scene:
    """Draw the scene of a number: techniques take turns, and of each one the kinds of scenes."""
    turn, which = divmod(number, len(SOURCES))
    technique = SOURCES[which]
    if technique in OTHERS:
        return Scene(seed, number, technique, OTHERS[technique](seed, turn))
    lot = Lot(f"{technique} {seed} {turn}", CYCLE[turn % len(CYCLE)])
    return Scene(seed, number, technique, papered(TECHNIQUES[technique](lot), _paper(lot)))


def scenes(seed: int, count: int, techniques: Sequence[str] = SOURCES, first: int = 0) -> Iterator[Scene]:
    """Draw so many scenes of these techniques, from a number on."""
    wanted = {SOURCES.index(name) for name in techniques}
    numbers = (number for number in range(first, first + count * len(SOURCES)) if number % len(SOURCES) in wanted)
    for number, _ in zip(numbers, range(count), strict=False):
        yield scene(seed, number)


def drawn(seed: int, number: int) -> tuple[Scene, Mapping[str, Sequence[Leaf]]]:
    """Lay out the sheets of a scene in memory, by kind, unchecked; of one that is refused there are none."""
    from drawings.commands.draw import admit
    from drawings.sheets.documents import leaves_of

    made = scene(seed, number)
    try:
        study = Study(parse_scene(made.text))
        admit(study.scene)
        study.construct()
        return made, leaves_of(study)
    except DraftError:
        return made, {}


def _paper(lot: Lot) -> dict[str, str]:
    paper = {key: lot.any(*values) for key, values in PAPER.items()} | {"format": lot.any(*FORMATS)}
    return paper | (TITLES[paper["language"]] if lot.on(0.5) else {})
