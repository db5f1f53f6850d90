"""A rule's tests are selected by its id (``-k no-tabs``) and by the name of its file (``-k no_tabs``)."""

from __future__ import annotations

import pytest


def pytest_itemcollected(item: pytest.Item) -> None:
    for word in item.name.split("["):
        item.extra_keyword_matches.add(word.replace("-", "_"))
