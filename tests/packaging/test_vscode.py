"""The extension of Visual Studio Code packages."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

from tests.conftest import PROJECT


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("npm") is None, reason="npm is not installed")
def test_the_extension_packages(tmp_path: Path) -> None:
    folder = shutil.copytree(PROJECT / "integrations/vscode", tmp_path / "vscode")
    subprocess.run(["npm", "install", "--silent", "--no-audit", "--no-fund"], cwd=folder, check=True)
    subprocess.run(["npx", "--yes", "@vscode/vsce", "package"], cwd=folder, check=True, capture_output=True)
    assert [path.name for path in folder.glob("*.vsix")] == ["bringup-lint-0.1.0.vsix"]
