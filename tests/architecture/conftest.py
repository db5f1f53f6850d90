"""One process runs the tests of the architecture, which all look at the syntax of all files."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from tests.architecture.imports import syntax


def pytest_itemcollected(item: pytest.Item) -> None:
    if not item.get_closest_marker("slow"):
        item.add_marker(pytest.mark.xdist_group("architecture"))


@pytest.fixture(scope="package", autouse=True)
def syntax_is_forgotten() -> Iterator[None]:
    """A million nodes, that every collection of garbage would look through."""
    yield
    syntax.cache_clear()
