"""The command plandraft: messages and exit codes; each command imports only what it needs."""

from __future__ import annotations

import argparse
import io
import os
import sys
from collections.abc import Sequence
from importlib import import_module

from drawings import VERSION
from drawings.commands.parser import parser
from drawings.commands.stderr import FILES, UNREADABLE, tell, worded
from drawings.files.signals import Stopped
from geometry.errors import DraftError

BUG, SCENE, STOPPED = 1, 3, 130


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
        tell(_worded(error, options))
        if isinstance(error, DraftError) and error.exit_code:
            return error.exit_code
        return FILES if isinstance(error, OSError) else SCENE
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


def _worded(error: Exception, options: argparse.Namespace) -> str:
    """Word an error in the language of the scene, which may be named in a file that is otherwise at fault."""
    from plans.scene.source import language_of  # only an error pays for it
    from plans.words.words import ENGLISH

    scene = getattr(options, "scene", None)  # the vectors of a sheet are measured without any scene
    return worded(error, language_of(scene) if scene else ENGLISH)


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
