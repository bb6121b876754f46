"""plandraft solve: all numbers of a scene as JSON, by construction or by analysis."""

from __future__ import annotations

import argparse
from typing import Any

from drawings.commands.stderr import noted, tell
from drawings.commands.trace import TracedMark
from drawings.files.atomic_files import print_json
from plans.scene.scene import read_scene
from plans.study import Study

GAPS = 4


def run(options: argparse.Namespace) -> int:
    """Print the numbers; give the exit code."""
    trace: TracedMark = options.trace or TracedMark()
    with trace.stage("reading the scene"):
        study = Study(read_scene(options.scene), options.only)
        noted(study)
    with trace.stage(options.by):
        found = [study.numbers(technique, options.by) for technique in study.techniques]
    with trace.stage("writing"):
        data: dict[str, Any] = {}
        for numbers in found:
            data |= numbers.plain()
        print_json(data)
    if options.trace:
        tell(trace.stated(study))
    return GAPS if any(numbers.flawed for numbers in found) else 0
