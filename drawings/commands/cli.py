"""The command plandraft: arguments, messages and exit codes; each command imports only what it needs."""

from __future__ import annotations

import argparse
import io
import os
import sys
from collections.abc import Sequence
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import Any

from drawings import VERSION
from drawings.commands.stderr import FILES, UNREADABLE, tell
from drawings.files.signals import Stopped
from geometry.errors import DraftError

BUG, SCENE, STOPPED = 1, 3, 130

TRACED = "tell on stderr what was made, imported and left out, and how long each stage took"
EPILOG = """\
exit codes: 0 written and verified; 1 a bug of plandraft; 2 wrong command line; 3 the scene is wrong;
4 drawn, but with gaps, marks too near a dead centre, a machine that stops, or a cam beyond its limit, undercut, not
held by its spring, or with too short a face; 5 a self-check failed, sheet withheld;
7 cannot read or write; 8 a named limit was exceeded. Of check: 0 whole; 4 whole as far as it could be checked;
5 not as it was drawn. Of grade: 0 all right; 4 some with mistakes; 5 some rejected, which cannot be graded.

a scene is one TOML file: what is studied, a linkage or a rotor, and what is asked of it.
start from a scene of the gallery (plandraft new) and change it; every mistake is told with its line and what to write.
"""


class _Parser(argparse.ArgumentParser):
    """A parser that does not pass over a stdout that is full."""

    def _print_message(self, message: str, file: Any = None) -> None:
        if file is sys.stdout:
            file.write(message)
        else:
            tell(message.rstrip("\n"))


@cache
def parser() -> argparse.ArgumentParser:
    """Make the parser of the command line."""
    top = _Parser(
        prog="plandraft",
        description="Draw a mechanism's plans as exact constructions on a scaled sheet, and check every number.",
        epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    top.add_argument("--version", action="version", version=f"plandraft {VERSION}", help="show the version and stop")
    # The name of the program is given, for argparse would import shutil to find out how it is written.
    commands = top.add_subparsers(dest="command", metavar="COMMAND", required=True, prog=top.prog)
    draw = _command(commands, "draw", "draw the scene's sheets, compare, and write the report beside them")
    draw.add_argument(
        "-o", "--output", type=Path, default=Path("out"), metavar="DIR", help="folder for the sheets (default: out)"
    )
    draw.add_argument("--trace", action=_Trace, nargs=0, help=TRACED)
    form = _command(commands, "form", "write the blank sheets of the task, for a student to draw on: no results")
    form.add_argument(
        "-o", "--output", type=Path, default=Path("out"), metavar="DIR", help="folder for the form (default: out)"
    )
    form.add_argument("--language", type=_language, metavar="LANGUAGE", help="en or ru (default: the scene's)")
    new = commands.add_parser("new", help="write a scene of the gallery to start from; without a name, list them")
    new.add_argument("name", nargs="?", metavar="NAME", help="the scene's name in the gallery")
    new.add_argument("-o", "--output", type=Path, default=Path(), metavar="DIR", help="its folder (default: this one)")
    _solve(commands)
    compare = _command(commands, "compare", "compare construction and analysis, quantity by quantity")
    compare.add_argument("--json", action="store_true", help="as JSON")
    explain = _command(commands, "explain", "print the drafting steps behind a mark")
    explain.add_argument("mark", metavar="MARK", help="a letter of a plan, such as B, v_B, omega_3, R_12, m_1D_1, K2:P")
    explain.add_argument("--position", type=int, default=0, metavar="K", help="number of the position (default: 0)")
    explain.add_argument("--all", action="store_true", help="of a force also the plans that it rests on")
    explain.add_argument("--json", action="store_true", help="as JSON")
    measure = commands.add_parser("measure", help="read the vectors of an SVG sheet back in true units")
    measure.add_argument("sheet", type=Path, metavar="SHEET.svg", help="a sheet of plandraft, edited or not")
    measure.add_argument(
        "--scene", type=Path, metavar="SCENE", help="tell also what it has not, or must not, by its scene"
    )
    measure.add_argument("--json", action="store_true", help="as JSON")
    _check(commands)
    _grade(commands)
    _bench(commands)
    schema = commands.add_parser("schema", help="print the JSON Schema of a scene, for editors")
    schema.add_argument("-o", "--output", type=Path, metavar="FILE", help="write it into a file")
    return top


def _check(commands: argparse._SubParsersAction[_Parser]) -> None:
    check = commands.add_parser("check", help="tell whether written sheets are whole and as their scene has them")
    check.add_argument("sheets", type=Path, nargs="+", metavar="SHEET.svg", help="a sheet that plandraft drew")
    check.add_argument("--scene", type=Path, metavar="SCENE", help="its scene (default: looked for beside the sheet)")
    check.add_argument("--language", type=_language, metavar="LANGUAGE", help="en or ru (default: the scene's)")
    check.add_argument("--json", action="store_true", help="as JSON")


def _grade(commands: argparse._SubParsersAction[_Parser]) -> None:
    grade = _command(commands, "grade", "grade sheets that students hand in, quantity by quantity")
    grade.add_argument("sheets", type=Path, nargs="+", metavar="SHEET.svg", help="a sheet that a student hands in")
    grade.add_argument("--marks", type=Path, metavar="FILE", help="points by quantity, a TOML file (default: one each)")
    grade.add_argument(
        "--tolerance",
        type=_tolerance,
        default="0.2 mm",
        metavar="T",
        help='"0.2 mm" that a hand slips by, "2 %%" of a plan\'s largest vector, or exact (default: 0.2 mm)',
    )
    grade.add_argument("--language", type=_language, metavar="LANGUAGE", help="en or ru (default: the scene's)")
    grade.add_argument("-o", "--output", type=Path, metavar="DIR", help="folder for feedback sheets (default: none)")
    form = grade.add_mutually_exclusive_group()
    form.add_argument("--json", action="store_true", help="as JSON")
    form.add_argument("--csv", action="store_true", help="as CSV, a row for each sheet")


def _tolerance(text: str) -> object:
    from drawings.grading.tolerance_text import allowance  # only this option asks for it

    if (found := allowance(text)) is None:
        raise argparse.ArgumentTypeError(f'{text} is no tolerance: write "0.2 mm", "2 %" or exact')
    return found


def _solve(commands: argparse._SubParsersAction[_Parser]) -> None:
    solve = _command(commands, "solve", "print all numbers as JSON: SI units and radians, null at gaps")
    solve.add_argument(
        "--by", choices=("construction", "analysis"), default="construction", help="which road (default: construction)"
    )
    solve.add_argument("--json", action="store_true", help="JSON, which is the only form and the default")
    solve.add_argument(
        "--only",
        type=_orders,
        metavar="PLANS",
        help="some plans, joined by commas: positions,velocities or forces",
    )
    solve.add_argument("--trace", action=_Trace, nargs=0, help=TRACED)


def _bench(commands: argparse._SubParsersAction[_Parser]) -> None:
    bench = _command(commands, "bench", "measure error against run time of every technique on the scene")
    bench.add_argument("-o", "--output", type=Path, metavar="DIR", help="folder for the table (CSV) and the plot (SVG)")
    bench.add_argument(
        "--positions", type=_counts, metavar="N,N", help="numbers of positions (default: 12,360,10000,100000)"
    )
    bench.add_argument("--repetitions", type=_count, metavar="R", help="repetitions of each row at most (default: 15)")
    bench.add_argument("--quick", action="store_true", help="12 and 360 positions, 3 repetitions, one sheet")
    bench.add_argument(
        "--accept", type=_share, metavar="X", help="error accepted, share of the plan's largest (default: 1e-4)"
    )
    bench.add_argument(
        "--startup", action=argparse.BooleanOptionalAction, help="time a cold plandraft draw (default: unless --quick)"
    )
    bench.add_argument("--json", action="store_true", help="as JSON")


def _language(text: str) -> str:
    from plans.words.words import languages  # only this option asks for them

    if text not in languages():
        raise argparse.ArgumentTypeError(f"{text} is none of {', '.join(languages())}")
    return text


def _count(text: str) -> int:
    if not text.isdecimal() or not int(text):
        raise argparse.ArgumentTypeError(f"{text} is no whole number above zero")
    return int(text)


def _share(text: str) -> float:
    try:
        share = float(text)
    except ValueError:
        share = 0.0
    if not 0.0 < share < 1.0:
        raise argparse.ArgumentTypeError(f"{text} is no number between 0 and 1")
    return share


def _counts(text: str) -> list[int]:
    return [_count(part.strip()) for part in text.split(",")]


def _command(commands: argparse._SubParsersAction[_Parser], name: str, text: str) -> argparse.ArgumentParser:
    command = commands.add_parser(name, help=text, description=text[0].upper() + text[1:] + ".")
    command.add_argument("scene", type=Path, metavar="SCENE", help="the scene, a TOML file")
    return command


def _orders(text: str) -> list[str]:
    names = [name.strip() for name in text.split(",")]
    from plans.techniques import TECHNIQUES  # only this option asks for the table

    known = [plan for row in TECHNIQUES.values() for plan in row.plans]
    wrong = [name for name in names if name not in known]
    if wrong or not names:
        raise argparse.ArgumentTypeError(f"{', '.join(wrong)} is none of {', '.join(known)}")
    return names


class _Trace(argparse.Action):
    """Begins the trace at once, before the command's libraries are imported."""

    def __call__(self, parser: object, namespace: argparse.Namespace, *_: object) -> None:
        from drawings.commands.trace import begin  # a run that is not traced needs no watch

        setattr(namespace, self.dest, begin())


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; give its exit code."""
    options = argparse.Namespace()
    try:
        _open_stdout()
        code = _run(arguments, options)
        sys.stdout.flush()
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return FILES
    except KeyboardInterrupt:
        return STOPPED
    except Stopped as stopped:
        return stopped.exit_code
    except (DraftError, OSError) as error:
        tell(_told(error, options))
        return _code(error)
    except ImportError as error:
        tell(UNREADABLE.format(error=error))
        return FILES
    except Exception:  # whatever else happens is a bug of ours, and is said to be one
        tell(f"plandraft: internal error, a bug of plandraft; please report {_bug_report()}")
        return BUG
    return code


def _run(arguments: Sequence[str] | None, options: argparse.Namespace) -> int:
    try:
        parser().parse_args(arguments, options)
    except SystemExit as end:  # help, the version, or a wrong command line
        return int(end.code or 0)
    code: int = import_module(f"drawings.commands.{options.command}").run(options)
    return code


def _open_stdout() -> None:
    """Let every sign through a stdout that lacks it; where there is no stdout, data has nowhere to go."""
    if sys.stdout is None:
        from plans.words.words import message

        raise OSError(message("file.stdout"))
    if isinstance(sys.stdout, io.TextIOWrapper):
        sys.stdout.reconfigure(errors="backslashreplace")


def _told(error: Exception, options: argparse.Namespace) -> str:
    """Word an error in the language of the scene, which may be named in a file that is otherwise at fault."""
    from drawings.commands.talk import language_of, worded  # only an error pays for it
    from plans.words.words import ENGLISH

    scene = getattr(options, "scene", None)  # the vectors of a sheet are measured without any scene
    return worded(error, language_of(scene) if scene else ENGLISH)


def _code(error: Exception) -> int:
    if isinstance(error, DraftError) and error.exit_code:
        return error.exit_code
    return FILES if isinstance(error, OSError) else SCENE


def _bug_report() -> str:
    """Keep the traceback in a file of its own, so that the user's screen stays readable; without a disk, give it."""
    import tempfile  # only a bug pays for it
    import traceback

    report = f"plandraft {VERSION}, Python {sys.version}\n\n{traceback.format_exc()}"
    try:
        handle, name = tempfile.mkstemp(prefix="plandraft-bug-", suffix=".txt")
        with os.fdopen(handle, "w", encoding="utf-8") as file:
            file.write(report)
    except OSError:
        return report
    return name
