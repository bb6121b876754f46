"""False alarms of the self-check: `python -m tests.alarms --mechanisms 500 --seed 1 --workers 2`.

Random loaded mechanisms are drawn with the self-check in both languages, by both standards, on paper from A1 to A4, and
with `--neighbours` scenes near those of the gallery, of all techniques, and with `--gallery` these themselves and those
of tests/cases/alarms in both languages on all four. None of them may be withheld, and none crash; a scene that is
refused has no sheet that could be. Each that is withheld or crashes is written into `--folder`. `--only 17` draws the
one of that number alone.
"""

from __future__ import annotations

import argparse
import sys
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path

from tests.alarms.drawing import ALARMS, CRASHED, DRAWN, REFUSED, SLOW, WITHHELD, Outcome, drawings
from tests.alarms.machines import PAPER, machine, papered
from tests.alarms.neighbours import neighbour
from tests.gallery import SCENES

CASES = Path(__file__).parents[1] / "cases" / "alarms"
TOLD = 110  # letters of a reason in the table


def main(arguments: Sequence[str] | None = None) -> int:
    """Draw the scenes that are asked for; give 1 if any is withheld or crashes."""
    wanted = _wanted(arguments)
    numbers = range(wanted.first, wanted.first + wanted.mechanisms) if wanted.only is None else [wanted.only]
    kind, made = ("neighbour", neighbour) if wanted.neighbours else ("machine", machine)
    random = ((f"{kind}-{wanted.seed}-{k}", made(wanted.seed, k)) for k in numbers)
    outcomes = []
    for one in drawings([*(gallery() if wanted.gallery else random)], wanted.workers):
        outcomes.append(one)
        if one.alarm:
            wanted.folder.mkdir(parents=True, exist_ok=True)
            (wanted.folder / f"{one.name}.toml").write_text(one.text, encoding="utf-8")
            print(f"{one.name}: {one.outcome}: {one.told}", flush=True)
    print(*table(outcomes), sep="\n")
    return 1 if any(one.alarm for one in outcomes) else 0


def gallery() -> Iterator[tuple[str, str]]:
    """Give the scenes of the gallery and of earlier alarms, on all kinds of paper, in both languages."""
    for path in (*SCENES, *sorted(CASES.glob("*.toml"))):
        for size in PAPER["format"]:
            for language in PAPER["language"]:
                text = papered(path.read_text(encoding="utf-8"), {"format": size, "language": language})
                yield f"{path.stem}-{size}-{language}", text


def table(outcomes: Sequence[Outcome]) -> Iterator[str]:
    """Count what came of the scenes, and refusals by their reason."""
    counts = Counter(one.outcome for one in outcomes)
    yield from (f"{name:<10} {counts[name]:>5}" for name in (DRAWN, REFUSED, WITHHELD, CRASHED, SLOW))
    reasons = Counter(one.told.splitlines()[-1][:TOLD] for one in outcomes if one.outcome == REFUSED and one.told)
    yield from (f"  {count:>4} refused: {told}" for told, count in reasons.most_common())
    yield f"false alarms: {sum(counts[name] for name in ALARMS)} of {len(outcomes)}"


def _wanted(arguments: Sequence[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="python -m tests.alarms", description=__doc__)
    parser.add_argument("--mechanisms", type=int, default=500, metavar="N", help="how many random ones")
    parser.add_argument("--first", type=int, default=0, metavar="N", help="the number of the first of them")
    parser.add_argument("--seed", type=int, default=1, metavar="N", help="draws other ones")
    parser.add_argument("--workers", type=int, default=2, metavar="N", help="processes")
    parser.add_argument("--only", type=int, metavar="NUMBER", help="one of them")
    parser.add_argument("--neighbours", action="store_true", help="neighbours of the gallery's scenes instead")
    parser.add_argument("--gallery", action="store_true", help="the gallery and earlier alarms instead")
    parser.add_argument("--folder", type=Path, default=Path("out/alarms"), metavar="DIR", help="for what is withheld")
    return parser.parse_args(arguments)


if __name__ == "__main__":
    sys.exit(main())
