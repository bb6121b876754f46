"""plandraft synthesise: the mechanism of a task of synthesis as a scene of its own."""

from __future__ import annotations

import argparse
import tomllib
from pathlib import Path

from drawings.commands import draw
from drawings.commands.stderr import noted
from drawings.files import atomic_files
from drawings.files.atomic_files import FileError
from plans.scene.scene import read_scene
from plans.study import Study
from plans.synthesis.study import SynthesisStudy
from plans.synthesis.written import written
from plans.words.words import message

FAILED = 5
KEPT = (
    "standard",
    "format",
    "drawn",
    "checked",
    "approved",
    "date",
    "group",
    "organisation",
)  # a number is each sheet's


def run(options: argparse.Namespace) -> int:
    """Solve the task, see that both roads agree, write the scene, never over a file that is there, draw both."""
    study = Study(read_scene(options.scene), ("synthesis",))
    noted(study)
    if not study.comparison("synthesis").agrees:
        return FAILED
    text = _text(study, options.tables)
    if options.output is None:
        print(text, end="")
        return 0
    atomic_files.prepare(options.output.parent)
    if not atomic_files.write_new(options.output, text.encode()):
        raise FileError(options.output, message("file.exists"))
    print(options.output)
    scenes = (options.scene, options.output) if options.draw else ()
    return max((draw.run(argparse.Namespace(scene=one, output=options.draw, trace=None)) for one in scenes), default=0)


def _text(study: Study, tables: Path | None) -> str:
    scene, found = study.scene, study.of(SynthesisStudy)
    further = "" if tables is None else tables.read_text("utf-8-sig")
    made = found.family.mechanism(found.synthesis.chosen)
    told = tomllib.loads(scene.content.decode("utf-8-sig")).get("sheet", {})
    sheet = {"language": scene.sheet.language} | {key: told[key] for key in KEPT if key in told}
    return written(made, scene.title, Path(scene.file).name, sheet, further)
