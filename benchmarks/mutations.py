"""A campaign against the whole pipeline: trees of fixtures with broken files, each run, rendered and judged.

    python benchmarks/mutations.py [SECONDS] [SEED]

Counts trees and files, and prints each failure with the seed that makes it again.
"""

from __future__ import annotations

import random
import shutil
import signal
import sys
import tempfile
import time
from functools import cache
from importlib import import_module
from pathlib import Path

PROJECT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(PROJECT))

from bringup_lint.cli.commands.graph import FORMATS as PICTURES  # noqa: E402
from bringup_lint.config import Config  # noqa: E402
from bringup_lint.discover.walk import discover  # noqa: E402
from bringup_lint.engine import run  # noqa: E402
from bringup_lint.finish import Invocation  # noqa: E402
from bringup_lint.finish import finish  # noqa: E402
from bringup_lint.registry import Registry  # noqa: E402
from bringup_lint.report import FORMATS  # noqa: E402
from bringup_lint.report import render  # noqa: E402
from bringup_lint.robot import Robot  # noqa: E402
from tests.scenarios.test_mutated_trees import mutated  # noqa: E402

FIXTURES = PROJECT / "fixtures"
SLOW = 20
"""CPU seconds in which a tree must be done."""


class TooSlow(BaseException):
    pass


def stop(number: int, frame: object) -> None:
    raise TooSlow


def broken(seed: int, folder: Path) -> int:
    """Copy a tree and break some of its files; returns how many."""
    chance = random.Random(seed)
    shutil.copytree(chance.choice(samples()), folder, symlinks=True)
    files = sorted(path for path in folder.rglob("*") if path.is_file() and not path.is_symlink())
    for path in files:
        if path.name != "bringup-lint.toml":
            path.write_bytes(mutated(path.read_bytes().decode("utf-8", "replace"), chance).encode("utf-8", "replace"))
    return len(files)


def judge(folder: Path, registry: Registry) -> list[str]:
    """What failed in a tree: rules, parsers, layers, places, reports and pictures, each in all of its formats."""
    robot = Robot(discover((str(folder),)))
    outcome = run(robot, registry, Config(min_severity="info"))
    failures = list(outcome.failures)
    for found in outcome.findings:
        if not 0 <= found.span.start <= found.span.end <= len(found.source.text):
            failures.append(f"{found.rule}: a place outside of the text")
    report = finish(outcome, robot, Invocation(("bringup-lint",), str(folder), time.time()), drawn=True)
    failures += [note.message for note in report.notifications if note.level == "error"]
    texts = {name: render(name, report) for name in FORMATS}
    failures += [f"{name} is empty" for name in ("json", "sarif", "html", "junit") if not texts[name]]
    failures += [f"the picture: {error!r}" for error in robot.graph.failures]
    for name in PICTURES:
        if not import_module(f"bringup_lint.report.picture.{name}").render(report.picture):
            failures.append(f"the picture as {name} is empty")
    return failures


def attempt(seed: int, registry: Registry) -> tuple[int, int]:
    """Break a tree and judge it; how many files it has, and how much failed, which is printed."""
    signal.signal(signal.SIGVTALRM, stop)
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place, "tree")
        files = broken(seed, folder)
        signal.setitimer(signal.ITIMER_VIRTUAL, SLOW)
        try:
            failures = judge(folder, registry)
        except TooSlow:
            failures = [f"takes more than {SLOW} s"]
        except Exception as error:
            failures = [f"escaped: {error!r}"]
        finally:
            signal.setitimer(signal.ITIMER_VIRTUAL, 0)
    for failure in failures:
        print(f"seed {seed}: {failure}", flush=True)
    return files, len(failures)


@cache
def samples() -> tuple[Path, ...]:
    """The trees of the fixtures."""
    trees = sorted([*FIXTURES.glob("*/*/bad*"), *FIXTURES.glob("*/*/good*")])
    return tuple(tree for tree in trees if tree.is_dir())


def campaign(seconds: float, seed: int) -> None:
    registry = Registry.of()
    trees = files = 0
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        trees, files = trees + 1, files + attempt(seed, registry)[0]
        seed += 1
        if trees % 1_000 == 0:
            print(f"... {trees} trees, {files} files", flush=True)
    print(f"{trees} trees, {files} files")


if __name__ == "__main__":
    campaign(*(float(sys.argv[1]) if len(sys.argv) > 1 else 60.0, int(sys.argv[2]) if len(sys.argv) > 2 else 1))
