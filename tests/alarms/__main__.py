"""Random scenes of every technique, drawn with the self-check: `python -m tests.alarms --scenes 2000 --seed 1`.

Scenes of course projects, chains of dyads and scenes near those of the gallery are drawn in both languages, by both
standards, on paper from A1 to A4; `--technique cam` draws those of one source alone. None may be withheld, and none
crash; what is refused has no sheet that could be. Each that is withheld, crashes or is refused is told in a line, and
written into `--folder` beside the summary. `--only 17` draws the scene of that number alone.
"""

from __future__ import annotations

import argparse
import sys
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path

from tests.alarms.drawing import DRAWN, OUTCOMES, REFUSED, Outcome, drawings
from tests.alarms.scenes import SOURCES, scene, scenes


def main(arguments: Sequence[str] | None = None) -> int:
    """Draw the scenes that are asked for; give 1 if any is withheld or crashes."""
    wanted = _wanted(arguments)
    wanted.folder.mkdir(parents=True, exist_ok=True)
    outcomes = []
    for one in drawings(list(_scenes(wanted)), wanted.workers):
        outcomes.append(one)
        if one.alarm or one.outcome == REFUSED:
            (wanted.folder / f"{one.name}.toml").write_text(one.text, encoding="utf-8")
            print(f"{one.name}: {one.outcome}: {''.join(one.told.splitlines()[-1:])}", flush=True)
    told = "\n".join(table(outcomes))
    (wanted.folder / "summary.txt").write_text(told + "\n", encoding="utf-8")
    print(told)
    return 1 if any(one.alarm for one in outcomes) else 0


def table(outcomes: Sequence[Outcome]) -> Iterator[str]:
    """Count what came of the scenes of each source."""
    counts = Counter((one.name.partition("-")[0], one.outcome) for one in outcomes)
    sources = [name for name in SOURCES if any(name == source for source, _ in counts)]
    yield f"{'':<12}" + "".join(f"{outcome:>14}" for outcome in OUTCOMES)
    for source in sources:
        yield f"{source:<12}" + "".join(f"{counts[source, outcome]:>14}" for outcome in OUTCOMES)
    alarms = sum(one.alarm for one in outcomes)
    longest = max(outcomes, key=lambda one: one.seconds)
    drawn = sum(one.outcome in DRAWN for one in outcomes)
    yield f"{len(outcomes)} scenes: {drawn} drawn, {alarms} false alarms; {longest.name} took {longest.seconds:.1f} s"


def _scenes(wanted: argparse.Namespace) -> Iterator[tuple[str, str]]:
    techniques = [wanted.technique] if wanted.technique else SOURCES
    made = scenes(wanted.seed, wanted.scenes, techniques, wanted.first)
    return ((one.name, one.text) for one in ([scene(wanted.seed, wanted.only)] if wanted.only is not None else made))


def _wanted(arguments: Sequence[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="python -m tests.alarms", description=__doc__)
    parser.add_argument("--scenes", type=int, default=500, metavar="N", help="how many random ones")
    parser.add_argument("--first", type=int, default=0, metavar="N", help="the number of the first of them")
    parser.add_argument("--seed", type=int, default=1, metavar="N", help="draws other ones")
    parser.add_argument("--technique", choices=SOURCES, help="those of one source alone")
    parser.add_argument("--only", type=int, metavar="NUMBER", help="one of them")
    parser.add_argument("-j", "--workers", type=int, default=2, metavar="N", help="processes")
    parser.add_argument("--folder", type=Path, default=Path("out/alarms"), metavar="DIR", help="for what is not drawn")
    return parser.parse_args(arguments)


if __name__ == "__main__":
    sys.exit(main())
