"""A boolean of a unit is asked with ``Unit.flag``: ``Unit.get`` gives its text, which is true for ``no`` too."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

from bringup_lint.facts import table
from tests.architecture.imports import nodes
from tests.conftest import PROJECT

FILES = sorted([*PROJECT.glob("rules/*/*.py"), *PROJECT.glob("bringup_lint/graph/**/*.py")])
BOOLEANS = frozenset(row["key"] for row in table("systemd/directives") if row["type"] == "bool")


def booleans_as_text(path: Path) -> Iterator[str]:
    for node in nodes(path):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr in ("get", "has"):
            for argument in node.args[:1]:
                if isinstance(argument, ast.Constant) and argument.value in BOOLEANS:
                    yield f"{path.parent.name}/{path.name}:{node.lineno} {argument.value}"


def test_the_tables_know_booleans() -> None:
    assert {"RemainAfterExit", "DynamicUser", "DefaultDependencies", "PrivateDevices"} <= BOOLEANS


def test_no_boolean_is_taken_for_text() -> None:
    assert [place for path in FILES for place in booleans_as_text(path)] == []
