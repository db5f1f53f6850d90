"""Which of two workspaces wins when their setup files are sourced in an order, by the real colcon, and what
bringup-lint says of that order."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.lint import lint

COLCON = shutil.which("colcon") or shutil.which("colcon", path=str(Path(sys.executable).parent))
ORDERS = {
    ("over/install/setup.sh", "under/install/setup.sh"): "over",
    ("over/install/local_setup.sh", "under/install/setup.sh"): "under",
    ("under/install/setup.sh", "over/install/local_setup.sh"): "over",
    ("under/install/setup.sh", "over/install/setup.sh"): "over",
}
"""Setup files as they are sourced -> the workspace whose package is imported."""
SETUP = "from setuptools import setup\n\nsetup(name='heron', version='1.0', packages=['heron'])\n"
IMPORT = "python3 -c 'import heron; print(heron.WHERE)'"


@pytest.fixture(scope="module")
def workspaces(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Two workspaces with one package, the upper one built in the environment of the lower one."""
    if COLCON is None:
        pytest.skip("colcon is not installed")
    folder = tmp_path_factory.mktemp("workspaces")
    before = ""
    for name in ("under", "over"):
        package = folder / name / "src/heron"
        (package / "heron").mkdir(parents=True)
        (package / "heron/__init__.py").write_text(f"WHERE = '{name}'\n")
        (package / "setup.py").write_text(SETUP)
        (package / "setup.cfg").write_text("[metadata]\nname = heron\n")
        subprocess.run(["sh", "-c", f"{before}'{COLCON}' build"], cwd=folder / name, check=True, capture_output=True)
        before = f". '{folder}/under/install/setup.sh'; "
    return folder


@pytest.mark.slow
@pytest.mark.parametrize(("first", "second"), ORDERS)
def test_the_order_of_setup_files(first: str, second: str, workspaces: Path, tmp_path: Path) -> None:
    command = f". ./{first}; . ./{second}; {IMPORT}"
    run = subprocess.run(["sh", "-c", command], cwd=workspaces, capture_output=True, text=True, check=True)
    wins = run.stdout.strip()
    assert wins == ORDERS[first, second]
    names = [
        each.replace("under/install", "/opt/ros/jazzy").replace("over/", "/home/rover/") for each in (first, second)
    ]
    lines = "".join(f'echo ". {name}" >> ~/.bashrc\n' for name in names)
    (tmp_path / "prepare.sh").write_text(f"#!/bin/sh\n{lines}")
    said = lint("--select", "env/workspace-source-order", "--output-format", "concise", ".", cwd=tmp_path).stdout
    assert ("env/workspace-source-order" in said) is (wins == "under")
