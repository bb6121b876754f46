"""Forgeries of written sheets, each of which `plandraft check` must tell: `python -m tests.forgeries`.

Every kind of edit is made on sheets of every technique, in both languages, with the seal made anew; the check must name
what was edited, and where. `--scene fan` takes one scene of the gallery, `--seed 1` other places of the sheets,
`--every 4` a quarter of it all.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections import Counter
from collections.abc import Sequence
from itertools import chain
from pathlib import Path
from tempfile import TemporaryDirectory

from drawings.redrawn import Originals
from tests.forgeries.sheets import GALLERY, SCENES, displaced, forgeries, judged, strangers


def main(arguments: Sequence[str] | None = None) -> int:
    """Forge and check; give 1 if any forgery was not told."""
    parser = argparse.ArgumentParser(prog="python -m tests.forgeries", description=__doc__)
    parser.add_argument(
        "--scene", choices=SCENES, action="append", help="of the gallery (default: one of each technique)"
    )
    parser.add_argument("--seed", type=int, default=0, help="chooses what is edited of each sheet")
    parser.add_argument("--every", type=int, default=1, metavar="N", help="every N-th kind of edit on each sheet")
    wanted = parser.parse_args(arguments)
    known = {name: Originals(GALLERY / f"{name}.toml") for name in wanted.scene or SCENES}
    made, missed = Counter[str](), Counter[str]()
    own = (
        (one, forgery)
        for one in known.values()
        for sheet in one.sheets
        for forgery in forgeries(one, sheet, wanted.seed, wanted.every)
    )
    began = time.monotonic()
    with TemporaryDirectory() as folder:
        others = [*strangers(known), *displaced(known, Path(folder))]
    for originals, forgery in chain(own, others):
        made[forgery.kind] += 1
        if fault := judged(originals, forgery, Path()):
            missed[forgery.kind] += 1
            print(f"{forgery.sheet}: {forgery.kind}: {fault}", flush=True)
    for kind, count in made.items():
        print(f"{kind:<36} {count - missed[kind]:>4} of {count:>4}")
    print(f"told: {made.total() - missed.total()} of {made.total()}, {time.monotonic() - began:.0f} s")
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
