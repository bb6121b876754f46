"""Settings of all tests: properties are drawn the same on every run, and no test is judged by the clock."""

import gc
import os
import sys
from collections.abc import Generator
from pathlib import Path

import pytest
from _pytest.doctest import DoctestModule
from hypothesis import settings

from tests import homes, parts

EXAMPLES, EVERYDAY = 100, 30  # of a property: with --whole, and every day where it does not say how many itself
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # as the program itself does: there are as many workers as cores

# Where Python is told to keep no bytecode, every worker and every command that a test starts would compile all packages
# anew; it goes to pytest's own folder instead.
if sys.dont_write_bytecode and "PYTEST_XDIST_WORKER" not in os.environ:
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
    os.environ.setdefault("PYTHONPYCACHEPREFIX", str(Path(__file__).parents[1] / ".pytest_cache" / "bytecode"))


gc.set_threshold(500_000, 20, 20)  # garbage is looked for less often: what is imported and collected is none


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--whole", action="store_true", help="run whole, and alone, what the everyday run makes a part of")
    how = "with --whole: every so many of its rows, and ten times as many of its single tests"
    parser.addoption("--every", type=int, default=1, help=how)


class Doctests:
    """Looks for doctests in no file without one, of the whole tree: finding none costs as much as finding some."""

    @pytest.hookimpl(wrapper=True)
    def pytest_collect_file(self, file_path: Path) -> Generator[None, list[pytest.Collector], list[pytest.Collector]]:
        found = yield
        text = file_path.read_bytes() if any(isinstance(one, DoctestModule) for one in found) else b">>>"
        return [one for one in found if b">>>" in text or not isinstance(one, DoctestModule)]


def pytest_configure(config: pytest.Config) -> None:
    parts.whole = config.getoption("whole")
    most = EXAMPLES if parts.whole else EVERYDAY
    settings.register_profile("same", derandomize=True, deadline=None, max_examples=most)
    settings.load_profile("same")
    config.pluginmanager.register(Doctests())  # a hook of this file would be asked for the files beside it alone


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    kept: dict[bool, list[pytest.Item]] = {True: [], False: []}
    for item in items:
        names = {mark.name for mark in item.iter_markers()}
        names |= {"part"} if getattr(getattr(item, "obj", None), "is_hypothesis_test", False) else set()
        kept[bool(names & {"part", "rest"}) if config.getoption("whole") else "rest" not in names].append(item)
    rows = [item for item in kept[True] if item.get_closest_marker("rest") and hasattr(item, "callspec")]
    every = config.getoption("every")
    alone = [item for item in kept[True] if item not in set(rows)]
    left = {*rows, *alone} - {*rows[::every], *alone[:: max(every // 10, 1)]}
    kept = {True: [item for item in kept[True] if item not in left], False: [*kept[False], *left]}
    config.hook.pytest_deselected(items=kept[False])
    items[:] = kept[True]


def pytest_collection_finish() -> None:
    """Let the collector of garbage pass by what stays to the end: all modules and items."""
    homes.keep()
    gc.collect()
    gc.freeze()
