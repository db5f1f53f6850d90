"""What fails after the rules costs the finding on which it fails: a ``lint/internal-error`` takes its place."""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator
from collections.abc import Sequence

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.finding import Finding
from bringup_lint.isolation import internal
from bringup_lint.source import Source
from bringup_lint.type_names import TypeVar

T = TypeVar("T")


@dataclass
class Steps:
    """The steps from what rules found to a report, and what failed in them."""

    failures: list[Finding] = field(default_factory=list)
    """All of them."""
    unplaced: list[Finding] = field(default_factory=list)
    """Those that took the place of no finding."""

    def each(self, findings: Iterable[Finding], what: str, step: Callable[[Finding], Finding]) -> Iterator[Finding]:
        """The findings after a step that looks at one at a time."""
        for found in findings:
            try:
                yield step(found)
            except Exception as error:
                yield self.instead(found, what, error)

    def each_sound(
        self, findings: Sequence[Finding], what: str, step: Callable[[Sequence[Finding]], object]
    ) -> tuple[Finding, ...]:
        """The findings with which a step over all of them does not fail."""
        broken = {id(found): error for found, error in failing(findings, step)}
        return tuple(
            found if id(found) not in broken else self.instead(found, what, broken[id(found)]) for found in findings
        )

    def instead(self, found: Finding, what: str, error: Exception) -> Finding:
        """The finding that takes the place of another one. It shows nothing of the file."""
        failure = internal(Source(found.source.name), f"{what} a finding of {found.rule}", error)
        self.failures.append(failure)
        return failure

    def attempt(self, what: str, step: Callable[[], T], otherwise: T) -> T:
        """The result of a step that is about no finding, or what to go on with when it fails."""
        try:
            return step()
        except Exception as error:
            self.note_failure(Source("bringup-lint"), what, error)
            return otherwise

    def note_failure(self, source: Source, what: str, error: Exception) -> None:
        """Keep what failed on a source, or on the run as a whole."""
        failure = internal(source, what, error)
        self.failures.append(failure)
        self.unplaced.append(failure)


def failing(items: Sequence[T], step: Callable[[Sequence[T]], object]) -> Iterator[tuple[T, Exception]]:
    """The items with which a step fails, found by halving."""
    if not items:
        return
    try:
        step(items)
    except Exception as error:
        if len(items) == 1:
            yield items[0], error
            return
        middle = len(items) // 2
        yield from failing(items[:middle], step)
        yield from failing(items[middle:], step)
