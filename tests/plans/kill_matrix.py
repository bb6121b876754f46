"""Print which relation and which balance sees which fault: `python -m tests.plans.kill_matrix [part of a name]`."""

from __future__ import annotations

import io
import sys
from contextlib import redirect_stdout
from pathlib import Path

from tests.plans.seeded import FOLDER, faults, verdicts

FILES = [f"{FOLDER}/test_force_relations.py", f"{FOLDER}/test_force_balances.py"]


def main(part: str = "") -> None:
    """Print a row for every fault: the tests of these files that see it, and those of other files named beside it."""
    kills: dict[str, int] = {}
    for fault in faults(Path(__file__).parents[1] / "cases" / "force_faults.toml"):
        if part not in fault.name:
            continue
        others = [node for node in fault.nodes if node.partition("::")[0] not in FILES]
        with redirect_stdout(io.StringIO()):
            told = verdicts(fault, [*FILES, *others])
        short = {node: node.partition("::test_")[2] for node in told}
        for node, verdict in told.items():
            kills[short[node]] = kills.get(short[node], 0) + (verdict == "red")
        seen = [short[node] for node, verdict in told.items() if verdict == "red"]
        print(f"| {fault.name} | {'; '.join(seen) or 'NOT SEEN'} |", flush=True)
    print("\n" + "\n".join(f"| {name} | {count} |" for name, count in kills.items()))


if __name__ == "__main__":
    main(*sys.argv[1:2])
