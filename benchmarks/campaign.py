"""Both campaigns at once, for one commit: broken trees in all formats, and broken texts through the parsers.

    python benchmarks/campaign.py [TREES] [CASES] [SEED]

The program and the fixtures are loaded once; forked children do the work, so that what one of them keeps, or how it
dies, costs no other. Prints each failure with the seed that makes it again, and what was done so far.
"""

from __future__ import annotations

import gc
import json
import os
import sys
import time
from collections.abc import Callable
from pathlib import Path

PROJECT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(PROJECT))

from benchmarks import mutations  # noqa: E402
from benchmarks import parsers  # noqa: E402
from bringup_lint.registry import Registry  # noqa: E402

TREES_AT_ONCE = 200
CASES_AT_ONCE = 10_000
SHORT = 6_000
"""Characters of the texts that are broken, where a kind has such: what fails on a long one mostly fails on these."""

Work = Callable[[int], "tuple[int, int, int]"]
"""First seed -> how much was done, how many failures, and the next seed."""


def trees(registry: Registry) -> Work:
    def work(seed: int) -> tuple[int, int, int]:
        failed = sum(mutations.attempt(each, registry)[1] for each in range(seed, seed + TREES_AT_ONCE))
        return TREES_AT_ONCE, failed, seed + TREES_AT_ONCE

    return work


def cases() -> Work:
    readers, sources = parsers.seen()
    kinds = sorted(readers.keys() & sources.keys())
    short = {kind: [each for each in sources[kind] if len(each.text) < SHORT] or sources[kind] for kind in kinds}

    def work(seed: int) -> tuple[int, int, int]:
        done = failed = 0
        while done < CASES_AT_ONCE:
            count, failures = parsers.attempt(seed, kinds, readers, short)
            done, failed, seed = done + count, failed + failures, seed + 1
        return done, failed, seed

    return work


def in_child(work: Work, seed: int) -> tuple[int, int, int]:
    """Do the work in a child; one that dies counts as a failure, and its seeds are left out."""
    read, write = os.pipe()
    child = os.fork()
    if not child:
        os.write(write, json.dumps(work(seed)).encode())
        os._exit(0)
    os.close(write)
    with os.fdopen(read, "rb") as pipe:
        said = pipe.read()
    _, status = os.waitpid(child, 0)
    if not said:
        print(f"seed {seed}: the child ended with {status}", flush=True)
        return 0, 1, seed + TREES_AT_ONCE
    done, failed, following = json.loads(said)
    return done, failed, following


def campaign(most_trees: int, most_cases: int, seed: int) -> int:
    """Both in step; returns how much failed."""
    work = {"trees": trees(Registry.of()), "cases": cases()}
    most = {"trees": most_trees, "cases": most_cases}
    done, seeds = dict.fromkeys(work, 0), dict.fromkeys(work, seed)
    failed = 0
    gc.collect()
    gc.freeze()
    started = time.monotonic()
    while left := [name for name in work if done[name] < most[name]]:
        name = min(left, key=lambda name: done[name] / most[name])
        count, failures, seeds[name] = in_child(work[name], seeds[name])
        done[name] += count
        failed += failures
        said = f"{done['trees']} trees, {done['cases']} cases, {failed} failures, {time.monotonic() - started:.0f} s"
        print(said, flush=True)
    return failed


if __name__ == "__main__":
    numbers = [int(word) for word in sys.argv[1:]]
    sys.exit(campaign(*numbers, *(20_000, 1_000_000, 1)[len(numbers) :]) > 0)
