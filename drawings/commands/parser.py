"""The command line of plandraft: its commands, their arguments and options (командная строка)."""

from __future__ import annotations

import argparse
import sys
from functools import cache, partial
from pathlib import Path
from typing import Any, TypeAlias

from drawings import VERSION
from drawings.commands.stderr import tell

TRACED = "tell on stderr what was made, imported and left out, and how long each stage took"
EPILOG = """\
exit codes: 0 written and verified; 1 a bug of plandraft; 2 wrong command line; 3 the scene is wrong;
4 drawn, but with gaps, marks too near a dead centre, a machine that stops, or a cam beyond its limit, undercut, not
held by its spring, or with too short a face; 5 a self-check failed, sheet withheld;
7 cannot read or write; 8 a named limit was exceeded. Of check: 0 whole; 4 whole as far as it could be checked;
5 not as it was drawn. Of grade: 0 all right; 4 some with mistakes; 5 some not read, or not all of them.

a scene is one TOML file: what is studied, a linkage or a rotor, and what is asked of it.
start from a scene of the gallery (plandraft new) and change it; every mistake is told with its line and what to write.
"""
LANGUAGES = "en or ru (default: the scene's)"


class _Parser(argparse.ArgumentParser):
    def _print_message(self, message: str, file: Any = None) -> None:
        if file is sys.stdout:
            file.write(message)
        else:
            tell(message.rstrip("\n"))


Commands: TypeAlias = "argparse._SubParsersAction[_Parser]"


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
    for add in (_draw, _form, _new, _solve, _compare, _explain, _measure, _check, _grade, _bench, _schema, _synthesise):
        add(commands)
    return top


def _draw(commands: Commands) -> None:
    draw = _command(commands, "draw", "draw the scene's sheets, compare, and write the report beside them")
    draw.add_argument(
        "-o", "--output", type=Path, default=Path("out"), metavar="DIR", help="folder for the sheets (default: out)"
    )
    draw.add_argument("--trace", action=_TraceParser, nargs=0, help=TRACED)


def _form(commands: Commands) -> None:
    form = _command(commands, "form", "write the blank sheets of the task, for a student to draw on: no results")
    form.add_argument(
        "-o", "--output", type=Path, default=Path("out"), metavar="DIR", help="folder for the form (default: out)"
    )
    form.add_argument("--language", type=_language, metavar="LANGUAGE", help=LANGUAGES)


def _new(commands: Commands) -> None:
    new = commands.add_parser("new", help="write a scene of the gallery to start from; without a name, list them")
    new.add_argument("name", nargs="?", metavar="NAME", help="the scene's name in the gallery")
    new.add_argument("-o", "--output", type=Path, default=Path(), metavar="DIR", help="its folder (default: this one)")


def _compare(commands: Commands) -> None:
    compare = _command(commands, "compare", "compare construction and analysis, quantity by quantity")
    compare.add_argument("--json", action="store_true", help="as JSON")


def _explain(commands: Commands) -> None:
    explain = _command(commands, "explain", "print the drafting steps behind a mark")
    explain.add_argument("mark", type=_sheet, metavar="MARK", help="a letter of a sheet, such as B, v_B, R_12, K, K2:P")
    explain.add_argument("--position", type=int, default=0, metavar="K", help="number of the position (default: 0)")
    explain.add_argument(
        "--all", action="store_true", help="every step, of a force also those of the plans that it rests on"
    )
    explain.add_argument("--json", action="store_true", help="as JSON")


def _measure(commands: Commands) -> None:
    measure = commands.add_parser("measure", help="read the vectors of an SVG sheet back in true units")
    measure.add_argument("sheet", type=_sheet, metavar="SHEET.svg", help="a sheet of plandraft, edited or not")
    measure.add_argument(
        "--scene", type=_scene, metavar="SCENE", help="tell also what it has not, or must not, by its scene"
    )
    measure.add_argument("--json", action="store_true", help="as JSON")


def _schema(commands: Commands) -> None:
    schema = commands.add_parser("schema", help="print the JSON Schema of a scene, for editors")
    schema.add_argument("-o", "--output", type=Path, metavar="FILE", help="write it into a file")


def _check(commands: Commands) -> None:
    check = commands.add_parser("check", help="tell whether written sheets are whole and as their scene has them")
    check.add_argument("sheets", type=_sheet, nargs="+", metavar="SHEET.svg", help="a sheet that plandraft drew")
    check.add_argument("--scene", type=_scene, metavar="SCENE", help="its scene (default: looked for beside the sheet)")
    check.add_argument("--language", type=_language, metavar="LANGUAGE", help=LANGUAGES)
    check.add_argument("--json", action="store_true", help="as JSON")


def _grade(commands: Commands) -> None:
    grade = _command(commands, "grade", "grade sheets that students hand in, quantity by quantity")
    grade.add_argument("sheets", type=_sheet, nargs="+", metavar="SHEET.svg", help="a sheet that a student hands in")
    grade.add_argument("--marks", type=Path, metavar="FILE", help="points by quantity, a TOML file (default: one each)")
    grade.add_argument(
        "--tolerance",
        type=_tolerance,
        default="0.2 mm",
        metavar="T",
        help='"0.2 mm" that a hand slips by, "2 %%" of a plan\'s largest vector, or exact (default: 0.2 mm)',
    )
    grade.add_argument("--language", type=_language, metavar="LANGUAGE", help=LANGUAGES)
    grade.add_argument("-o", "--output", type=Path, metavar="DIR", help="folder for feedback sheets (default: none)")
    form = grade.add_mutually_exclusive_group()
    form.add_argument("--json", action="store_true", help="as JSON")
    form.add_argument("--csv", action="store_true", help="as CSV, a row for each sheet")


def _tolerance(text: str) -> object:
    from drawings.grading.allowance import allowance

    if (found := allowance(text)) is None:
        raise argparse.ArgumentTypeError(f'{text} is no tolerance: write "0.2 mm", "2 %" or exact')
    return found


def _solve(commands: Commands) -> None:
    solve = _command(commands, "solve", "print all numbers as JSON: SI units and radians, null at gaps")
    add = solve.add_argument
    add("--by", choices=("construction", "analysis"), default="construction", help="which road (default: construction)")
    add("--json", action="store_true", help="JSON, which is the only form and the default")
    add("--only", type=_orders, metavar="PLANS", help="some plans, joined by commas: extremes,positions or forces")
    add("--trace", action=_TraceParser, nargs=0, help=TRACED)


def _bench(commands: Commands) -> None:
    bench = _command(commands, "bench", "measure error against run time of every technique on the scene")
    add = bench.add_argument
    add("-o", "--output", type=Path, metavar="DIR", help="folder for the table (CSV) and the plot (SVG)")
    add("--positions", type=_counts, metavar="N,N", help="numbers of positions (default: 12,360,10000,100000)")
    add("--repetitions", type=_count, metavar="R", help="repetitions of each row at most (default: 15)")
    add("--quick", action="store_true", help="12 and 360 positions, 3 repetitions, one sheet")
    add("--accept", type=_share, metavar="X", help="error accepted, share of the plan's largest (default: 1e-4)")
    add("--startup", action=argparse.BooleanOptionalAction, help="time a cold plandraft draw (default: unless --quick)")
    add("--json", action="store_true", help="as JSON")


def _synthesise(commands: Commands) -> None:
    synthesise = _command(commands, "synthesise", "write the mechanism of a task of synthesis as a scene of its own")
    add = synthesise.add_argument
    add("-o", "--output", type=Path, metavar="FILE", help="the new scene (default: print it)")
    add("--tables", type=Path, metavar="FILE", help="further tables of the new scene, such as [masses] and [loads]")
    add("--draw", type=Path, metavar="DIR", help="draw the task and the new scene into a folder: a whole project")


def _other_than(ending: str, told: str, text: str) -> Path:
    if text.lower().endswith(ending):
        raise argparse.ArgumentTypeError(f"{text} is {told}")
    return Path(text)


_scene = partial(_other_than, ".svg", "a sheet, and the scene, a TOML file, stands here")
_sheet = partial(_other_than, ".toml", "a scene, and something else stands here: a sheet, or a mark")


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


def _command(commands: Commands, name: str, text: str) -> argparse.ArgumentParser:
    command = commands.add_parser(name, help=text, description=text[0].upper() + text[1:] + ".")
    command.add_argument("scene", type=_scene, metavar="SCENE", help="the scene, a TOML file")
    return command


def _orders(text: str) -> list[str]:
    from plans.scene.forms import PLANS, called  # only this option asks for the table

    given = [name.strip() for name in text.split(",")]
    names = [called(name, PLANS, "plan") for name in given]
    wrong = [name for name, plan in zip(given, names, strict=True) if not plan]
    if wrong:
        raise argparse.ArgumentTypeError(f"{', '.join(wrong)} is none of {', '.join(PLANS)}")
    return names


class _TraceParser(argparse.Action):
    """Begins the trace at once, before the command's libraries are imported."""

    def __call__(self, parser: object, namespace: argparse.Namespace, *_: object) -> None:
        from drawings.commands.trace import begin  # a run that is not traced needs no watch

        setattr(namespace, self.dest, begin())
