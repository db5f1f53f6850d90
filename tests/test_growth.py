"""The judgement of growth itself."""

from __future__ import annotations

import re

from tests.growth import is_linear


def test_linear_work_is_linear() -> None:
    assert is_linear(lambda size: sorted(range(size)), 20_000)
    assert is_linear(lambda size: sum(number * number for number in range(size)), 20_000)


def test_quadratic_work_is_noticed() -> None:
    assert not is_linear(lambda size: [number for number in range(size) for _ in range(size)], 200)
    assert not is_linear(lambda size: re.search(r"\{\{.*?\}\}", "{{" * size), 500)


def test_work_that_nobody_would_notice_is_linear() -> None:
    assert is_linear(lambda size: [number for number in range(size) for _ in range(size)], 1)
