"""``--add-ignores``: what is there is suppressed with a reason, and nothing else changes."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from tests.conftest import PROJECT
from tests.lint import Run
from tests.lint import lint

UNIT = "[Unit]\nDescription=One\n[Service]\nExecStart=/bin/true\nRestartSec=soon\n"
ENTRY = '"/etc/lawn/keystore/private/ca.key.pem" = ["sros2/ca-key-on-robot"]'


@pytest.fixture
def tree(tmp_path: Path) -> Path:
    (tmp_path / "a.service").write_text(UNIT)
    return tmp_path


def check(tree: Path, *arguments: str) -> Run:
    return lint(
        "--select", "systemd/invalid-value,sros2/ca-key-on-robot", "--output-format", "concise", *arguments, cwd=tree
    )


def with_key(tree: Path) -> Path:
    shutil.copytree(PROJECT / "fixtures/sros2/ca_key_on_robot/bad", tree, dirs_exist_ok=True)
    return tree


def test_a_comment_is_above_the_line(tree: Path) -> None:
    run = check(tree, "--add-ignores", "the vendor's unit")
    assert (run.code, run.stdout) == (0, "")
    assert run.stderr == "Suppressed 1 finding in 1 file by comments.\n"
    comment = "# bringup-lint: ignore[systemd/invalid-value]: the vendor's unit\n"
    assert (tree / "a.service").read_text() == UNIT.replace("RestartSec", comment + "RestartSec")
    assert check(tree).code == 0
    assert check(tree, "--add-ignores", "again").stderr == ""


def test_copies_of_a_line_are_counted_apart(tmp_path: Path) -> None:
    """The report shows one finding; each copy needs a comment of its own."""
    for name in ("a.service", "b.service"):
        (tmp_path / name).write_text(UNIT)
    shown = check(tmp_path)
    assert len(shown.stdout.splitlines()) == 1
    run = check(tmp_path, "--add-ignores", "known")
    said = "Suppressed 2 findings (1 of them on copies of lines, which a report counts once) in 2 files by comments.\n"
    assert run.stderr == said


def test_what_the_baseline_knows_gets_no_comment(tree: Path) -> None:
    check(tree, "--write-baseline", "known.json")
    check(tree, "--baseline", "known.json", "--add-ignores", "known")
    assert (tree / "a.service").read_text() == UNIT


@pytest.mark.parametrize(
    ("name", "before", "after"),
    [
        ("bringup-lint.toml", None, "[per-file-ignores]\n# for tests\n{}\n"),
        ("bringup-lint.toml", "exclude = []\n", "exclude = []\n\n[per-file-ignores]\n# for tests\n{}\n"),
        (
            "bringup-lint.toml",
            '[per-file-ignores]\n"a.service" = ["lint"]\n',
            '[per-file-ignores]\n# for tests\n{}\n"a.service" = ["lint"]\n',
        ),
        (
            "pyproject.toml",
            "[tool.bringup-lint]\nexclude = []\n",
            "[tool.bringup-lint]\nexclude = []\n\n[tool.bringup-lint.per-file-ignores]\n# for tests\n{}\n",
        ),
    ],
)
def test_a_format_without_comments_gets_an_entry(tree: Path, name: str, before: str | None, after: str) -> None:
    (tree / "a.service").unlink()
    with_key(tree)
    if before is not None:
        (tree / name).write_text(before)
    run = check(tree, "--add-ignores", "for tests")
    assert (run.code, run.stderr) == (0, f"Suppressed 1 finding in 1 file by [per-file-ignores] of {name}.\n")
    assert (tree / name).read_text() == after.format(ENTRY)
    assert check(tree).code == 0


def test_a_table_that_cannot_be_extended_is_left_alone(tree: Path) -> None:
    with_key(tree)
    text = 'per-file-ignores = {"b.service" = ["lint"]}\n'
    (tree / "bringup-lint.toml").write_text(text)
    run = check(tree, "--add-ignores", "for tests")
    assert run.code == 2
    assert "add to [per-file-ignores] yourself" in run.stderr
    assert (tree / "bringup-lint.toml").read_text() == text


def test_comments_that_break_a_file_are_not_written(tree: Path) -> None:
    text = '<?xml version="1.0"?><launch><node pkg="a" exec="b" nam="c"/></launch>\n'
    (tree / "a.launch.xml").write_text(text)
    run = lint("--select", "launch", "--add-ignores", "for tests", cwd=tree)
    assert run.code == 0
    assert lint("--select", "launch", cwd=tree).code == 0


@pytest.mark.parametrize(
    "arguments",
    [
        ["--add-ignores", " "],
        ["--add-ignores", "a -- b"],
        ["--add-ignores", "a\nb"],
        ["--add-ignores", "why", "--fix"],
        ["--add-ignores", "why", "--no-ignores"],
    ],
)
def test_wrong_usage(tree: Path, arguments: list[str]) -> None:
    run = check(tree, *arguments)
    assert (run.code, run.stdout) == (2, "")
    assert (tree / "a.service").read_text() == UNIT
