"""What an address is, is answered in one place."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

from tests.architecture.imports import PACKAGE
from tests.architecture.imports import paths
from tests.architecture.imports import syntax
from tests.conftest import PROJECT

READER = PACKAGE / "addresses.py"


@pytest.mark.parametrize("path", [*paths(), *sorted(PROJECT.glob("rules/*/*.py"))], ids=str)
def test_only_one_module_reads_addresses(path: Path) -> None:
    imported = {each.name for node in ast.walk(syntax(path)) if isinstance(node, ast.Import) for each in node.names}
    assert path == READER or not imported & {"ipaddress", "socket"}
