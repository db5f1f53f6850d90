"""A kind of file whose name is misspelt is one that no file has."""

from __future__ import annotations

import ast

import pytest

from bringup_lint.discover.kinds import kinds
from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.discover.starters import STARTING
from bringup_lint.registry import Family
from bringup_lint.registry import builtin_folder
from bringup_lint.registry import families
from tests.conftest import PROJECT

NAMES = {kind.name for kind in kinds()}
WITHOUT_FILES = {"fleet", "observed-graph", "python-program"}
"""What families read that is no file of a robot."""
PROFILES = {"participant"}
"""What configurations of Fast DDS are asked for by a method of the same name."""
FILES = [*PROJECT.glob("bringup_lint/**/*.py"), *PROJECT.glob("rules/*/*.py")]


def test_sources_are_asked_for_by_known_kinds() -> None:
    found = {
        (path.name, argument.value)
        for path in FILES
        for call in ast.walk(ast.parse(path.read_text("utf-8")))
        if isinstance(call, ast.Call) and isinstance(call.func, ast.Attribute) and call.func.attr == "of_kind"
        for argument in call.args
        if isinstance(argument, ast.Constant)
    }
    assert {each for each in found if each[1] not in NAMES | PROFILES} == set()


@pytest.mark.parametrize("family", families([builtin_folder()]), ids=lambda family: family.name)
def test_families_read_known_kinds(family: Family) -> None:
    assert family.reads.union(*family.joins.values()) <= NAMES | WITHOUT_FILES


def test_lists_hold_known_kinds() -> None:
    assert NAMES.issuperset((*STARTING, *LAUNCH))
