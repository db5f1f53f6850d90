"""Tests that use ``answers`` run twice: on what a real tool answered once, and on what the installed one says.

All of them are slow: a tool has thousands of answers. What needs only the record is marked ``recorded``, too; what
asks the tool for all of them again is a ``campaign``.
"""

from __future__ import annotations

import pytest

from tests.oracles.answers import Oracle


@pytest.fixture(params=["recorded", "real"])
def answers(request: pytest.FixtureRequest, update_expected: bool) -> Oracle:
    return Oracle(request.param == "real", update_expected)


def pytest_itemcollected(item: pytest.Item) -> None:
    item.add_marker("slow")
    parameters = item.callspec.params if hasattr(item, "callspec") else {}
    if parameters.get("answers") == "recorded":
        item.add_marker("recorded")
    if parameters.get("answers") == "real":
        item.add_marker("campaign")
