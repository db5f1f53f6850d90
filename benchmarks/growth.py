"""How the work grows with the size of one file: every kind of file, with every pattern repeated in it.

    python benchmarks/growth.py [--to MEBIBYTES] [--seconds SECONDS] [--part NUMBER/PARTS] [--all] [KIND]...

A file of the fixtures is filled with one of its own lines, or with a scrap that means something in some format, and
judged by all rules and written as text, SARIF and HTML. Its size grows eight times a step, from 16 KiB to 128 KiB and,
where that took longer than its share, on to 1 MiB and 8 MiB; ``--all`` takes every combination so far. A combination
that grows more than linearly, or that a budget of time ends, is printed with its times, and the script then fails. The
combinations come in a drawn order, so that what was tried when the script is stopped is a sample of all.
"""

from __future__ import annotations

import argparse
import os
import random
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple

PROJECT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(PROJECT))

from bringup_lint import budget  # noqa: E402
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
SCREENED = 128 * 1024
"""The size up to which every combination is tried."""
LARGEST = 8 * 1024 * 1024
STEP = 8
SEED = 12
SAMPLE = 2_500
"""Bytes of the file that is filled."""
LINES = 25
"""Lines of it that are tried."""
SLACK = 1.6
"""How much more than so many times the time a file of so many times the size may take."""
SUSPICION = 1.3
"""The same, before a combination is tried with larger files; what the file takes without its filling is left out."""
SUSPECTED = 0.06
"""CPU seconds, before growth is suspected."""
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


def judge(name: str, data: bytes, registry: Registry) -> bool:
    """Everything that a run does with one file; whether a budget of time ended a part of it."""
    robot = Robot(discover_text(name, data))
    outcome = run(robot, registry, Config(min_severity="info"))
    report = finish(outcome, robot, Invocation(("bringup-lint",), os.getcwd(), time.time()))
    for output_format in ("text", "sarif", "html"):
        render(output_format, report)
    return any(found.rule == "lint/time-budget" for found in outcome.findings)


class Times(NamedTuple):
    """What one combination took."""

    seconds: list[float]
    """CPU time for each step of the size; infinite where it never ended."""
    is_told: bool
    """Whether a budget of time ended the last one; an end after so many steps of work that the size allows is right."""


def times(each: Combination, registry: Registry, largest: int, most: float, *, whole: bool = False) -> Times:
    """Take a combination as far as its growth is worth it; budgets of ``most`` seconds must end it and say so."""
    found: list[float] = []
    size, told = SMALLEST, False
    alone = floor(each.name, each.text, registry)
    with budgets_of(most):
        while size <= largest and not told:
            started = time.process_time()
            try:
                with limited(8 * most):
                    told = judge(each.name, each.of(size), registry)
            except OutOfTime:
                return Times([*found, float("inf")], is_told=False)
            found.append(time.process_time() - started)
            if size >= SCREENED and not (whole or is_suspicious(found, alone)):
                break
            size *= STEP
    return Times(found, told and found[-1] >= most)


@contextmanager
def budgets_of(seconds: float) -> Iterator[None]:
    """Give a file, a rule and a run so many CPU seconds, and no more than they have anyway."""
    before = budget.FILE, budget.RULE, budget.RUN
    budget.FILE, budget.RULE, budget.RUN = (min(seconds, usual) for usual in before)
    try:
        yield
    finally:
        budget.FILE, budget.RULE, budget.RUN = before


_floors: dict[str, float] = {}


def floor(name: str, text: str, registry: Registry) -> float:
    """CPU seconds of the file that is filled, as it is."""
    if name not in _floors:
        taken = []
        for _ in range(3):
            started = time.process_time()
            judge(name, text.encode(), registry)
            taken.append(time.process_time() - started)
        _floors[name] = min(taken)
    return _floors[name]


def is_suspicious(found: list[float], alone: float = 0.0) -> bool:
    """Whether the last step took more than its share."""
    if len(found) < 2 or found[-1] < SUSPECTED:
        return False
    return found[-1] - alone > SUSPICION * STEP * max(found[-2] - alone, SUSPECTED / STEP / SUSPICION / 2)


def is_superlinear(found: list[float]) -> bool:
    """Whether the last step took more than it may; less than what is noticed means nothing."""
    if len(found) < 2 or found[-1] < NOTICED:
        return found[-1:] == [float("inf")]
    return found[-1] > SLACK * STEP * max(found[-2], NOTICED / STEP / SLACK)


def chosen(kinds: list[str], part: str) -> list[Combination]:
    """The combinations of some kinds, or of all, in a drawn order; of them, one part of several."""
    number, parts = map(int, part.split("/"))
    found = [each for each in sorted(combinations()) if not kinds or each.kind in kinds]
    random.Random(SEED).shuffle(found)
    return found[number - 1 :: parts]


def main() -> int:
    options = argparse.ArgumentParser()
    options.add_argument("--to", type=float, default=LARGEST / 1024 / 1024, help="size of the largest file, in MiB")
    options.add_argument("--seconds", type=float, default=20, help="CPU seconds that a file, a rule and a run may take")
    options.add_argument("--part", default="1/1", help="one part of so many, such as 1/2")
    options.add_argument("--all", action="store_true", help="take every combination to the largest size")
    options.add_argument("kinds", nargs="*")
    asked = options.parse_args()
    registry = Registry.of()
    failed = 0
    largest = int(asked.to * 1024 * 1024)
    every = chosen(asked.kinds, asked.part)
    for tried, each in enumerate(every, 1):
        found = times(each, registry, largest, asked.seconds, whole=asked.all)
        grows = is_superlinear(found.seconds) and is_superlinear(
            times(each, registry, largest, asked.seconds, whole=asked.all).seconds
        )
        is_over = found.is_told and found.seconds[-1] >= asked.seconds  # else a parser counted its steps, as it should
        if grows or is_over:
            failed += 1
            shown = " ".join(f"{seconds:.2f}" for seconds in found.seconds)
            told = ", and a budget ended it" if is_over else ""
            print(f"{each.kind}: {each.unit!r} in {each.name}: {shown} s{told}", flush=True)
        if tried % 100 == 0:
            print(f"... {tried} of {len(every)}", flush=True)
    print(f"{len(every)} combinations, {failed} grow more than linearly or take too long")
    return int(failed > 0)


if __name__ == "__main__":
    sys.exit(main())
