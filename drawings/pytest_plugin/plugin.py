"""The pytest plugin of plandraft: sheets that are handed in as fixtures of a test (подключение к pytest).

Nothing of plandraft is imported before a test asks for a sheet.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from drawings.pytest_plugin.assignment import Assignment
    from drawings.pytest_plugin.handed_sheet import HandedSheet

ASKED = "sheet"  # the fixture that is one after another each sheet that is handed in
ANSWERED = "plandraft_sheet"  # the property of a test's report that says which sheet it answers for
SHEETS = pytest.StashKey[tuple[Path, ...]]()
ANSWERS = (".toml",)  # what lies in no folder of students
LISTED = ("collectonly", "setuponly", "setupplan")  # options of pytest under which no test runs
ENDS = ("passed", "failed", "error", "xfailed", "xpassed")


def pytest_addoption(parser: pytest.Parser) -> None:
    """Take the scene, the sheets that are handed in and the folder of pictures."""
    group = parser.getgroup("plandraft", "plandraft: sheets that are handed in")
    for name, text in (
        ("scene", "the scene that is set"),
        ("sheets", "a sheet that is handed in, or a folder of them"),
    ):
        group.addoption(f"--plandraft-{name}", action="append" if name == "sheets" else None, metavar="PATH", help=text)
        parser.addini(f"plandraft_{name}", text, type="paths", default=[])
    group.addoption("--plandraft-report", metavar="DIR", help="folder for pictures of what is wrong (default: none)")
    group.addoption(
        "--plandraft-silent", action="store_true", help="tell what is wrong without values, as to a student"
    )


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    """Run a test that takes a sheet once for each that is handed in."""
    if ASKED in metafunc.fixturenames and not _is_own(metafunc) and (sheets := _sheets(metafunc.config)):
        metafunc.parametrize(ASKED, sheets, indirect=True, ids=[path.name for path in sheets])


def _is_own(metafunc: pytest.Metafunc) -> bool:
    """Tell whether a test gives itself what we would give it."""
    marks = metafunc.definition.iter_markers("parametrize")
    return any(ASKED in re.split(r"[,\s]+", names) for mark in marks if isinstance(names := mark.args[0], str))


@pytest.fixture
def sheet(request: pytest.FixtureRequest) -> HandedSheet:
    """Each of the sheets that are handed in (`--plandraft-sheets`), of the scene that is set."""
    if not hasattr(request, "param"):
        raise pytest.UsageError("no sheets are handed in: run with --plandraft-sheets PATH, or set plandraft_sheets")
    request.node.user_properties.append((ANSWERED, str(request.param)))
    return _handed(request, request.param, _scene(request.config))


@pytest.fixture
def scene(request: pytest.FixtureRequest) -> Assignment:
    """The scene that is set (`--plandraft-scene`)."""
    found = _scene(request.config)
    if found is None:
        raise pytest.UsageError("no scene is set: run with --plandraft-scene FILE, or set plandraft_scene")
    return found


@pytest.fixture
def read_sheet(request: pytest.FixtureRequest) -> Callable[..., HandedSheet]:
    """Give a sheet of a file, by its path from the test's own folder; its scene, if it is given, by its path too."""

    def read(path: str | Path, scene: str | Path | None = None) -> HandedSheet:
        folder = request.path.parent
        return _handed(request, folder / path, None if scene is None else _assignment(folder / scene))

    return read


def _handed(request: pytest.FixtureRequest, path: Path, scene: Assignment | None) -> HandedSheet:
    from drawings.pytest_plugin.handed_sheet import HandedSheet

    options = request.config.option
    report = options.plandraft_report and Path(options.plandraft_report)
    name = re.sub(r"[^\w.-]+", "-", f"{request.path.stem}-{request.node.name}").strip("-").removesuffix(".svg")
    return HandedSheet(path, scene, report or None, name, options.plandraft_silent)


def _scene(config: pytest.Config) -> Assignment | None:
    path = config.option.plandraft_scene or next(iter(config.getini("plandraft_scene")), None)
    return None if path is None else _assignment(Path(path))


def _assignment(path: Path) -> Assignment:
    from drawings.pytest_plugin.assignment import assignment

    return assignment(path)


def _sheets(config: pytest.Config) -> tuple[Path, ...]:
    """Give the sheets that are handed in, all files of a folder among them: what is no sheet is answered for too."""
    if SHEETS not in config.stash:
        asked = config.option.plandraft_sheets or config.getini("plandraft_sheets")
        config.stash[SHEETS] = tuple(file for path in asked for file in _files(Path(path)))
    return config.stash[SHEETS]


def _files(path: Path) -> Sequence[Path]:
    if not path.is_dir():
        return [path]
    found = sorted(file for file in path.iterdir() if not file.name.startswith(".") and not file.is_dir())
    if answers := [file.name for file in found if file.suffix in ANSWERS]:
        raise pytest.UsageError(f"{path}: {', '.join(answers)} lies among the sheets: give a folder of sheets alone")
    if not found:
        raise pytest.UsageError(f"{path}: no sheet is handed in there")
    return found


def pytest_sessionfinish(session: pytest.Session, exitstatus: int) -> None:
    """End otherwise than well if a sheet is not answered for, unless somebody chose among the tests."""
    reporter: Any = session.config.pluginmanager.get_plugin("terminalreporter")
    if reporter is not None and exitstatus == pytest.ExitCode.OK and not _is_chosen(session.config):
        session.exitstatus = pytest.ExitCode.TESTS_FAILED if _left(reporter) else exitstatus


def _is_chosen(config: pytest.Config) -> bool:
    """Tell whether somebody chose among the tests, by their names, their marks or how they ended last."""
    by = [getattr(config.option, name, None) for name in ("keyword", "markexpr", "lf", "deselect")]
    return any(by) or any("::" in argument for argument in config.args)


def pytest_terminal_summary(terminalreporter: Any) -> None:
    """Tell how many sheets were handed in, and which of them no test answers for."""
    if asked := _asked(terminalreporter):
        left = _left(terminalreporter)
        text = f"; not answered for: {', '.join(left)}" if left else ""
        terminalreporter.write_line(f"plandraft: {len(asked)} handed in, {len(asked) - len(left)} answered for{text}")


def _left(reporter: Any) -> list[str]:
    """Give the sheets that no test ran to its end for."""
    return [path for path in _asked(reporter) if path not in _answered(reporter)]


def _asked(reporter: Any) -> list[str]:
    """Give the sheets that must be answered for: all, if the command names them or if one of them is.

    None is due where the tests are only listed, or only what they take is set up.
    """
    if any(getattr(reporter.config.option, name, False) for name in LISTED):
        return []
    wanted = reporter.config.option.plandraft_sheets or _answered(reporter)
    return [str(path) for path in _sheets(reporter.config)] if wanted else []


def _answered(reporter: Any) -> set[str]:
    """Give the sheets that a test ran to its end for."""
    ends = (report for name in ENDS for report in reporter.stats.get(name, ()))
    pairs = (pair for report in ends for pair in getattr(report, "user_properties", ()))
    return {str(value) for name, value in pairs if name == ANSWERED}
