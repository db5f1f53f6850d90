"""A configuration that is found is not trusted, and one without effect is an error with its place."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from bringup_lint.report import FINDINGS_ALONE
from bringup_lint.report import FORMATS
from tests.conftest import PROJECT
from tests.lint import lint

UNIT = "[Unit]\nDescription=One\n[Service]\nExecStart=/bin/true\n"


@pytest.fixture
def tree(tmp_path: Path) -> Path:
    folder = tmp_path / "checkout"
    folder.mkdir()
    (folder / "a.service").write_text(UNIT)
    return folder


@pytest.mark.parametrize(
    ("name", "text", "said"),
    [
        ("bringup-lint.toml", "[tool.bringup-lint]\nselect = []\n", "bringup-lint.toml:1: write the keys themselves"),
        ("pyproject.toml", "[tool.bringup_lint]\nselect = []\n", "pyproject.toml:1: [tool.bringup_lint] has no effect"),
        ("pyproject.toml", "[tool]\nbringup-lint = 5\n", "pyproject.toml:2: [tool.bringup-lint] must be a table"),
        ("pyproject.toml", f"[tool.bringup-lint]\nx={'[' * 20000}\n", "pyproject.toml: "),
        ("bringup-lint.toml", "\ntarget-systemd = 300\n", "bringup-lint.toml:2: target-systemd must be 245 to 257"),
        ("bringup-lint.toml", '[deploy]\n"nothere" = "/opt"\n', "bringup-lint.toml:2: deploy: there is no 'nothere'"),
        ("bringup-lint.toml", '[purpose]\n"gone/" = "ci"\n', "bringup-lint.toml:2: purpose: there is no 'gone/'"),
        (
            "bringup-lint.toml",
            '\nselect = ["systemdd"]\n',
            "bringup-lint.toml:2: no rule or family is called",
        ),
        ("bringup-lint.toml", 'exclude = ["\\\\"]\n', "bringup-lint.toml:1: exclude: "),
        ("bringup-lint.toml", 'baseline = "x\\u0000y"\n', "bringup-lint.toml"),
        (
            "bringup-lint.toml",
            'baseline = "/etc/shadow"\n',
            "bringup-lint.toml:1: baseline: '/etc/shadow' lies",
        ),
        ("bringup-lint.toml", f"{'.'.join('a' * 100_000)} = 1\n", "bringup-lint.toml: a key of more than 50 parts"),
        ("bringup-lint.toml", f"\nignore = {['udev'] * 1001}\n", "bringup-lint.toml:2: ignore has more than 1000"),
        ("bringup-lint.toml", f"exclude = {['a*b'] * 1001}\n", "bringup-lint.toml:1: exclude has more than 1000"),
        ("bringup-lint.toml", f"[per-file-ignores]\na = {['udev'] * 1001}\n", "per-file-ignores has more than 1000"),
        ("bringup-lint.toml", 'baseline = "../x"\n', "lies outside of the tree"),
        ("bringup-lint.toml", 'baseline = "https://user:pw@host/known.json"\n', "https:/user:**@host"),
        ("bringup-lint.toml", 'baseline = "fifo"\n', "fifo: not a regular file but a FIFO"),
    ],
)
def test_what_is_refused(tree: Path, name: str, text: str, said: str) -> None:
    os.mkfifo(tree / "fifo")
    (tree / name).write_text(text)
    run = lint("a.service", cwd=tree)
    assert (run.code, run.stdout) == (2, "")
    assert said in run.stderr
    assert len(run.stderr.splitlines()) == 1


def test_all_mistakes_are_said(tree: Path) -> None:
    lines = (
        'selct = ["udev"]',
        'fail-on = "always"',
        'ignore = ["systemdd", "udev", "nettplan"]',
        "[severity]",
        'launch = "low"',
    )
    (tree / "bringup-lint.toml").write_text("\n".join(lines) + "\n[deploy]\ngone = '/opt'\n")
    run = lint(cwd=tree)
    assert (run.code, run.stdout) == (2, "")
    said = [line.removeprefix("bringup-lint: ").split(":", 2)[1:] for line in run.stderr.splitlines()]
    assert [(int(number), text.split()[0]) for number, text in said] == [
        (1, "unknown"),
        (2, "fail-on"),
        (4, "severity"),
        (7, "deploy:"),
        (3, "no"),
        (3, "no"),
    ]


@pytest.mark.parametrize(("text", "line"), [("\nfail-on =\n", 2), ("\n\n[a]\n[a]\n", 4), ('\nselect = ["udev",\n', 2)])
def test_a_mistake_of_syntax_has_its_line(tree: Path, text: str, line: int) -> None:
    (tree / "bringup-lint.toml").write_text(text)
    run = lint(cwd=tree)
    assert run.code == 2
    assert f"bringup-lint.toml:{line}: " in run.stderr


def test_a_table_in_a_comment_is_none(tree: Path) -> None:
    (tree / "pyproject.toml").write_text("tool = 1\n# [tool.bringup-lint]\n")
    assert lint("--select", "lint", cwd=tree).code == 0


@pytest.mark.parametrize("kind", ["outside", "fifo", "large", "binary"])
def test_a_configuration_is_a_bounded_file_of_the_tree(tree: Path, kind: str) -> None:
    file = tree / "pyproject.toml"
    if kind == "outside":
        (tree.parent / "other.toml").write_text("[tool.bringup-lint]\n")
        file.symlink_to("../other.toml")
    elif kind == "fifo":
        os.mkfifo(file)
    elif kind == "large":
        with file.open("wb") as large:
            large.truncate(3 << 30)
    else:
        file.write_bytes(b"[tool.bringup-lint]\n\xff")
    run = lint(cwd=tree)
    assert run.code == 2
    assert len(run.stderr.splitlines()) == 1


def test_a_named_folder_is_not_left_out(tree: Path) -> None:
    (tree / "old/deep").mkdir(parents=True)
    (tree / "old/deep/b.service").write_text(UNIT)
    (tree / "old/c.service").write_text(UNIT)
    (tree / "bringup-lint.toml").write_text('exclude = ["/old/", "c.service"]\n')
    assert lint("--show-files", cwd=tree).stdout == "a.service  systemd-unit\n"
    assert lint("--show-files", "old", cwd=tree).stdout == "old/deep/b.service  systemd-unit, archive\n"
    assert lint("--show-files", cwd=tree / "old/deep").stdout == "b.service  systemd-unit\n"
    assert lint("--show-files", "--root", "old", cwd=tree).stdout == "old/deep/b.service  systemd-unit\n"


@pytest.mark.parametrize("option", ["--config", "--baseline"])
@pytest.mark.parametrize(("file", "said"), [("/dev/zero", "a character device"), ("fifo", "a FIFO")])
def test_what_the_command_line_names_is_a_bounded_file(tree: Path, option: str, file: str, said: str) -> None:
    os.mkfifo(tree / "fifo")
    run = lint(option, file, cwd=tree)
    assert (run.code, run.stdout) == (2, "")
    assert f"not a regular file but {said}" in run.stderr


@pytest.mark.parametrize("name", ["bringup-lint.toml", "pyproject.toml", "known.json"])
def test_a_device_of_the_tree_is_not_read(tree: Path, name: str) -> None:
    if name == "known.json":
        (tree / "bringup-lint.toml").write_text('baseline = "known.json"\n')
    (tree / name).symlink_to("/dev/zero")
    run = lint(cwd=tree)
    assert run.code == 2
    assert len(run.stderr.splitlines()) == 1


@pytest.mark.skipif(not shutil.which("setpriv") or os.getuid() != 0, reason="needs root, who gives up its rights")
@pytest.mark.parametrize("name", ["bringup-lint.toml", "pyproject.toml", "known.json"])
def test_a_configuration_without_permission_to_read_is_one_line(tree: Path, name: str) -> None:
    if name == "known.json":
        (tree / "bringup-lint.toml").write_text('baseline = "known.json"\n')
    (tree / name).write_text("[tool.bringup-lint]\n")
    os.chown(tree / name, 1234, 5678)
    (tree / name).chmod(0o600)
    without_rights = ("setpriv", "--bounding-set=-all", "--inh-caps=-all", sys.executable, "-m", "bringup_lint")
    environment = {**os.environ, "PYTHONPATH": str(PROJECT)}
    run = subprocess.run(without_rights, cwd=tree, capture_output=True, text=True, env=environment)
    assert (run.returncode, run.stdout) == (2, "")
    assert f"{name}: Permission denied" in run.stderr
    assert len(run.stderr.splitlines()) == 1


def test_patterns_do_not_hang(tree: Path) -> None:
    (tree / "bringup-lint.toml").write_text(f'exclude = ["{"*a" * 40}b", "{"**/a/" * 40}b"]\n')
    (tree / ("a" * 200)).touch()
    deep = tree.joinpath(*["a"] * 50)
    deep.mkdir(parents=True)
    assert lint("--select", "lint", cwd=tree).code == 0


def test_a_baseline_that_is_not_text(tree: Path) -> None:
    (tree / "known.json").write_bytes(b"\xff")
    run = lint("--baseline", "known.json", cwd=tree)
    assert run.code == 2
    assert "known.json: not a baseline: not UTF-8" in run.stderr


def test_no_message_about_a_configuration_holds_a_secret(tree: Path) -> None:
    (tree / "bringup-lint.toml").write_text('fail-on = "https://robot:Orange-Lighthouse7@example.org/x"\n')
    run = lint(cwd=tree)
    assert run.code == 2 and "robot:" in run.stderr
    assert "Orange-Lighthouse7" not in run.stderr


SILENCING = """exclude = ["old/"]
[per-file-ignores]
"robot.service" = ["systemd/legacy-key"]
"""
KEPT_BACK = ("1 suppressed by bringup-lint.toml", "1 path excluded by bringup-lint.toml")


@pytest.fixture
def silenced(tmp_path: Path) -> Path:
    """A tree whose configuration suppresses a finding and leaves out a folder."""
    (tmp_path / "old").mkdir()
    for name in ("robot.service", "old/robot.service"):
        (tmp_path / name).write_text("[Service]\nExecStart=/bin/x\nStartLimitInterval=9\n")
    (tmp_path / "bringup-lint.toml").write_text(SILENCING)
    return tmp_path


@pytest.mark.parametrize("output_format", FORMATS)
def test_each_run_says_what_a_configuration_keeps_back(silenced: Path, output_format: str) -> None:
    run = lint("--select", "systemd/legacy-key", "--output-format", output_format, ".", cwd=silenced)
    told, quiet = (run.stderr, run.stdout) if output_format in FINDINGS_ALONE else (run.stdout, run.stderr)
    path = KEPT_BACK[1]
    assert path in told
    assert "bringup-lint.toml" not in quiet
    assert KEPT_BACK[0] in told or '"suppressed_by"' in told or "suppressedBy" in told or "suppressions" in told


def test_quiet_runs_and_whole_reports_say_it_nowhere_else(silenced: Path) -> None:
    options = ("--select", "systemd/legacy-key", "--output-format", "concise")
    assert lint(*options, "--quiet", ".", cwd=silenced).stderr == ""
    assert lint(*options, "--output-format", "json", "--output-file", "r.json", ".", cwd=silenced).stderr == ""
    assert lint(*options, "--no-ignores", "robot.service", cwd=silenced).stderr == ""
