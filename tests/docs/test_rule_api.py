"""The page on what a rule may ask says what the code says."""

from __future__ import annotations

import pytest

from tests.docs.rule_api import PAGE
from tests.docs.rule_api import page


@pytest.mark.slow
def test_page_is_current(update_expected: bool) -> None:
    if update_expected:
        PAGE.write_text(page(), "utf-8")
    assert PAGE.read_text("utf-8") == page(), "pytest tests/docs/test_rule_api.py --update-expected renews it"


def test_page_shows_the_layers_with_their_types() -> None:
    text = page()
    assert "### `robot.units: Units`" in text
    assert "## `bringup_lint.api.systemd`" in text
    assert "Example, [" in text
