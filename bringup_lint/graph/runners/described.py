"""The runners of one file, found by a place in it without a look at all of them."""

from __future__ import annotations

from bisect import bisect_right
from itertools import accumulate

from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.runners.runner import Runner
    from bringup_lint.source import Source
    from bringup_lint.source import Span


class Described:
    """What a file says of runners: of some in one part of it, of others (the images that a Dockerfile makes) in all."""

    def __init__(self, source: Source, runners: list[Runner]) -> None:
        self._runners = runners
        self._whole: list[int] = []
        self._at: dict[Span, list[int]] = {}
        parts: list[tuple[int, int, int]] = []
        for number, runner in enumerate(runners):
            if runner.stage is not None and runner.stage.start.keyword.span.source is source:
                self._whole.append(number)
            elif runner.extent is not None:
                parts.append((runner.extent.start, runner.extent.end, number))
                self._at.setdefault(runner.where, []).append(number)
        self._parts = sorted(parts)
        self._starts = [start for start, _, _ in self._parts]
        self._furthest = list(accumulate((end for _, end, _ in self._parts), max))
        """For each part where the last of those up to it ends: parts may lie in each other."""

    def around(self, place: Span) -> list[Runner]:
        """The runners that the file describes at a place, in their order."""
        numbers = {*self._whole, *self._at.get(place, ())}
        index = bisect_right(self._starts, place.start) - 1
        while index >= 0 and self._furthest[index] > place.start:
            _, end, number = self._parts[index]
            if place.start < end:
                numbers.add(number)
            index -= 1
        return [self._runners[number] for number in sorted(numbers)]
