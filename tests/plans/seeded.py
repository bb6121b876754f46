"""Faults seeded on purpose: a file of the packages is imported with one of its texts replaced, and tests run on it."""

from __future__ import annotations

import subprocess
import sys
import tomllib
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import cache
from importlib.machinery import ModuleSpec, PathFinder, SourceFileLoader
from pathlib import Path
from types import CodeType
from typing import Any, NamedTuple

import pytest
from hypothesis import Phase, settings

from tests.parts import SEEDED

ROOT = Path(__file__).parents[2]
FOLDER = "tests/plans"  # of the tests that the table names
OWN = ("geometry", "plans", "drawings", "tests")
# The first example that fails is enough: none is looked for that is smaller.
settings.register_profile(
    SEEDED, derandomize=True, deadline=None, phases=(Phase.explicit, Phase.generate), report_multiple_bugs=False
)
# A run within a run, as bare as it can be; what is imported already stays as it is.
BARE = (
    *("-q", "--tb=no", "--assert=plain", f"--hypothesis-profile={SEEDED}", "-o", "addopts=--import-mode=importlib"),
    *("-W", "ignore::pytest.PytestAssertRewriteWarning"),
    *(f"-pno:{plugin}" for plugin in ("cacheprovider", "faulthandler", "unraisableexception", "threadexception")),
)
SEEN = (AssertionError, pytest.fail.Exception)  # a test says no; any other exception is a fault in the table


class Fault(NamedTuple):
    """A wrong formula: the text of a file, what replaces it, and the tests that must see it."""

    name: str
    file: str
    right: str
    wrong: str
    seen_by: tuple[str, ...]

    @property
    def text(self) -> str:
        """The file with the fault; its text must be there exactly once, or the table has been left behind."""
        text = (ROOT / self.file).read_text(encoding="utf-8")
        count = text.count(self.right)
        assert count == 1, f"{self.file} has {count} times what the fault {self.name!r} replaces. Fix: renew its text"
        return text.replace(self.right, self.wrong)

    @property
    def nodes(self) -> list[str]:
        """The tests that must see it, as pytest names them."""
        return [test if "/" in test else f"{FOLDER}/{test}" for test in self.seen_by]


def faults(path: Path) -> list[Fault]:
    """Read a table of faults."""
    table = tomllib.loads(path.read_text(encoding="utf-8"))
    return [Fault(**{**one, "seen_by": tuple(one["seen_by"])}) for one in table["faults"]]


MORE = 1  # fault of each table in files that nobody has touched, and at most one of those in the others


def everyday(table: Sequence[Fault]) -> list[Any]:
    """Mark as the rest all faults but some of files changed lately and some others: these are left to `--whole`."""
    changed = _changed()
    kept = [*_spread(table), *_spread([fault for fault in table if fault.file in changed])]
    return [pytest.param(fault, id=fault.name, marks=() if fault in kept else pytest.mark.rest) for fault in table]


def _spread(table: Sequence[Fault]) -> Sequence[Fault]:
    """Take some faults from all parts of a table."""
    return table[:: -(-len(table) // MORE) or 1]


@cache
def _changed() -> frozenset[str]:
    """Name the files changed by the last commit that is no merge, and since; where nobody can tell, none."""
    last = ["git", "log", "-1", "--no-merges", "--first-parent", "--format=", "--name-only"]
    told = [_told(command) for command in (last, ["git", "diff", "--name-only", "HEAD"])]
    return frozenset("".join(told).splitlines())


def _told(command: Sequence[str]) -> str:
    try:
        return subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True, timeout=60).stdout
    except (OSError, subprocess.SubprocessError):
        return ""


@cache
def _compiled(path: str) -> CodeType:
    """Give the code of a file that has no fault, once for all runs, from its bytecode where that is kept."""
    code = SourceFileLoader(path, path).get_code(path)
    assert code is not None
    return code


class _Loader(SourceFileLoader):
    """Loads a module, the faulty one from its other text."""

    def __init__(self, fullname: str, path: str, text: str | None) -> None:
        super().__init__(fullname, path)
        self.text = text

    def get_code(self, fullname: str) -> CodeType:
        return _compiled(self.path) if self.text is None else self.source_to_code(self.text.encode(), self.path)


class _Finder:
    """Finds our own modules before anything else does."""

    def __init__(self, fault: Fault) -> None:
        self.path, self.text = str(ROOT / fault.file), fault.text

    def find_spec(self, fullname: str, path: Sequence[str] | None = None, target: Any = None) -> ModuleSpec | None:
        if fullname.partition(".")[0] not in OWN:
            return None
        spec = PathFinder.find_spec(fullname, path)
        if spec is not None and isinstance(spec.loader, SourceFileLoader):
            file = spec.loader.path
            spec.loader = _Loader(fullname, file, self.text if file == self.path else None)
        return spec


@contextmanager
def seeded(fault: Fault) -> Iterator[None]:
    """Import all own modules afresh, one of them with the fault; afterwards those of before are back."""

    def own() -> dict[str, Any]:
        return {name: module for name, module in sys.modules.items() if name.partition(".")[0] in OWN}

    finder, before = _Finder(fault), own()
    for name in before:
        del sys.modules[name]
    sys.meta_path.insert(0, finder)
    try:
        yield
    finally:
        sys.meta_path.remove(finder)
        for name in own():
            del sys.modules[name]
        sys.modules.update(before)
        settings.load_profile("same")


def _no(raised: BaseException) -> bool:
    """Tell whether a test says no: of one over many rows all that fail must."""
    return isinstance(raised, SEEN) or (isinstance(raised, BaseExceptionGroup) and raised.split(SEEN)[1] is None)


class _Verdicts:
    """What became of each test: passed, red, or what else was raised."""

    def __init__(self) -> None:
        self.of: dict[str, str] = {}

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        if report.when == "call":
            self.of.setdefault(report.nodeid, report.outcome)

    def pytest_exception_interact(self, node: Any, call: pytest.CallInfo[Any], report: Any) -> None:
        assert call.excinfo is not None
        raised = call.excinfo.value
        self.of[node.nodeid] = "red" if _no(raised) else f"{type(raised).__name__}: {raised}"


def verdicts(fault: Fault, nodes: Sequence[str]) -> dict[str, str]:
    """Run some tests on the packages with a fault: "passed" or "red", or what else was raised."""
    told = _Verdicts()
    with seeded(fault):
        pytest.main([*BARE, *(str(ROOT / node) for node in nodes)], plugins=[told])
    return told.of
