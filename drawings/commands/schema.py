"""plandraft schema: the JSON Schema of a scene, for editors that complete and check while one writes."""

from __future__ import annotations

import argparse
import json

from drawings.files import atomic_files
from plans.scene.schema import schema


def run(options: argparse.Namespace) -> int:
    """Print the schema, or write it into a file; give the exit code."""
    text = json.dumps(schema(), ensure_ascii=False, indent=2)
    if options.output is None:
        print(text)
    else:
        atomic_files.write(options.output, f"{text}\n".encode())
        print(options.output)
    return 0
