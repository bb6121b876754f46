"""plandraft form: the blank sheets of a scene's task, for a student to draw on."""

from __future__ import annotations

import argparse
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from drawings.commands.draw import admit
from drawings.commands.stderr import noted, tell
from drawings.files.atomic_files import staged
from drawings.files.sheet_set import manifest_of, output_folder, placed_sheets, publish, stem_of
from drawings.lettering.lettering import lettered
from plans.scene.scene import read_scene
from plans.study import Study
from plans.words.words import message, placed

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf

SUFFIX = "-form"  # of the scene's name in the names of the files: its own sheets stay beside them


def run(options: argparse.Namespace) -> int:
    """Write the form of a scene into a folder; give the exit code."""
    for path in form(options.scene, options.output, options.language):
        print(path)
    return 0


def form(path: Path, folder: Path, language: str | None = None) -> tuple[Path, ...]:
    """Write the form of a scene, all its sheets or none; give their paths."""
    scene = read_scene(path)
    study = Study(scene.changed(sheet=scene.sheet.changed(language=language or scene.sheet.language)))
    noted(study)
    admit(study.scene)
    with output_folder(folder) as left:
        for fault in left.faults(folder):
            tell(fault.worded(study.scene.sheet.language))
        from drawings.form.form import form_of

        study.construct()
        return _written(study, form_of(study), folder)


def _written(study: Study, leaves: Mapping[str, Sequence[Leaf]], folder: Path) -> tuple[Path, ...]:
    from drawings.form.blank_file import blank_file, see_blank

    scene, stem = study.scene, f"{stem_of(study.scene)}{SUFFIX}"
    sheets = dict(placed_sheets(folder, stem, leaves))
    contents = {path: blank_file(lettered(leaf, scene.sheet.lettering)) for path, (_, leaf) in sheets.items()}
    manifest = manifest_of(f"{stem}.toml", scene.content, contents)._replace(scene=Path(scene.file).name)
    with staged(contents) as temporaries:
        for path in temporaries.values():
            see_blank(path.read_bytes(), study)
        for path in publish(folder, manifest, temporaries):
            tell(placed(path, message("file.surplus")).worded(scene.sheet.language))
    return tuple(sheets)
