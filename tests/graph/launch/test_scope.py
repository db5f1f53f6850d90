"""What is known of the environment after changes that may happen, and of processes that start later."""

from __future__ import annotations

from bringup_lint.graph.launch.scope import EnvChange
from bringup_lint.graph.launch.scope import EnvChanges
from bringup_lint.graph.launch.scope import later
from bringup_lint.graph.launch.scope import perhaps
from bringup_lint.source import Source


def change(letter: str) -> EnvChange:
    return EnvChange(None, "SetEnvironmentVariable", Source(letter, letter).span(0, 1))


ONE, TWO, THREE = map(change, "abc")


def shown(changes: EnvChanges) -> str:
    """The letters of the changes; a question mark follows those that may not happen."""
    return " ".join(each.span.text + ("" if each.certain else "?") for each in changes)


def after(before: dict[str, EnvChanges], now: dict[str, EnvChanges]) -> dict[str, str]:
    return {name: shown(changes) for name, changes in perhaps(before, now).items()}


def test_what_is_not_changed_stays_certain() -> None:
    same = (ONE, TWO)
    assert after({"A": same}, {"A": same}) == {"A": "a b"}


def test_what_is_added_is_doubtful() -> None:
    assert after({}, {"A": (ONE,)}) == {"A": "a?"}
    assert after({"A": (ONE,)}, {"A": (ONE, TWO)}) == {"A": "a b?"}


def test_what_replaces_is_doubtful_and_what_was_before_stays() -> None:
    assert after({"A": (ONE,)}, {"A": (TWO,)}) == {"A": "a b?"}


def test_what_may_be_reset_is_doubtful_in_the_end() -> None:
    assert after({"A": (ONE, TWO)}, {}) == {"A": "a b b?"}


def started_later(
    env: dict[str, EnvChanges], before: dict[str, EnvChanges], now: dict[str, EnvChanges], *unsure: str
) -> dict[str, str]:
    return {name: shown(changes) for name, changes in later(env, before, now, set(unsure)).items()}


def test_what_the_timer_left_alone_is_as_it_is_in_the_end() -> None:
    seen = (ONE,)
    assert started_later({"A": seen}, {"A": seen}, {"A": (ONE, TWO)}) == {"A": "a b"}
    assert started_later({"A": seen}, {"A": seen}, {}) == {}
    assert started_later({}, {}, {"A": (TWO,)}) == {"A": "b"}


def test_what_the_timer_changed_itself_counts() -> None:
    assert started_later({"A": (ONE, THREE)}, {"A": (ONE,)}, {"A": (TWO,)}) == {"A": "a c"}


def test_what_another_timer_changes_is_doubtful() -> None:
    seen = (ONE,)
    assert started_later({"A": seen}, {"A": seen}, {"A": (TWO,)}, "A") == {"A": "b? a?"}
    assert started_later({"A": seen}, {"A": seen}, {"A": (TWO,)}, "B") == {"A": "b"}
