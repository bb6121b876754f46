"""The machine that a bench was run on: without it no time means anything."""

from __future__ import annotations

import os
import platform
from dataclasses import dataclass
from pathlib import Path

import numpy as np

_CPUINFO = Path("/proc/cpuinfo")  # Linux; elsewhere the platform's own name of the processor must do


@dataclass(frozen=True)
class Computer:
    """Processor, cores that this process may use, load of the last minute, versions."""

    processor: str
    cores: int
    load: float | None  # mean number of busy processes; None where the system does not tell
    system: str
    python: str
    numpy: str

    def written(self) -> str:
        """Write the machine in one line."""
        busy = "" if self.load is None else f", load {self.load:.1f} at the start"
        cores = f"{self.cores} core{'' if self.cores == 1 else 's'}"
        return f"{self.processor}, {cores}{busy}; {self.system}; Python {self.python}, numpy {self.numpy}"


def machine() -> Computer:
    """Describe this machine."""
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    return Computer(
        processor=_processor(),
        cores=cores,
        load=os.getloadavg()[0] if hasattr(os, "getloadavg") else None,
        system=f"{platform.system()} {platform.machine()}",
        python=platform.python_version(),
        numpy=np.__version__,
    )


def _processor() -> str:
    try:
        lines = _CPUINFO.read_text("utf-8", errors="replace").splitlines()
    except OSError:
        lines = []
    told = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return " ".join(told[0].split()) if told else platform.processor() or platform.machine()
