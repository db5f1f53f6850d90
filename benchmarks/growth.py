"""How the work grows with the size of one file: every kind of file, with every pattern repeated in it.

    python benchmarks/growth.py [--to MEBIBYTES] [--seconds SECONDS] [KIND]...

A file of the fixtures is filled with one of its own lines, or with a scrap that means something in some format, and
judged by all rules and written as text, SARIF and HTML. Its size doubles from 16 KiB to 8 MiB, or until one run takes
too long. A combination that grows more than linearly is printed with its times, and the script then fails.
"""

from __future__ import annotations

import argparse
import os
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

PROJECT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(PROJECT))

from bringup_lint.budget import OutOfTime  # noqa: E402
from bringup_lint.budget import limited  # noqa: E402
from bringup_lint.config import Config  # noqa: E402
from bringup_lint.discover.kinds import HEAD_SIZE  # noqa: E402
from bringup_lint.discover.kinds import kind_of  # noqa: E402
from bringup_lint.discover.walk import discover_text  # noqa: E402
from bringup_lint.engine import run  # noqa: E402
from bringup_lint.finish import Invocation  # noqa: E402
from bringup_lint.finish import finish  # noqa: E402
from bringup_lint.registry import Registry  # noqa: E402
from bringup_lint.report import render  # noqa: E402
from bringup_lint.robot import Robot  # noqa: E402

FIXTURES = PROJECT / "fixtures"
SMALLEST = 16 * 1024
LARGEST = 8 * 1024 * 1024
SAMPLE = 2_500
"""Bytes of the file that is filled."""
LINES = 25
"""Lines of it that are tried."""
SLACK = 1.6
"""How much more than twice the time a file of twice the size may take, each of the last two times."""
NOTICED = 0.4
"""CPU seconds, before growth means something."""
SCRAPS = (
    *(
        "{{",
        "{% ",
        "[",
        "<",
        "(",
        "{",
        '"',
        "'",
        "$(",
        "${a}",
        "%",
        "\\",
        ",",
        ";",
        "/",
        "../",
        "a",
        "9",
        "=",
        ":",
        "*",
    ),
    *(" ", "\t", "\n", "\r", "\\\n", "a b ", "a=b ", "a=b\n", "- a\n", "a:\n", "a: b\n", "[a]\n", "#\n", "# c\n"),
    *("<a>", "<a/>\n", "<!-- ", "<!-- c -->\n", "<![CDATA[", "&amp;", "<<E\n", "&a ", "*a ", "--a ", "é", "\u2028"),
    *(
        "password=",
        "token: ",
        "://a:b@",
        "# bringup-lint: ignore[",
        "# bringup-lint: ignore[a]: b\n",
        "def f(): pass\n",
    ),
)


class Combination(NamedTuple):
    kind: str
    name: str
    text: str
    unit: str
    """What is repeated."""

    def of(self, size: int) -> bytes:
        """The file with so many bytes, filled before its last end tag, else at its end."""
        at = self.text.rfind("</")
        at = len(self.text) if at < 0 else at
        filling = self.unit * (size // len(self.unit.encode()))
        return (self.text[:at] + filling + self.text[at:]).encode()


def combinations() -> Iterator[Combination]:
    for kind, (name, text) in sorted(samples().items()):
        lines = list(dict.fromkeys(line + "\n" for line in text.split("\n") if line.strip()))[:LINES]
        yield from (Combination(kind, name, text, unit) for unit in (*SCRAPS, *lines))


def samples() -> dict[str, tuple[str, str]]:
    """Kind -> the name and text of the longest short file of the fixtures."""
    found: dict[str, tuple[str, str]] = {}
    for path in sorted(FIXTURES.rglob("*")):
        if not path.is_file() or path.is_symlink() or path.stat().st_size > SAMPLE:
            continue
        name = str(Path(*path.relative_to(FIXTURES).parts[3:])) or path.name
        text = path.read_bytes().decode("utf-8", "replace")
        kind = kind_of(name, lambda text=text: text[:HEAD_SIZE])  # type: ignore[misc]
        if kind and len(text) > len(found.get(kind, ("", ""))[1]):
            found[kind] = (name, text)
    return found


def judge(name: str, data: bytes, registry: Registry) -> None:
    """Everything that a run does with one file."""
    robot = Robot(discover_text(name, data))
    outcome = run(robot, registry, Config(min_severity="info"))
    report = finish(outcome, robot, Invocation(("bringup-lint",), os.getcwd(), time.time()))
    for output_format in ("text", "sarif", "html"):
        render(output_format, report)


def times(each: Combination, registry: Registry, largest: int, most: float) -> list[float]:
    """CPU seconds for each doubling of the size; infinite where the budget ends."""
    found: list[float] = []
    size = SMALLEST
    while size <= largest and (not found or found[-1] < most / 2):
        started = time.process_time()
        try:
            with limited(8 * most):
                judge(each.name, each.of(size), registry)
        except OutOfTime:
            return [*found, float("inf")]
        found.append(time.process_time() - started)
        size *= 2
    return found


def is_superlinear(found: list[float]) -> bool:
    """Whether the last two doublings took more than they may; one of them is not enough on a busy machine."""
    if len(found) < 3 or found[-1] < NOTICED:
        return found[-1:] == [float("inf")]
    return found[-1] > 2 * SLACK * found[-2] or found[-1] > 4 * SLACK * found[-3]


def main() -> int:
    options = argparse.ArgumentParser()
    options.add_argument("--to", type=float, default=LARGEST / 1024 / 1024, help="size of the largest file, in MiB")
    options.add_argument("--seconds", type=float, default=20, help="CPU seconds after which a file is large enough")
    options.add_argument("kinds", nargs="*")
    asked = options.parse_args()
    registry = Registry.of()
    tried = failed = 0
    for each in combinations():
        if asked.kinds and each.kind not in asked.kinds:
            continue
        largest, tried = int(asked.to * 1024 * 1024), tried + 1
        found = times(each, registry, largest, asked.seconds)
        if is_superlinear(found) and is_superlinear(times(each, registry, largest, asked.seconds)):
            failed += 1
            shown = " ".join(f"{seconds:.2f}" for seconds in found)
            print(f"{each.kind}: {each.unit!r} in {each.name}: {shown} s", flush=True)
    print(f"{tried} combinations, {failed} grow more than linearly")
    return int(failed > 0)


if __name__ == "__main__":
    sys.exit(main())
