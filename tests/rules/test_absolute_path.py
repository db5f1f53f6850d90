"""Rules that climb the folders of a tree end at its top, however the tree is named."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

from tests.conftest import PROJECT

SCRIPT = "#!/bin/sh\ncp rover.service /etc/systemd/system/\ncp rover.rules /etc/udev/rules.d/\n"


def test_file_missing_ends_for_an_absolute_path(tmp_path: Path) -> None:
    (tmp_path / "deploy").mkdir()
    (tmp_path / "deploy/install.sh").write_text(SCRIPT)
    command = [sys.executable, "-m", "bringup_lint", "check", "--select", "script/file-missing", str(tmp_path)]
    done = subprocess.run(command, cwd=PROJECT, capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 0, done.stderr
