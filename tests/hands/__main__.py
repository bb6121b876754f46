"""Chance drawings of scenes, graded: `python -m tests.hands`, or of some by `python -m tests.hands shaper planer`.

A fair hand slips by 0.2 mm in each act: twenty of its drawings must all be accepted, and of a hand that slips by 2 mm
none. Between them each vector is held against what is allowed to it in 400 drawings: so many must be out as its own
slips say that add up in the record, within what is chance (a binomial bound), and of the values of a curve no more.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence

from tests.gallery import SCENES
from tests.hands.trial import Held, Slipped, of_scene


def main(arguments: Sequence[str] | None = None) -> int:
    """Try scenes of the gallery, and tell of each slip what came of it; give 1 if any scene is odd."""
    parser = argparse.ArgumentParser(prog="python -m tests.hands", description=__doc__)
    parser.add_argument("scenes", nargs="*", default=[path.stem for path in SCENES], metavar="SCENE")
    parser.add_argument("--seed", type=int, default=7)
    wanted = parser.parse_args(arguments)
    odd = 0
    print(f"{'scene':<20} {'slip':>4} accepted  vectors out, as foretold   curves out, at most")
    for scene in wanted.scenes:
        for one in of_scene(scene, wanted.seed):
            print(row(scene, one), flush=True)
            wrong = one.faults
            odd += len(wrong)
            for fault in wrong:
                print(f"    {fault}")
    return 1 if odd else 0


def row(scene: str, one: Slipped) -> str:
    """Tell of one slip: how many drawings are accepted, and the shares that are out, as drawn and as foretold."""
    vectors, curves = ([held for held in one.held if held.most is most] for most in (False, True))
    return f"{scene:<20} {one.slip:>4} {one.accepted:>5}/{one.graded}  {shares(vectors):<25} {shares(curves)}".rstrip()


def shares(held: Sequence[Held]) -> str:
    """Tell what shares of several values are out on the mean.

    >>> from tests.hands.shares import Share
    >>> shares([Held("v_B", Share(40, 400), Share(180, 2000))])
    '10.0 %   9.0 % (1)'
    """
    if not held:
        return ""
    drawn, told = (
        100 * sum(own) / len(own) for own in zip(*((one.drawn.part, one.told.part) for one in held), strict=True)
    )
    return f"{drawn:.1f} % {told:>5.1f} % ({len(held)})"


if __name__ == "__main__":
    sys.exit(main())
