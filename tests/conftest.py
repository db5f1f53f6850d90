"""What all tests share: the flag that rewrites expected outputs, how long random inputs are tried, what is slow."""

from __future__ import annotations

import gc
import os
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pytest
from hypothesis import settings

PROJECT = Path(__file__).parent.parent
TOGETHER = ("tests/architecture/", "tests/packaging/", "tests/docs/test_rule_api.py", "tests/docs/test_site.py")
"""Tests that share what takes long to make: one process runs all of a place."""
MOST_AT_ONCE = 8

pytest_plugins = ["tests.browser"]

os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
sys.dont_write_bytecode = False  # the tests start many interpreters, which need not compile the same files again
os.environ["BRINGUP_LINT_NO_CACHE"] = "1"  # tests run the program, and do not read what an earlier test was told

settings.register_profile("dev", max_examples=25, deadline=None)
settings.register_profile("ci", max_examples=200, deadline=None)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "dev"))


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--update-expected", action="store_true", help="rewrite expected outputs; read the diff")


def pytest_configure(config: pytest.Config) -> None:
    """Campaigns take part where they may renew what is expected."""
    if config.getoption("--update-expected") and config.option.markexpr == "not campaign":
        config.option.markexpr = ""


def grouped(tests: Sequence[str]) -> dict[str, str]:
    """Test -> the group that a process gets at once: all of a place that belongs together, else a few tests, because
    each group costs a message, and all groups are counted again after each test."""
    most = min(MOST_AT_ONCE, len(tests) // 100 + 1)
    numbers = ((f"{number // most}", test) for number, test in enumerate(tests))
    return {test: next((place for place in TOGETHER if test.startswith(place)), number) for number, test in numbers}


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log: Any) -> object:
    """In place of ``--dist loadgroup``, whose groups pytest 9.2 no longer shows to xdist 3.8."""
    from xdist.scheduler import LoadScopeScheduling

    class Scheduling(LoadScopeScheduling):
        groups: dict[str, str] = {}

        def add_node_collection(self, node: Any, collection: Sequence[str]) -> None:
            super().add_node_collection(node, collection)
            self.groups = self.groups or grouped(collection)

        def _split_scope(self, nodeid: str) -> str:
            return self.groups[nodeid]

    return Scheduling(config, log)


def pytest_sessionstart(session: pytest.Session) -> None:
    """Make the index of the rules, so that all tests run with it, also where Python writes no byte code."""
    from bringup_lint.registry import builtin_folder
    from bringup_lint.rule_index.stored import index_of

    if not hasattr(session.config, "workerinput"):
        written, sys.dont_write_bytecode = sys.dont_write_bytecode, False
        index_of(builtin_folder())
        sys.dont_write_bytecode = written


def pytest_itemcollected(item: pytest.Item) -> None:
    if item.get_closest_marker("corpus") or item.get_closest_marker("campaign"):
        item.add_marker("slow")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """What is slow begins first, so that no process works alone at the end."""
    items.sort(key=lambda item: item.get_closest_marker("slow") is None)


def pytest_collection_finish() -> None:
    settle()
    gc.set_threshold(50_000, 20, 100)


def settle() -> None:
    """What is there now stays: no collection of garbage looks through it again."""
    gc.collect()
    gc.freeze()


@pytest.fixture(scope="module")
def settled() -> None:
    """For tests that collect garbage many times, as a check of a fleet does after each robot."""
    settle()


@pytest.fixture
def update_expected(request: pytest.FixtureRequest) -> bool:
    return request.config.getoption("--update-expected")


@pytest.fixture(scope="session")
def corpus() -> Path:
    folder = os.environ.get("BRINGUP_LINT_CORPUS")
    if not folder:
        pytest.skip("BRINGUP_LINT_CORPUS names no folder")
    return Path(folder)
