"""Formats load only what they need."""

from __future__ import annotations

import subprocess
import sys

import pytest

from tests.conftest import PROJECT

COSTLY = ("json", "datetime", "hashlib", "urllib.parse", "textwrap", "unicodedata")


def loaded_after(code: str) -> list[str]:
    script = f"""import sys
before = set(sys.modules)
{code}
print([name for name in {COSTLY!r} if name in sys.modules and name not in before])"""
    run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, cwd=PROJECT, check=True)
    return run.stdout.strip()


@pytest.mark.parametrize("output_format", ["concise", "text"])
def test_plain_formats_load_nothing_costly(output_format: str) -> None:
    assert loaded_after(f"import bringup_lint.report.{output_format}") == "[]"
