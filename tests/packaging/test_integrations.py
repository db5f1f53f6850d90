"""The action, the GitLab template and the hooks, run as GitHub, GitLab and pre-commit run them."""

from __future__ import annotations

import json
import os
import re
import shutil
import site
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
import yaml

from tests.conftest import PROJECT
from tests.packaging.test_packaging import checked
from tests.packaging.test_packaging import git
from tests.packaging.test_packaging import head
from tests.packaging.test_packaging import hook_cache
from tests.packaging.test_packaging import repository
from tests.packaging.test_packaging import run

__all__ = ["hook_cache", "repository"]

pytestmark = pytest.mark.slow

ACTION = yaml.safe_load((PROJECT / "action.yml").read_text())
INSTALL, *CHECK = [step for step in ACTION["runs"]["steps"] if "run" in step]
"""The steps of the action that are commands."""
NETPLAN = "etc/netplan/10-mower.yaml"
DDS = "etc/mower/dds.xml"


@pytest.fixture
def mower(tmp_path: Path) -> Path:
    """The example as a checkout; its second commit takes an interface away from the DDS file."""
    folder = tmp_path / "mower"
    shutil.copytree(PROJECT / "docs/example", folder)
    (folder / DDS).write_text((folder / DDS).read_text().replace("enp1s0", "enp2s0"))
    git(folder, "init", "-q", "-b", "main")
    git(folder, "add", "-A")
    git(folder, "commit", "-qm", "first")
    (folder / NETPLAN).write_text((folder / NETPLAN).read_text().replace("enp2s0", "enp9s0"))
    git(folder, "commit", "-qam", "second")
    return folder


class Runner:
    """The steps of the action with ``run``, with the environment that GitHub's runner sets."""

    def __init__(self, action: Path, temporary: Path, workspace: Path, folder: Path, **inputs: str) -> None:
        self.workspace = workspace
        self.outputs: dict[str, str] = {}
        defaults = {name: str(each["default"]) for name, each in ACTION["inputs"].items()}
        self.inputs = {**defaults, "since": "", **inputs}
        self.files = {name: folder / name.lower() for name in ("GITHUB_OUTPUT", "GITHUB_STEP_SUMMARY")}
        for file in self.files.values():
            file.touch()
        libraries = os.pathsep.join(path for path in sys.path if path.endswith("-packages"))
        self.environment = {
            **{name: str(file) for name, file in self.files.items()},
            "GITHUB_ACTION_PATH": str(action),
            "GITHUB_WORKSPACE": str(workspace),
            "RUNNER_TEMP": str(temporary),
            # Without a network: the libraries are those of the tests.
            "PYTHONPATH": libraries,
            "PIP_NO_DEPS": "1",
            "PIP_NO_BUILD_ISOLATION": "0",
        }

    def value(self, expression: str) -> str:
        def known(match: re.Match[str]) -> str:
            kind, _, name = match[1].partition(".")
            return self.inputs[name] if kind == "inputs" else self.outputs[name.rpartition(".")[2]]

        return re.sub(r"\$\{\{ ([\w.-]+) \}\}", known, expression)

    def step(self, step: dict[str, Any]) -> subprocess.CompletedProcess[str]:
        assert step["shell"] == "bash" and "${{" not in step["run"], "text of users never becomes a script"
        own = {name: self.value(value) for name, value in step.get("env", {}).items()}
        script = self.files["GITHUB_OUTPUT"].with_name("step.sh")
        script.write_text(step["run"])
        bash = ("bash", "--noprofile", "--norc", "-e", "-o", "pipefail", script)
        done = run(*bash, cwd=self.workspace, **self.environment, **own)
        lines = self.files["GITHUB_OUTPUT"].read_text().splitlines()
        self.outputs = dict(line.split("=", 1) for line in lines)
        return done

    def check(self) -> list[subprocess.CompletedProcess[str]]:
        return [self.step(step) for step in CHECK]


@pytest.fixture(scope="session")
def temporary(repository: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of the runner, with what the first step of the action installs."""
    folder = tmp_path_factory.mktemp("runner")
    installed = Runner(repository, folder, folder, folder).step(INSTALL)
    assert installed.returncode == 0, installed.stderr
    return folder


@pytest.mark.skipif(not shutil.which("git"), reason="no git")
def test_action(repository: Path, temporary: Path, mower: Path, tmp_path: Path) -> None:
    pytest.importorskip("dulwich")
    base = checked("git", "rev-parse", "HEAD~1", cwd=mower).strip()
    runner = Runner(repository, temporary, mower, tmp_path, since=base, args="--target-ros jazzy --isolated")
    check, verdict = runner.check()
    assert check.returncode == 0, check.stderr
    assert verdict.returncode == 1
    assert all(line.startswith(("::error file=", "::warning file=")) for line in check.stdout.splitlines())
    assert f"file={DDS}" in check.stdout and "mower.service" not in check.stdout
    assert runner.files["GITHUB_STEP_SUMMARY"].read_text().startswith("### bringup-lint: ")
    (sarif,) = json.loads(Path(runner.outputs["sarif"]).read_text())["runs"]
    assert {each["locations"][0]["physicalLocation"]["artifactLocation"]["uri"] for each in sarif["results"]} >= {DDS}
    assert runner.outputs["exit-code"] == "1"


@pytest.mark.parametrize("since", ["", "all", "0" * 40])
def test_action_without_a_base_shows_everything(
    repository: Path, temporary: Path, mower: Path, tmp_path: Path, since: str
) -> None:
    pytest.importorskip("dulwich")
    inputs = {"since": since, "annotations": "false", "summary": "false", "args": "--isolated"}
    runner = Runner(repository, temporary, mower, tmp_path, **inputs)
    check, verdict = runner.check()
    assert "mower.service" in check.stdout and verdict.returncode == 1
    assert ("The base of the change cannot be fetched" in check.stdout) == (since == "0" * 40)
    assert runner.files["GITHUB_STEP_SUMMARY"].read_text() == ""


def test_action_names_what_it_has() -> None:
    text = (PROJECT / "action.yml").read_text()
    assert set(re.findall(r"inputs\.([\w-]+)", text)) == set(ACTION["inputs"])
    assert all("description" in each for each in (*ACTION["inputs"].values(), *ACTION["outputs"].values()))


def test_action_passes_zizmor() -> None:
    path = os.pathsep.join((os.path.dirname(sys.executable), os.environ["PATH"]))
    zizmor = shutil.which("zizmor", path=path)
    if not zizmor:
        pytest.skip("zizmor is not installed")
    checked(zizmor, "--offline", "--no-progress", "action.yml", cwd=PROJECT)


def test_gitlab_template(mower: Path, tmp_path: Path) -> None:
    """The command of the template, with the variables of a merge request."""
    pytest.importorskip("dulwich")
    job = yaml.safe_load((PROJECT / "integrations/gitlab/bringup-lint.yml").read_text())["bringup-lint"]
    install, check = job["script"]
    assert "bringup-lint[git]" in install
    command = tmp_path / "bin/bringup-lint"
    command.parent.mkdir()
    command.write_text(f'#!/bin/sh\nexec {sys.executable} -m bringup_lint "$@"\n')
    command.chmod(0o755)
    base = checked("git", "rev-parse", "HEAD~1", cwd=mower).strip()
    variables = {"CI_MERGE_REQUEST_DIFF_BASE_SHA": base, "BRINGUP_LINT_ARGS": "--isolated"}
    path = f"{command.parent}{os.pathsep}{os.environ['PATH']}"
    python = os.pathsep.join((str(PROJECT), *site.getsitepackages()))
    done = run("bash", "-e", "-c", check, cwd=mower, PATH=path, PYTHONPATH=python, **variables)
    assert done.returncode == 1, done.stderr
    reports = job["artifacts"]["reports"]
    issues = json.loads((mower / reports["codequality"]).read_text())
    assert {issue["location"]["path"] for issue in issues} >= {DDS}
    assert "mower.service" not in {Path(issue["location"]["path"]).name for issue in issues}
    assert (mower / reports["junit"]).read_text().startswith("<?xml")


def test_container_copies_what_is_there() -> None:
    lines = (PROJECT / "Containerfile").read_text().splitlines()
    named = [word for line in lines if line.startswith("COPY") and "--from" not in line for word in line.split()[1:-1]]
    ignore = (PROJECT / ".containerignore").read_text().splitlines()
    assert all((PROJECT / name).exists() and f"!{name}" in ignore for name in named)
    assert any(line.startswith("USER ") and "root" not in line for line in lines)


def test_container_copies_all_that_the_wheel_is_built_from(tmp_path: Path) -> None:
    """The steps of the Containerfile up to its build, and that build, here."""
    for line in (PROJECT / "Containerfile").read_text().splitlines():
        if not line.startswith("COPY") or "--from" in line:
            continue
        *sources, target = line.split()[1:]
        for source in sources:
            place = tmp_path / target / (Path(source).name if target.endswith("/") else "")
            place.parent.mkdir(parents=True, exist_ok=True)
            if (PROJECT / source).is_dir():
                shutil.copytree(PROJECT / source, place, ignore=shutil.ignore_patterns("__pycache__"))
            else:
                shutil.copy(PROJECT / source, place)
    build = [sys.executable, "-m", "pip", "wheel", "-q", "--no-deps", "--no-build-isolation", "-w", "dist", "."]
    checked(*build, cwd=tmp_path)
    assert list((tmp_path / "dist").glob("*.whl"))


class Hooks:
    """A robot's repository with the hooks, installed for its commits by the real pre-commit."""

    def __init__(self, folder: Path, project: Path, cache: Path, *hooks: str) -> None:
        self.folder = folder
        self.home = {"PRE_COMMIT_HOME": str(cache)}
        listed = "".join(f"  - id: {hook}\n" for hook in hooks)
        text = f"repos:\n- repo: {project}\n  rev: {head(project)}\n  hooks:\n{listed}"
        (folder / ".pre-commit-config.yaml").write_text(text)
        git(folder, "add", "-A")
        git(folder, "commit", "-qm", "hooks")
        checked(sys.executable, "-m", "pre_commit", "install", cwd=folder, **self.home)

    def commit(self) -> subprocess.CompletedProcess[str]:
        name = ("-c", "user.name=t", "-c", "user.email=t@example.org")
        return run("git", *name, "commit", "-m", "change", cwd=self.folder, **self.home)


def test_hook_for_changed_files(repository: Path, mower: Path, hook_cache: Path) -> None:
    pytest.importorskip("pre_commit")
    hooks = Hooks(mower, repository, hook_cache, "bringup-lint-changed")
    (mower / "README.txt").write_text("a robot\n")
    git(mower, "add", "README.txt")
    done = hooks.commit()
    assert done.returncode == 0 and "no files to check" in done.stderr, done.stderr
    (mower / "a.py").write_text("print('hello')\n")
    (mower / "etc/systemd/system/bad.service").write_text("[Service]\nUser\n")
    git(mower, "add", "a.py")
    done = hooks.commit()
    assert done.returncode == 0, "old findings and untracked files are not of this commit: " + done.stderr
    (mower / NETPLAN).write_text((mower / NETPLAN).read_text().replace("enp9s0", "enp8s0"))
    git(mower, "add", NETPLAN)
    done = hooks.commit()
    assert done.returncode == 1 and DDS in done.stderr, done.stderr
    assert "bad.service" not in done.stderr


def test_hook_that_fixes(repository: Path, mower: Path, hook_cache: Path) -> None:
    pytest.importorskip("pre_commit")
    hooks = Hooks(mower, repository, hook_cache, "bringup-lint-fix")
    modem = mower / "etc/netplan/20-modem.yaml"
    modem.write_text(modem.read_text().replace("  version: 2\n", "  version: 2\n  renderer: networkmanager\n"))
    git(mower, "add", "-A")
    done = hooks.commit()
    assert done.returncode == 1 and "files were modified by this hook" in done.stderr, done.stderr
    git(mower, "add", "-A")
    done = hooks.commit()
    assert done.returncode == 0, done.stderr
    assert "renderer: NetworkManager" in modem.read_text()
