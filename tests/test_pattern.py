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
from tests.architecture.test_patterns import modules

MANY = 40


def hinted() -> dict[str, Uncompiled]:
    values = (value for module in modules() for value in list(vars(module).values()))
    flat = (each for value in values for each in (value if isinstance(value, tuple) else (value,)))
    flat = (each for value in flat for each in (value if isinstance(value, tuple) else (value,)))
    return {each.pattern: each for each in flat if isinstance(each, Uncompiled) and each.hints}


def test_what_holds_no_hint_does_not_match() -> None:
    pattern = regex(r"(\w+)\.d/", re.I, "d/")
    for at in range(MANY):
        assert pattern.search(f"file{at}.conf") is None
        assert pattern.search("/etc/NetworkManager/conf.D/wifi")[1] == "conf"
        assert pattern.match("a.d/", 1) is None


def test_a_text_of_other_letters_is_searched() -> None:
    assert regex("wifi", re.I, "wifi").search("wıfi") is not None


@pytest.mark.slow
def test_all_that_a_pattern_matches_holds_a_hint() -> None:
    found = hinted()
    assert len(found) > 30
    for pattern in found.values():
        holds_a_hint(pattern)


def holds_a_hint(pattern: Uncompiled) -> None:
    hints = pattern.hints.split()

    @settings(max_examples=60, deadline=None, database=None, suppress_health_check=list(HealthCheck))
    @given(strategies.from_regex(re.compile(pattern.pattern, pattern.flags | re.A)))
    def check(text: str) -> None:
        said = text.lower() if pattern.flags & re.I else text
        assert any(hint in said for hint in hints), (pattern.pattern, text)

    check()
