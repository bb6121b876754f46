"""Nothing but the sheet is opened while a student's sheet is graded, whatever it refers to: Python itself looks on."""

from __future__ import annotations

import re
import socket
import subprocess
import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path

import pytest

from drawings.grading.allowance import Allowances
from drawings.grading.class_list import answered, grade_all
from drawings.grading.graded import PASS, UNREAD, Graded, SheetTask, grade
from tests.drawings.students import Task, drawn, task, true_places

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="no process that knows what its parent knows")
# What leaves a process, as Python calls it.
LEAVING = ("socket.", "subprocess.", "os.system", "os.exec", "os.posix_spawn", "os.fork", "urllib.", "ctypes.dlopen")
SECRET = "file:///etc/hostname"
WEB = "http://127.0.0.1:9/x"
INSIDE = {  # of the sheet, before its end
    "a picture of a file": f'<image href="{SECRET}" width="9" height="9"/>',
    "a picture of the web": f'<image xlink:href="{WEB}" width="9" height="9"/>',
    "a use of another file": f'<use href="{SECRET}#a"/>',
    "a style of the web": f"<style>@import url({WEB});</style>",
    "a font of a file": f"<style>@font-face {{ font-family: x; src: url({SECRET}); }}</style>",
    "a filter of a file": f'<g filter="url({SECRET}#f)"><path d="M0 0L9 9" stroke="#000"/></g>',
    "a marker of the web": f'<path d="M0 0L9 9" stroke="#000" marker-end="url({WEB}#m)"/>',
    "a script": f'<script href="{WEB}">open("{SECRET}")</script>',
    "a page of the web": f'<foreignObject><iframe xmlns="http://www.w3.org/1999/xhtml" src="{WEB}"/></foreignObject>',
    "an inclusion": f'<xi:include xmlns:xi="http://www.w3.org/2001/XInclude" href="{SECRET}"/>',
}
BEFORE = {  # the root
    "a style sheet of the web": f'<?xml-stylesheet href="{WEB}" type="text/css"?>',
    "a document type of the web": f'<!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "{WEB}">',
    "an entity of a file": f'<!DOCTYPE svg [<!ENTITY x SYSTEM "{SECRET}">]>',
    "a parameter entity of the web": f'<!DOCTYPE svg [<!ENTITY % x SYSTEM "{WEB}"> %x;]>',
}  # fmt: skip


@pytest.fixture(scope="module")
def own() -> Task:
    return task("slider-crank")


@pytest.fixture(scope="module")
def source(own: Task) -> str:
    """A right sheet; it has been graded once, so that all is imported."""
    plan = next(plan for plan in own.plans if plan.plan == "velocities")
    found = drawn(own.sheet(plan.sheet), plan, true_places(plan))
    assert grade(found, SheetTask(own.plans), Allowances()).outcome == PASS
    return found.decode().replace("<svg ", '<svg xmlns:xlink="http://www.w3.org/1999/xlink" ', 1)


def watched(path: Path, grading: Callable[[bytes], Graded]) -> tuple[str, set[str], set[str]]:
    """Grade a sheet; give how it ends, the files that are opened meanwhile and what leaves the process."""

    def looked_on(_: bytes) -> tuple[str, set[str], set[str]]:
        opened, left = set[str](), set[str]()

        def see(event: str, arguments: tuple[object, ...]) -> None:
            if event == "open" and not isinstance(arguments[0], int):
                opened.add(str(arguments[0]))
            if event.startswith(LEAVING):
                left.add(event)

        sys.addaudithook(see)  # stays until the process ends, which does nothing else
        outcome = answered(path, grading).outcome
        return outcome, set(opened), set(left)

    ((_, seen),) = grade_all([path], looked_on)
    assert isinstance(seen, tuple) and not isinstance(seen, Graded)
    return seen


@pytest.mark.parametrize("what", [*INSIDE, *BEFORE])
def test_only_the_sheet_is_opened(own: Task, source: str, tmp_path: Path, what: str) -> None:
    path = tmp_path / "bob.svg"
    end, root = source.rindex("</svg>"), source.index("<svg ")
    hostile = f"{source[:end]}{INSIDE.get(what, '')}{source[end:]}"
    hostile = f"{hostile[:root]}{BEFORE.get(what, '')}{hostile[root:]}"
    if "entity of a file" in what:
        hostile = re.sub("(<title>)", r"\1&x;", hostile, count=1)
    path.write_text(hostile, encoding="utf-8")
    outcome, opened, left = watched(path, partial(grade, task=SheetTask(own.plans), by=Allowances()))
    assert outcome in (PASS, UNREAD)
    assert (opened, left) == ({str(path)}, set())


def reaching(source: bytes) -> Graded:
    Path("/etc/hostname").open("rb").close()
    with socket.socket() as end:
        end.connect_ex(("127.0.0.1", 9))
    subprocess.run(["true"], check=True)
    return Graded(PASS)


def test_what_reaches_out_is_seen(tmp_path: Path) -> None:
    path = tmp_path / "bob.svg"
    path.write_bytes(b"<svg/>")
    _, opened, left = watched(path, reaching)
    assert {str(path), "/etc/hostname"} <= opened
    assert {"socket.connect", "subprocess.Popen"} <= left
