"""However it is installed, the built-in rules are found; the hook works with the real pre-commit."""

from __future__ import annotations

import marshal
import os
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

from bringup_lint import __version__
from bringup_lint.registry import Registry
from bringup_lint.rule_index.stored import FILE
from tests.conftest import PROJECT

pytestmark = pytest.mark.slow

LATIN1 = b"[Service]\nExecStart=/bin/\xff\n"
RULES = set(Registry.of().paths)


def run(*command: str | Path, cwd: Path, **env: str) -> subprocess.CompletedProcess[str]:
    clean = {
        key: value for key, value in os.environ.items() if not key.startswith(("PYTHONPATH", "GIT_", "PRE_COMMIT"))
    }
    return subprocess.run(
        [str(part) for part in command], capture_output=True, text=True, cwd=cwd, env={**clean, **env}, timeout=600
    )


def checked(*command: str | Path, cwd: Path, **env: str) -> str:
    done = run(*command, cwd=cwd, **env)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.fixture(scope="session")
def repository(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The project as a git repository with everything committed, as a hook or pip would clone it."""
    folder = tmp_path_factory.mktemp("clone") / "bringup-lint"
    unwanted = shutil.ignore_patterns(
        ".git", ".venv", "__pycache__", ".hypothesis", "*.egg-info", "node_modules", "fixtures"
    )
    shutil.copytree(PROJECT, folder, ignore=unwanted, symlinks=True)
    git(folder, "init", "-q")
    git(folder, "add", "-A")
    git(folder, "commit", "-qm", "all")
    return folder


def git(folder: Path, *arguments: str) -> None:
    checked("git", "-c", "user.name=t", "-c", "user.email=t@example.org", *arguments, cwd=folder)


@pytest.fixture
def robot(tmp_path: Path) -> Path:
    folder = tmp_path / "robot"
    folder.mkdir()
    (folder / "robot.service").write_bytes(LATIN1)
    return folder


@pytest.fixture(scope="session")
def hook_cache(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where pre-commit keeps what it installs: once for all hooks, as it does for a user."""
    return tmp_path_factory.mktemp("pre-commit")


@pytest.fixture(scope="session")
def wheel(repository: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What pip builds of the repository."""
    folder = tmp_path_factory.mktemp("wheel")
    pip("wheel", "-q", "--no-deps", "--no-build-isolation", "-w", folder, f"git+file://{repository}")
    (wheel,) = folder.glob("*.whl")
    return wheel


def test_the_wheel_carries_the_index_of_its_rules(wheel: Path) -> None:
    folder = "bringup_lint/rules/"
    with zipfile.ZipFile(wheel) as archive:
        index = marshal.loads(archive.read(f"{folder}{FILE}"))
        files = {name.removeprefix(folder) for name in archive.namelist() if name.startswith(folder)}
    rules = {name for name in files if name.endswith(".py") and "/_" not in name and "/" in name}
    assert set(index["rules"]) == rules
    assert index["version"] == __version__


def pip(*arguments: str | Path) -> None:
    checked(sys.executable, "-m", "pip", "--disable-pip-version-check", *arguments, cwd=PROJECT)


def installed(folder: Path, *requirements: str | Path) -> Path:
    """The command in a fresh virtual environment, whose libraries come from the one that runs the tests."""
    checked(sys.executable, "-m", "venv", "--without-pip", folder, cwd=PROJECT)
    libraries = next((folder / "lib").iterdir()) / "site-packages"
    ours = [path for path in sys.path if path.endswith("-packages")]
    (libraries / "theirs.pth").write_text("\n".join(ours) + "\n")
    python = folder / "bin/python"
    pip("--python", python, "install", "-q", "--no-deps", "--no-build-isolation", "--force-reinstall", *requirements)
    return folder / "bin/bringup-lint"


def rules_of(command: Path, cwd: Path) -> set[str]:
    import json

    return {rule["id"] for rule in json.loads(checked(command, "rules", "--output-format", "json", cwd=cwd))}


def test_wheel_carries_the_rules_and_no_top_level_rules(wheel: Path) -> None:
    names = zipfile.ZipFile(wheel).namelist()
    assert [name for name in names if name.endswith("/share/man/man1/bringup-lint.1")]
    assert "bringup_lint/rules/lint/encoding.py" in names
    assert "bringup_lint/report/html/page.html" in names
    assert not [name for name in names if name.startswith(("rules/", "tests/", "fixtures/"))]


def test_wheel_from_git_is_installed(wheel: Path, tmp_path: Path, robot: Path) -> None:
    command = installed(tmp_path / "env", wheel)
    assert rules_of(command, robot) == RULES
    assert run(command, ".", cwd=robot).returncode == 1


def test_editable_install(repository: Path, tmp_path: Path, robot: Path) -> None:
    command = installed(tmp_path / "env", "--editable", repository)
    assert rules_of(command, robot) == RULES


def test_plain_checkout(repository: Path, robot: Path) -> None:
    done = run(sys.executable, "-m", "bringup_lint", robot, cwd=repository)
    assert done.returncode == 1
    assert "lint/encoding" in done.stdout


def test_pre_commit_hook(repository: Path, robot: Path, hook_cache: Path) -> None:
    pytest.importorskip("pre_commit")
    (robot / ".pre-commit-config.yaml").write_text(
        f"repos:\n- repo: {repository}\n  rev: {head(repository)}\n  hooks:\n  - id: bringup-lint\n"
    )
    git(robot, "init", "-q")
    git(robot, "add", "-A")
    home = {"PRE_COMMIT_HOME": str(hook_cache)}
    done = run(sys.executable, "-m", "pre_commit", "run", "--all-files", cwd=robot, **home)
    assert done.returncode == 1, done.stdout + done.stderr
    assert "error[lint/encoding]" in done.stdout
    (robot / "robot.service").write_text("[Unit]\nDescription=One\n[Service]\nExecStart=/bin/true\n")
    git(robot, "add", "-A")
    done = run(sys.executable, "-m", "pre_commit", "run", "--all-files", cwd=robot, **home)
    assert done.returncode == 0, done.stdout + done.stderr


def head(repository: Path) -> str:
    return checked("git", "rev-parse", "HEAD", cwd=repository).strip()
