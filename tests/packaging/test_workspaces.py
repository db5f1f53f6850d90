"""The packages for ROS workspaces: colcon builds and tests with the real ament_cmake, and ros2cli runs the command.

`pip install '.[colcon]'` brings colcon and ament_cmake. No package index has ros2cli: it is used where it is installed.
"""

from __future__ import annotations

import importlib.util
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

import pytest

import bringup_lint
from tests.conftest import PROJECT

FOLDER = PROJECT / "integrations"
PACKAGES = ("ament_bringup_lint", "ament_cmake_bringup_lint", "ros2bringup_lint")
COLCON = shutil.which("colcon")
BROKEN = '[Service]\nExecStart=/opt/rover/drive\nUser=rover\nRestart=on-failure\nEnvironment="A=1\n'
CMAKE = """\
cmake_minimum_required(VERSION 3.10)
project({name} NONE)
find_package(ament_cmake_core REQUIRED)
find_package(ament_cmake_test REQUIRED)
find_package(ament_cmake_bringup_lint REQUIRED)
{test}
ament_package()
"""
HOOKS = "ament_execute_extensions(ament_lint_auto)"
"""What ament_lint_auto does at the end of a package."""
MANIFEST = """\
<package format="3">
  <name>{name}</name><version>0.0.1</version><description>A robot</description>
  <maintainer email="a@example.org">a</maintainer><license>Apache-2.0</license>
  <test_depend>{linter}</test_depend>
  <export><build_type>{kind}</build_type></export>
</package>
"""
SETUP = """\
from setuptools import setup

setup(name="depot", version="0.0.1", packages=[], extras_require={"test": ["pytest"]})
"""
PYTHON_TEST = """\
import pytest
from ament_bringup_lint.main import main


@pytest.mark.bringup_lint
def test_bringup_lint():
    assert main(["--exclude", "test/"]) == 0
"""


def manifest(name: str) -> ElementTree.Element:
    return ElementTree.parse(FOLDER / name / "package.xml").getroot()


@pytest.mark.parametrize("name", PACKAGES)
def test_manifests(name: str) -> None:
    package = manifest(name)
    assert [package.findtext("name"), package.findtext("version")] == [name, bringup_lint.__version__]
    setup = FOLDER / name / "setup.py"
    if setup.exists():
        assert f'version="{bringup_lint.__version__}"' in setup.read_text("utf-8")


def test_the_key_of_rosdep_is_the_one_that_the_packages_need() -> None:
    key = (FOLDER / "rosdep/bringup-lint.yaml").read_text("utf-8").splitlines()[1].removesuffix(":")
    needed = {each.text for name in PACKAGES for each in manifest(name).iter("exec_depend")}
    assert needed == {key, "ros2cli"}


@pytest.mark.slow
def test_the_command_of_the_package(tmp_path: Path) -> None:
    """Its own tests, which need neither ament nor colcon, in a folder that no other run has to clear."""
    path = os.pathsep.join([str(PROJECT), str(FOLDER / "ament_bringup_lint")])
    command = [
        sys.executable,
        "-m",
        "pytest",
        "-q",
        "-p",
        "no:cacheprovider",
        "--basetemp",
        str(tmp_path / "own"),
        "test",
    ]
    environment = {**os.environ, "PYTHONPATH": path, "PYTHONDONTWRITEBYTECODE": "1", "PYTEST_ADDOPTS": ""}
    run = subprocess.run(
        command, cwd=FOLDER / "ament_bringup_lint", env=environment, capture_output=True, text=True, check=False
    )
    assert run.returncode == 0, run.stdout


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    """Packages of the three kinds that use the linter, and the linter."""
    source = tmp_path / "src"
    for name in PACKAGES[:2]:
        shutil.copytree(FOLDER / name, source / name, ignore=shutil.ignore_patterns("__pycache__"))
    for name, test in (("rover", 'ament_bringup_lint(FAIL_ON "error" TIMEOUT 300)'), ("arm", HOOKS)):
        folder = written(source / name, "ament_cmake_bringup_lint", "ament_cmake")
        (folder / "CMakeLists.txt").write_text(CMAKE.format(name=name, test=test))
    (source / "rover/rover.service").write_text(BROKEN)
    (source / "arm/config").mkdir()
    (source / "arm/config/arm.yaml").write_text("arm:\n  ros__parameters:\n    rate: 50\n")
    depot = written(source / "depot", "ament_bringup_lint", "ament_python")
    (depot / "setup.py").write_text(SETUP)
    (depot / "test").mkdir()
    (depot / "test/test_bringup_lint.py").write_text(PYTHON_TEST)
    (depot / "depot.service").write_text(BROKEN)
    return tmp_path


def written(folder: Path, linter: str, kind: str) -> Path:
    folder.mkdir(parents=True)
    (folder / "package.xml").write_text(MANIFEST.format(name=folder.name, linter=linter, kind=kind))
    return folder


def colcon(workspace: Path, *words: str) -> subprocess.CompletedProcess[str]:
    """colcon in the workspace, over an environment that is sys.prefix."""
    prefixes = {name: sys.prefix for name in ("AMENT_PREFIX_PATH", "CMAKE_PREFIX_PATH")}
    inherited = os.environ.get("PYTHONPATH", "")
    environment = {**os.environ, **prefixes, "PYTHONPATH": os.pathsep.join(filter(None, [str(PROJECT), inherited]))}
    command = [COLCON or "colcon", *words]
    return subprocess.run(command, cwd=workspace, env=environment, capture_output=True, text=True, check=False)


@pytest.mark.slow
@pytest.mark.skipif(COLCON is None, reason="colcon is not installed")
@pytest.mark.skipif(importlib.util.find_spec("ament_package") is None, reason="ament_cmake is not installed")
def test_colcon_shows_the_findings(workspace: Path) -> None:
    built = colcon(workspace, "build", "--base-paths", "src")
    assert built.returncode == 0, built.stdout + built.stderr
    tested = colcon(workspace, "test", "--base-paths", "src", "--packages-select", "rover", "arm", "depot")
    assert tested.returncode == 0, tested.stdout + tested.stderr
    shown = colcon(workspace, "test-result", "--all", "--verbose")
    assert shown.returncode == 1, shown.stderr
    results = dict(re.findall(r"^(\S+\.xml): (.*)$", shown.stdout, re.M))
    one = ", 0 errors, 1 failure, 0 skipped"
    assert results["build/rover/test_results/rover/bringup_lint.xunit.xml"] == f"1 test{one}"
    assert results["build/arm/test_results/arm/bringup_lint.xunit.xml"] == "1 test, 0 errors, 0 failures, 0 skipped"
    assert results["build/depot/pytest.xml"] == f"1 test{one}"
    assert "- rover.bringup_lint systemd/unbalanced-quotes (rover.service:5:13)" in shown.stdout


@pytest.mark.slow
@pytest.mark.skipif(importlib.util.find_spec("ros2cli") is None, reason="ros2cli is not installed")
def test_the_command_of_ros2(tmp_path: Path) -> None:
    package = shutil.copytree(FOLDER / "ros2bringup_lint", tmp_path / "package")
    install = [
        sys.executable,
        "setup.py",
        "-q",
        "install",
        "--root",
        str(tmp_path / "root"),
        "--install-purelib",
        "/lib",
    ]
    subprocess.run(install, cwd=package, check=True, capture_output=True)
    path = [str(PROJECT), str(tmp_path / "root/lib"), os.environ.get("PYTHONPATH", "")]
    ros2 = "import sys; from ros2cli.cli import main; sys.exit(main())"

    def run(*words: str) -> subprocess.CompletedProcess[str]:
        command = [sys.executable, "-c", ros2, "bringup-lint", *words]
        environment = {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, path))}
        folder = PROJECT / "docs/example"
        return subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, check=False)

    found = run("--select", "netplan/gateway-deprecated", "--output-format", "concise", ".")
    assert (found.returncode, len(found.stdout.splitlines())) == (1, 1), found.stderr
    assert run("--help").stdout.startswith("Usage: bringup-lint")
    assert run("explain", "netplan/file-mode").stdout.startswith("netplan/file-mode")
    assert run("nosuchfile").returncode == 2


def test_no_module_of_the_folder_is_imported(tmp_path: Path) -> None:
    (tmp_path / "rover.service").write_text(BROKEN)
    for name in ("json.py", "bringup_lint.py"):
        (tmp_path / name).write_text("open('ran', 'w')\n")
    code = "import sys; sys.path.pop(0); from ament_bringup_lint.main import main; sys.exit(main(['.']))"
    paths = os.pathsep.join([str(PROJECT), str(FOLDER / "ament_bringup_lint")])
    run = subprocess.run(
        [sys.executable, "-c", code],
        capture_output=True,
        text=True,
        cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": paths},
    )
    assert run.returncode == 1 and "systemd/unbalanced-quotes" in run.stderr
    assert not (tmp_path / "ran").exists()
