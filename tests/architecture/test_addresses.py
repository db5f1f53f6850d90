"""What an address is, is answered in one place."""

from __future__ import annotations

import ast
from pathlib import Path

from tests.architecture.imports import PACKAGE
from tests.architecture.imports import nodes
from tests.architecture.imports import paths
from tests.conftest import PROJECT

READER = PACKAGE / "addresses.py"


def imported(path: Path) -> set[str]:
    return {each.name for node in nodes(path) if isinstance(node, ast.Import) for each in node.names}


def test_only_one_module_reads_addresses() -> None:
    files = [*paths(), *sorted(PROJECT.glob("rules/*/*.py"))]
    assert [path for path in files if imported(path) & {"ipaddress", "socket"}] == [READER]
