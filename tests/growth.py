"""Whether some work grows as what it works on does: a ratio of times within one run, never a duration."""

from __future__ import annotations

import time
from collections.abc import Callable

TIMES = 8
"""How much larger the large one must be than the small one."""
LINEAR = 3.0
"""How much more than linear the growth may be: a quadratic one is eight times as much."""
NOTICED = 0.02
"""CPU seconds that the large one must take, before growth means something."""
ROUNDS = 4


def seconds(work: Callable[[], object]) -> float:
    """CPU seconds of this process."""
    started = time.process_time()
    work()
    return time.process_time() - started


def excess(work: Callable[[int], object], small: int) -> float:
    """How much more than linear the work grows from a size to eight times as much; 1 is linear, and 0 is said when
    nobody would notice. Each size counts with the least time of several rounds, which a busy machine cannot shorten."""
    least, most = float("inf"), float("inf")
    ratio = 0.0
    for _ in range(ROUNDS):
        least = min(least, seconds(lambda: work(small)))
        most = min(most, seconds(lambda: work(small * TIMES)))
        ratio = most / TIMES / max(least, NOTICED / TIMES / LINEAR)
        if most < NOTICED or ratio <= LINEAR:
            break
    return 0.0 if most < NOTICED else ratio


def is_linear(work: Callable[[int], object], small: int) -> bool:
    return excess(work, small) <= LINEAR
