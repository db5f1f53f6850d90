"""A campaign against the parsers alone: broken texts of the fixtures, each through every parser that reads its kind.

    python benchmarks/parsers.py [CASES] [SEED]

Which parsers read a kind is seen in a run over the fixtures. Counts the cases, one text through one parser each, and
prints each failure with the seed that makes it again.
"""

from __future__ import annotations

import random
import sys
import time
from collections import defaultdict
from collections.abc import Callable
from functools import partial
from pathlib import Path

PROJECT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(PROJECT))

from bringup_lint.budget import OutOfTime  # noqa: E402
from bringup_lint.budget import limited  # noqa: E402
from bringup_lint.config import Config  # noqa: E402
from bringup_lint.discover.walk import discover  # noqa: E402
from bringup_lint.engine import run  # noqa: E402
from bringup_lint.graph.files import Files  # noqa: E402
from bringup_lint.registry import Registry  # noqa: E402
from bringup_lint.robot import Robot  # noqa: E402
from bringup_lint.source import Source  # noqa: E402
from tests.scenarios.test_mutated_trees import mutated  # noqa: E402

SLOW = 5.0
"""CPU seconds in which a parser must be done with a text."""
LONGEST = 100_000
"""Characters of a text."""
Parser = Callable[[Source], object]


def seen() -> tuple[dict[str, set[Parser]], dict[str, list[Source]]]:
    """The parsers of each kind, and the sources of each kind, over all fixtures."""
    parsers: dict[str, dict[object, Parser]] = defaultdict(dict)
    sources: dict[str, list[Source]] = defaultdict(list)
    plain = Files.parsed

    def noted(self: Files, parse: Parser, asked: list[Source]) -> list[object]:
        asked = list(asked)
        for source in asked:
            parsers[source.kind].setdefault(_identity(parse), parse)
        return plain(self, parse, asked)

    Files.parsed = noted  # type: ignore[assignment, method-assign]
    registry = Registry.of()
    for tree in sorted([*(PROJECT / "fixtures").glob("*/*/bad*"), *(PROJECT / "fixtures").glob("*/*/tree")]):
        robot = Robot(discover((str(tree),)))
        run(robot, registry, Config(min_severity="info"))
        for source in robot.sources:
            if source.kind and len(source.text) < LONGEST:
                sources[source.kind].append(source)
    Files.parsed = plain  # type: ignore[method-assign]
    return {kind: set(known.values()) for kind, known in parsers.items()}, dict(sources)


def _identity(parse: Parser) -> object:
    """What makes a parser another one: each tree makes its own of the same code."""
    if isinstance(parse, partial):
        return parse.func, repr(parse.keywords)
    return getattr(parse, "__code__", parse)


def name_of(parse: Parser) -> str:
    """A parser with arguments that it got before goes by the name of its function."""
    function = parse.func if isinstance(parse, partial) else parse
    return f"{function.__module__}.{function.__qualname__}"


def failure(parse: Parser, source: Source) -> str:
    """What a parser fails with; empty when it does not."""
    try:
        with limited(SLOW):
            parse(source)
    except Exception as error:
        return repr(error)
    except OutOfTime:
        return f"takes more than {SLOW:.0f} s"
    return ""


def attempt(
    seed: int, kinds: list[str], parsers: dict[str, set[Parser]], sources: dict[str, list[Source]]
) -> tuple[int, int]:
    """Break a text and give it to the parsers of its kind; how many these are, and how many failed."""
    chance = random.Random(seed)
    kind = chance.choice(kinds)
    model = chance.choice(sources[kind])
    source = Source(model.name, mutated(model.text, chance), kind)
    failed = 0
    for parse in parsers[kind]:
        said = failure(parse, source)
        if said:
            failed += 1
            print(f"seed {seed}: {name_of(parse)} on {model.name}: {said}", flush=True)
    return len(parsers[kind]), failed


def campaign(cases: int, seed: int) -> None:
    parsers, sources = seen()
    kinds = sorted(set(parsers) & set(sources))
    print(f"{len(kinds)} kinds, {sum(map(len, parsers.values()))} pairs of kind and parser", flush=True)
    done = failed = 0
    started = time.monotonic()
    while done < cases:
        count, failures = attempt(seed, kinds, parsers, sources)
        done, failed = done + count, failed + failures
        seed += 1
        if seed % 20_000 == 0:
            print(f"... {done} cases in {time.monotonic() - started:.0f} s, up to seed {seed}", flush=True)
    print(f"{done} cases, {failed} failures, seeds up to {seed}")


if __name__ == "__main__":
    campaign(int(sys.argv[1]) if len(sys.argv) > 1 else 10_000, int(sys.argv[2]) if len(sys.argv) > 2 else 1)
