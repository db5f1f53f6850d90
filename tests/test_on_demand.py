"""Modules that import what they offer when it is asked for."""

from __future__ import annotations

import importlib
import subprocess
import sys

import pytest

from tests.conftest import PROJECT

MODULES = sorted(path.stem for path in (PROJECT / "bringup_lint/api").glob("[a-z]*.py"))


@pytest.mark.parametrize("name", MODULES)
def test_a_module_has_all_that_it_offers(name: str) -> None:
    module = importlib.import_module(f"bringup_lint.api.{name}")
    assert all(hasattr(module, each) for each in getattr(module, "__all__", ()))
    assert not hasattr(module, "no_such_name")


def test_what_is_not_asked_for_is_not_imported() -> None:
    code = """
import sys
from bringup_lint.api.systemd import duration
assert duration(5) == "5 s"
assert "bringup_lint.graph.systemd.units" not in sys.modules
try:
    from bringup_lint.api.systemd import no_such_name
except ImportError as error:
    print(error)
"""
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=PROJECT, check=True)
    assert "no_such_name" in run.stdout
