"""What tests of drawings share: the command run in this process, a scene with gaps."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from drawings.commands import cli
from tests.drawings.mechanisms import TWO_ROCKERS

Run = Callable[..., tuple[int, str, str]]


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str]) -> Run:
    """Run plandraft in this process: exit code, stdout, stderr."""

    def command(*arguments: object) -> tuple[int, str, str]:
        try:
            code = cli.main([str(argument) for argument in arguments])
        except SystemExit as end:
            code = int(end.code or 0)
        out, err = capsys.readouterr()
        assert "Traceback" not in out + err
        return code, out, err

    return command


@pytest.fixture
def gapped(tmp_path: Path) -> Path:
    scene = tmp_path / "rockers.toml"
    scene.write_text(TWO_ROCKERS, "utf-8")
    return scene
