"""The table of sessions (испытания): what times the roads of each technique; "module:name", imported when asked for."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

# Of a scene, what is ordered and who hears what is being timed, to the bench.
SESSIONS: Final[Mapping[str, str]] = {
    "linkage": "drawings.bench.session:session",
    "diagrams": "drawings.bench.diagrams_session:session",
    "forces": "drawings.bench.session:session",
    "dynamics": "drawings.bench.dynamics_session:session",
    "balance": "drawings.bench.balance_session:session",
    "bank": "drawings.bench.bank_session:session",
    "rotor": "drawings.bench.rotor_session:session",
    "cyclogram": "drawings.bench.cyclogram_session:session",
    "cam": "drawings.bench.cam_session:session",
}
