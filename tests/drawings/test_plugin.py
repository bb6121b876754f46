"""The pytest plugin: a class is graded by a teacher's test, each sheet is answered for, and nobody else pays for it."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from importlib.metadata import entry_points
from pathlib import Path
from types import ModuleType

import pytest

from drawings.pytest_plugin import assignment
from tests.drawings.students import task
from tests.drawings.test_grading import MISTAKES, made
from tests.gallery import GALLERY

pytest_plugins = ["pytester"]
MODULE = "drawings.pytest_plugin.plugin"
# Where plandraft is installed its plugin is there by itself.
LOADED = [] if entry_points(group="pytest11", name="plandraft") else ["-p", MODULE]
ALONE = ["-p", "no:cacheprovider", "-p", "no:xdist"]
SET = f"--plandraft-scene={GALLERY / 'shaper.toml'}"
TEST = """
from drawings.pytest_plugin.assertions import assert_close_to_analysis

def test_values(sheet, scene):
    assert_close_to_analysis(sheet, scene, tolerance="2 %")
"""
PACKAGES = ("geometry", "plans", "drawings")
Run = Callable[..., pytest.RunResult]


class Kept(dict[str, ModuleType]):
    """The modules that runs have imported."""

    def pytest_unconfigure(self) -> None:
        self.update(sys.modules)


@pytest.fixture
def kept() -> Iterator[Kept]:
    """Keep what runs import, or other tests would import it anew: other classes of the same names."""
    own = Kept()
    yield own
    sys.modules.update({name: module for name, module in own.items() if name.partition(".")[0] in PACKAGES})


@pytest.fixture
def run(kept: Kept, pytester: pytest.Pytester, monkeypatch: pytest.MonkeyPatch) -> Run:
    """Run a teacher's tests, with a scene that is set once for all."""
    own = assignment.Assignment(task("shaper").originals)
    monkeypatch.setattr(assignment, "_assignment", lambda path, changed: own)

    def once(*arguments: str, test: str = TEST) -> pytest.RunResult:
        pytester.makepyfile(test)
        result = pytester.runpytest_inprocess(*ALONE, *LOADED, SET, *arguments, plugins=[kept])
        sys.modules.update(kept)
        return result

    return once


@pytest.fixture
def class_(kept: Kept, pytester: pytest.Pytester) -> Path:
    """A class of three: one is right, one has a mistake, one hands in a page of the web."""
    folder = pytester.mkdir("class")
    own = task("shaper")
    (folder / "ann.svg").write_bytes(own.originals.drawn(own.originals.sheets[0]))
    (folder / "bob.svg").write_bytes(made(own, MISTAKES[0]))
    (folder / "cid.svg").write_bytes(b"<html><body>log in</body></html>")
    return folder


def test_a_class_is_graded_to_the_last_sheet(run: Run, class_: Path, pytester: pytest.Pytester) -> None:
    result = run(f"--plandraft-sheets={class_}", "--plandraft-report=report")
    result.assert_outcomes(passed=1, failed=2)
    result.stdout.fnmatch_lines(
        [
            "*bob.svg: not as the analysis gives it (tolerance 2 %):*",
            "*drawn * m/s² at *, by the analysis * m/s² at *",
            "*cid.svg: cannot be read: *Fix: *",
            "plandraft: 3 handed in, 3 answered for",
        ]
    )
    assert [path.name for path in (pytester.path / "report").iterdir()] == [
        "test_a_class_is_graded_to_the_last_sheet-test_values-bob.svg"
    ]


def test_a_sheet_that_no_test_answers_for_is_told(run: Run, class_: Path) -> None:
    skips = "import pytest\ndef test_it(sheet):\n    if sheet.path.stem == 'bob':\n        pytest.skip('ill')\n"
    result = run(f"--plandraft-sheets={class_}", test=skips)
    assert result.ret == pytest.ExitCode.TESTS_FAILED
    result.stdout.fnmatch_lines(["plandraft: 3 handed in, 2 answered for; not answered for: *bob.svg"])


@pytest.mark.rest
def test_who_chooses_among_the_tests_need_not_answer_for_all(run: Run, class_: Path) -> None:
    result = run(f"--plandraft-sheets={class_}", "-k", "ann")
    assert result.ret == pytest.ExitCode.OK
    result.stdout.fnmatch_lines(["plandraft: 3 handed in, 1 answered for; not answered for: *bob.svg, *cid.svg"])


@pytest.mark.parametrize("listing", ["--collect-only", "--setup-plan"])
def test_where_no_test_runs_no_sheet_is_due(run: Run, class_: Path, listing: str) -> None:
    result = run(f"--plandraft-sheets={class_}", listing)
    assert result.ret == 0 and "handed in" not in result.stdout.str()


def test_an_empty_folder_is_no_class_that_passes(run: Run, pytester: pytest.Pytester) -> None:
    result = run(f"--plandraft-sheets={pytester.mkdir('nobody')}")
    assert result.ret != pytest.ExitCode.OK
    result.stdout.fnmatch_lines(["*nobody: no sheet is handed in there*"])


def test_a_scene_among_the_sheets_is_refused(run: Run, class_: Path) -> None:
    (class_ / "shaper.toml").write_bytes((GALLERY / "shaper.toml").read_bytes())
    result = run(f"--plandraft-sheets={class_}")
    assert result.ret != pytest.ExitCode.OK
    result.stdout.fnmatch_lines(["*shaper.toml lies among the sheets*"])


def test_without_sheets_it_is_said_how_they_are_given(run: Run) -> None:
    result = run()
    result.assert_outcomes(errors=1)
    result.stdout.fnmatch_lines(["*no sheets are handed in: run with --plandraft-sheets PATH*"])


@pytest.mark.rest
def test_sheets_and_scene_can_stand_in_the_settings(run: Run, class_: Path, pytester: pytest.Pytester) -> None:
    pytester.makeini("[pytest]\nplandraft_sheets = class/ann.svg\n")
    run("--plandraft-silent").assert_outcomes(passed=1)
    run(test="def test_another(): pass").assert_outcomes(passed=1)  # where no test takes a sheet, none is due


def test_a_sheet_is_read_by_its_path_from_the_test(run: Run, class_: Path) -> None:
    test = """
        def test_velocity(read_sheet):
            b = read_sheet("class/ann.svg").plan("velocity", position=2).vector("p b")
            assert (round(b.size, 2), b.unit) == (1.52, "m/s")
    """
    run(test=test).assert_outcomes(passed=1)


def test_a_test_may_have_sheets_of_its_own(run: Run, class_: Path) -> None:
    test = "import pytest\n@pytest.mark.parametrize('sheet', [1, 2])\ndef test_it(sheet):\n    assert sheet < 3\n"
    run(f"--plandraft-sheets={class_}", test=test).assert_outcomes(passed=2)


def test_who_does_not_use_it_pays_nothing(pytester: pytest.Pytester) -> None:
    pytester.makepyfile(
        """
        import sys

        def test_nothing_is_imported():
            own = {name for name in sys.modules if name.split(".")[0] in ("drawings", "plans", "geometry", "numpy")}
            assert own == {"drawings", "drawings.pytest_plugin", "drawings.pytest_plugin.plugin"}
        """
    )
    result = pytester.runpytest_subprocess(*ALONE, "-p", "no:hypothesispytest", *LOADED)
    result.assert_outcomes(passed=1)
