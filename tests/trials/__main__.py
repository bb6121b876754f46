"""The long trials: `python -m tests.trials`; one scene: `--kind chains --only 1234`, its TOML: `--show`.

`--share 50` tries every fiftieth, `--draw` draws the sheets as well, `--judge 100` holds 100 of each against 60 digits.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence

from tests.trials.judgement import BORNE, judgement_table
from tests.trials.series import judgements, trials
from tests.trials.table import failing, table
from tests.trials.trial import KINDS, text_of


def main(arguments: Sequence[str] | None = None) -> int:
    """Try the scenes that are asked for; give 1 if any of them fails."""
    wanted = _wanted(arguments)
    kinds = [wanted.kind] if wanted.kind else list(KINDS)
    if wanted.show:
        print(text_of(kinds[0], wanted.only))
        return 0
    if wanted.judge:
        judged = [*judgements(kinds, wanted.judge, wanted.only)]
        print(judgement_table(judged))
        return 1 if any(not one.roundings <= BORNE for one in judged) else 0
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
    parser.add_argument("--judge", type=int, metavar="N", help="hold N scenes of each kind against 60 digits instead")
    wanted = parser.parse_args(arguments)
    if (wanted.only is not None or wanted.show) and not (wanted.kind and wanted.only is not None):
        parser.error("--only and --show want a --kind and --only NUMBER")
    return wanted


if __name__ == "__main__":
    sys.exit(main())
