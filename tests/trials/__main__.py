"""The long trials: `python -m tests.trials [--kind chains] [--share 50] [--only 1234 [--show]] [--draw]`."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence

from tests.trials.series import trials
from tests.trials.table import failing, table
from tests.trials.trial import KINDS, text_of


def main(arguments: Sequence[str] | None = None) -> int:
    """Try the scenes that are asked for; give 1 if any of them fails."""
    wanted = _wanted(arguments)
    kinds = [wanted.kind] if wanted.kind else list(KINDS)
    if wanted.show:
        print(text_of(kinds[0], wanted.only))
        return 0
    verdicts = [*trials(kinds, wanted.share, wanted.draw, wanted.only)]
    print(table(verdicts))
    print(*failing(verdicts), sep="\n")
    return 1 if any(verdict.faults for verdict in verdicts) else 0


def _wanted(arguments: Sequence[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="python -m tests.trials", description=__doc__)
    parser.add_argument("--kind", choices=KINDS, help="one kind of scenes (default: all)")
    parser.add_argument("--share", type=int, default=1, metavar="N", help="every N-th scene")
    parser.add_argument("--only", type=int, metavar="NUMBER", help="one scene of a kind")
    parser.add_argument("--show", action="store_true", help="print that scene instead")
    parser.add_argument("--draw", action="store_true", help="lay out, write and verify the sheets as well")
    wanted = parser.parse_args(arguments)
    if (wanted.only is not None or wanted.show) and not (wanted.kind and wanted.only is not None):
        parser.error("--only and --show want a --kind and --only NUMBER")
    return wanted


if __name__ == "__main__":
    sys.exit(main())
