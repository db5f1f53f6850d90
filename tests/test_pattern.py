"""Patterns that are compiled late answer as compiled ones."""

from __future__ import annotations

import re

import pytest
from hypothesis import HealthCheck
from hypothesis import given
from hypothesis import settings
from hypothesis import strategies

from bringup_lint.pattern import Uncompiled
from bringup_lint.pattern import regex
from bringup_lint.registry import Registry
from tests.architecture.test_patterns import modules
from tests.architecture.test_patterns import of_rules

MANY = 40


def hinted() -> dict[str, Uncompiled]:
    spaces = [*map(vars, modules()), *of_rules(), {"mentions": tuple(each.mentions for each in Registry.of().families)}]
    values = (value for space in spaces for value in list(space.values()))
    flat = (each for value in values for each in (value if isinstance(value, tuple) else (value,)))
    flat = (each for value in flat for each in (value if isinstance(value, tuple) else (value,)))
    return {each.pattern: each for each in flat if isinstance(each, Uncompiled) and each.hints}


def test_what_holds_no_hint_does_not_match() -> None:
    pattern = regex(r"(\w+)\.d/", re.I, "d/")
    for at in range(MANY):
        assert pattern.search(f"file{at}.conf") is None
        assert pattern.search("/etc/NetworkManager/conf.D/wifi")[1] == "conf"
        assert pattern.match("a.d/", 1) is None


def test_a_long_text_without_a_hint_is_not_searched() -> None:
    pattern = regex(r"\bspin(?:_once)?\b", hints="spin")
    for text in ("import rclpy\n" * MANY, "°" * 500):
        assert [pattern.search(text), *pattern.finditer(text), *pattern.findall(text)] == [None]
        assert pattern.search(text + "spin_once")[0] == "spin_once"
        assert [each[0] for each in pattern.finditer(text + " spin")] == pattern.findall(text + " spin") == ["spin"]
        assert pattern.search(text + " spin", len(text)) and not pattern.search(text + " spin", 0, len(text))


def test_a_text_of_other_letters_is_searched() -> None:
    for text in ("wıfi", "wıfi" * 200):
        assert regex("wifi", re.I, "wifi").search(text) is not None
    assert regex("wifi", re.I, "wifi").search("é WiFi" * 200) is not None


@pytest.mark.slow
def test_all_that_a_pattern_matches_holds_a_hint() -> None:
    found = hinted()
    assert len(found) > 30
    for pattern in found.values():
        holds_a_hint(pattern)


def holds_a_hint(pattern: Uncompiled) -> None:
    hints = pattern.hints.split()

    @settings(max_examples=30, derandomize=True, deadline=None, database=None, suppress_health_check=list(HealthCheck))
    @given(strategies.from_regex(re.compile(pattern.pattern, pattern.flags | re.A)))
    def check(text: str) -> None:
        said = text.lower() if pattern.flags & re.I else text
        assert any(hint in said for hint in hints), (pattern.pattern, text)

    check()
