"""Times whole commands in turn, A B A B ..., so that both meet the same machine; the result is a ratio of medians."""

from __future__ import annotations

import os
import statistics
import subprocess
import time
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple


class Comparison(NamedTuple):
    """Medians in seconds, and how much longer the first takes than the second."""

    ours: float
    theirs: float

    @property
    def ratio(self) -> float:
        return self.ours / self.theirs


def seconds(command: Sequence[str | Path], cwd: Path) -> float:
    """How long one run of a command takes, from outside, its output thrown away."""
    start = time.perf_counter()
    subprocess.run(
        [str(part) for part in command], cwd=cwd, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=os.environ
    )
    return time.perf_counter() - start


def compare(ours: Sequence[str | Path], theirs: Sequence[str | Path], cwd: Path, runs: int = 9) -> Comparison:
    """Run both commands in turn after one warm-up each."""
    times: tuple[list[float], list[float]] = ([], [])
    for turn in range(runs + 1):
        for command, taken in zip((ours, theirs), times, strict=True):
            taken.append(seconds(command, cwd))
            if turn == 0:
                taken.clear()
    return Comparison(*(statistics.median(taken) for taken in times))
