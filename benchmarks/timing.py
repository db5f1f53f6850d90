"""Times whole commands in turn, A B C A B C ..., so that all meet the same machine. What counts is the CPU time of the
process and of its children; a loaded machine stretches the clock more than that."""

from __future__ import annotations

import os
import resource
import statistics
import subprocess
from collections.abc import Mapping
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple


class Command(NamedTuple):
    """What is run, and where."""

    words: Sequence[str | Path]
    folder: Path


class Usage(NamedTuple):
    """What one process and its children took."""

    seconds: float
    """CPU time, of user and system."""
    mebibytes: float
    """The most memory at one time."""
    killed: bool = False


def usage(command: Command, limit: int | None = None) -> Usage:
    """Run a command once, its output thrown away; it is killed when it takes more CPU seconds than the limit."""
    process = subprocess.Popen(
        [str(word) for word in command.words],
        cwd=command.folder,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        preexec_fn=(lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit))) if limit else None,
    )
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = status
    return Usage(used.ru_utime + used.ru_stime, used.ru_maxrss / 1024, os.WIFSIGNALED(status))


def medians(commands: Mapping[str, Command], runs: int) -> dict[str, Usage]:
    """The median usage of each command, all run in turn after one run that does not count."""
    taken: dict[str, list[Usage]] = {name: [] for name in commands}
    for turn in range(runs + 1):
        for name, command in commands.items():
            used = usage(command)
            if turn:
                taken[name].append(used)
    return {
        name: Usage(
            statistics.median(each.seconds for each in all_), statistics.median(each.mebibytes for each in all_)
        )
        for name, all_ in taken.items()
    }
