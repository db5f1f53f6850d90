"""Tests that use ``answers`` run twice: on what a real tool answered once, and on what the installed one says."""

from __future__ import annotations

import pytest

from tests.oracles.answers import Oracle


@pytest.fixture(params=["recorded", pytest.param("real", marks=pytest.mark.slow)])
def answers(request: pytest.FixtureRequest, update_expected: bool) -> Oracle:
    return Oracle(request.param == "real", update_expected)
