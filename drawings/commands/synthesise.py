"""plandraft synthesise: the mechanism of a task of synthesis as a scene of its own."""

from __future__ import annotations

import argparse
from pathlib import Path

from drawings.commands.stderr import noted
from drawings.files import atomic_files
from drawings.files.atomic_files import FileError
from plans.scene.scene import read_scene
from plans.study import Study
from plans.synthesis.study import SynthesisStudy
from plans.synthesis.written import written
from plans.words.words import message

FAILED = 5


def run(options: argparse.Namespace) -> int:
    """Solve the task, see that both roads agree, and write the scene, never over a file that is there."""
    study = Study(read_scene(options.scene), ("synthesis",))
    noted(study)
    if not study.comparison("synthesis").agrees:
        return FAILED
    scene = study.scene
    found = study.of(SynthesisStudy)
    made = found.family.mechanism(found.synthesis.chosen)
    text = written(made, scene.title, Path(scene.file).name, scene.sheet.language)
    if options.output is None:
        print(text, end="")
        return 0
    atomic_files.prepare(options.output.parent)
    if not atomic_files.write_new(options.output, text.encode()):
        raise FileError(options.output, message("file.exists"))
    print(options.output)
    return 0
