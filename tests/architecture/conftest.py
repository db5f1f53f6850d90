"""The tests of the architecture look at the syntax of all files."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from tests.architecture.imports import nodes
from tests.architecture.imports import syntax


@pytest.fixture(scope="package", autouse=True)
def syntax_is_forgotten() -> Iterator[None]:
    """A million nodes, that every collection of garbage would look through."""
    yield
    syntax.cache_clear()
    nodes.cache_clear()
