"""The version of a Python package that is another one in setup.py than in package.xml."""

from __future__ import annotations

import ast
from typing import TYPE_CHECKING

from bringup_lint.model.python import called_name
from bringup_lint.parsers import xml
from bringup_lint.parsers.python_syntax import Positions
from bringup_lint.parsers.python_syntax import byte_order_mark
from bringup_lint.parsers.python_syntax import tree_of
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.workspace import Package


def differing_version(package: Package) -> tuple[Located, Located] | None:
    """The version of setup.py, and the one of package.xml."""
    root = xml.parse(package.manifest.source).root
    declared = next((each.text for each in root.find_all("version")), None) if root is not None else None
    for build in package.builds:
        found = _of_setup(build.source) if declared and build.source.kind == "setup-py" else None
        if found is not None and declared is not None:
            return (found, declared) if _plain(found) != _plain(declared) else None
    return None


def _plain(version: str) -> str:
    """Python takes 1.0 for the same version as 1.0.0."""
    parts = version.strip().split(".")
    while len(parts) > 1 and parts[-1] == "0":
        parts.pop()
    return ".".join(parts)


def _of_setup(source: Source) -> Located | None:
    """What ``setup(version="...")`` says in plain words."""
    tree = tree_of(source)
    calls = [node for node in ast.walk(tree) if isinstance(node, ast.Call)] if tree is not None else []
    for given in (each for call in calls if called_name(call) == "setup" for each in call.keywords):
        if given.arg == "version" and isinstance(given.value, ast.Constant) and isinstance(given.value.value, str):
            return Located(given.value.value, Positions(source, byte_order_mark(source)).span(given.value))
    return None
