"""A session at the bench: the trials of all techniques that a scene asks for, on one machine (испытания)."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Final

from plans.bench.trial import Bench, Found, Order, machine
from plans.scene.scene import Scene
from plans.study import Study
from plans.techniques import named

# Of a scene, what is ordered and who hears what is being timed, to what is found; imported when asked for.
SESSIONS: Final[Mapping[str, str]] = {
    "linkage": "drawings.bench.linkage:linkage",
    "diagrams": "plans.bench.chords:diagrams",
    "forces": "drawings.bench.linkage:linkage",
    "dynamics": "drawings.bench.linkage:dynamics",
    "balance": "drawings.bench.hands:balance",
    "bank": "plans.bench.unbalance:bank",
    "rotor": "drawings.bench.hands:rotor",
    "cyclogram": "plans.bench.machine:session",
    "cam": "plans.bench.cams:cams",
}


def session(scene: Scene, order: Order, tell: Callable[[str], None]) -> Bench:
    """Run a session; `tell` hears what is being timed, and nothing when all is."""
    there, sessions = machine(), dict.fromkeys(SESSIONS[technique] for technique in Study(scene).techniques)
    found: list[Found] = [named(one)(scene, order, tell) for one in sessions]
    tell("")
    return Bench(
        scene.heading(),
        there,
        rows=tuple(row for one in found for row in one.rows),
        ratios=tuple(ratio for one in found for ratio in one.ratios),
        words=tuple(dict.fromkeys(word for one in found for word in one.words)),
        accepted=order.accepted,
        gaps=any(one.gaps for one in found),
    )
