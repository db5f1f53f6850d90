"""What every layer may ask of the files."""

from __future__ import annotations

import re

import pytest

from bringup_lint.budget import OutOfTime
from bringup_lint.discover.tree import Tree
from bringup_lint.graph.files import Files
from bringup_lint.source import Source

REBOOTS = re.compile(r"\breboot\b")


def test_a_source_that_joins_later_is_searched_for_what_was_asked_before() -> None:
    files = Files(Tree(sources=[Source("a.sh", "ls\n", kind="shell-script")]))
    assert not files.mentions(REBOOTS)
    files.join(Source("b.sh", "reboot\n", kind="shell-script"))
    assert files.mentions(REBOOTS)


class Model:
    pass


def read(source: Source) -> Model:
    return Model()


def test_what_several_layers_ask_for_is_parsed_once() -> None:
    files = Files(Tree(sources=[Source("a.py", kind="python-node"), Source("b.py", kind="python-node")]))
    assert files.parsed(read, files.sources) == files.parsed(read, files.sources)


def test_no_timer_is_set_for_what_is_parsed_already(monkeypatch: pytest.MonkeyPatch) -> None:
    files = Files(Tree(sources=[Source("a.py", kind="python-node")]))
    files.parsed(read, files.sources)
    set_for: list[float] = []
    monkeypatch.setattr("bringup_lint.graph.files.limited", set_for.append)
    files.parsed(read, files.sources)
    assert not set_for


def test_a_parser_that_ran_out_of_time_is_not_asked_again() -> None:
    asked = []

    def endless(source: Source) -> Model:
        asked.append(source)
        raise OutOfTime

    source = Source("a.sh", "ls\n", kind="shell-script")
    files = Files(Tree(sources=[source]))
    assert files.parsed(endless, [source]) == files.parsed(endless, [source]) == []
    assert asked == files.unfinished == [source]
