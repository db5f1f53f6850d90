"""Which comments are read, and which lines they count for."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from bringup_lint.config import Config
from bringup_lint.discover.walk import discover_text
from bringup_lint.engine import run
from bringup_lint.registry import Registry
from bringup_lint.robot import Robot
from bringup_lint.source import Source
from bringup_lint.suppress.comments import Ignore
from bringup_lint.suppress.comments import read
from tests.conftest import PROJECT
from tests.growth import is_linear
from tests.lint import lint


def only(text: str, kind: str = "systemd-unit") -> Ignore:
    (ignore,) = read(Source("x", text, kind))
    return ignore


@pytest.mark.parametrize(
    ("comment", "reason"),
    [
        ("# bringup-lint: ignore[a/b]: why not", "why not"),
        ("# bringup-lint: ignore[a/b] -- why not", "why not"),
        ("; bringup-lint: ignore[a/b] – why not", "why not"),
        ("// bringup-lint:ignore [a/b]:why: not", "why: not"),
        ("<!-- bringup-lint: ignore[a/b]: why not -->", "why not"),
        ("<!--bringup-lint: ignore[a/b]: why not-->", "why not"),
        ("# bringup-lint: ignore[a/b]", ""),
        ("# bringup-lint: ignore[a/b]:", ""),
        ("# bringup-lint: ignore[a/b] why not", ""),
    ],
)
def test_reason(comment: str, reason: str) -> None:
    assert only(comment).reason == reason


@pytest.mark.parametrize(
    ("kind", "text", "lines"),
    [
        ("systemd-unit", "[A]\n{}\n# old\nX=1\nY=2\n", [3, 4]),
        ("systemd-unit", "[A]\n{}\nX=1 \\\n  2 \\\n  3\nY=2\n", [3, 4, 5]),
        ("systemd-unit", "[A]\nX=1 {}\nY=2\n", [2]),
        ("systemd-unit", "{}\n\n[A]\nX=1\n", [1, 2]),
        ("fastdds", '<a>\n<{}>\n<b\n  c="1>"\n  d="2">text\n  more</b>\n</a>\n', [3, 4, 5, 6]),
        ("fastdds", "<a>\n<{}\n  goes on>\n<b/>\n</a>\n", [4]),
        ("netplan", "a:\n  {}\n  b: >-\n    c\n\n    d\n  e: 1\n", [3, 4, 5, 6]),
        ("netplan", "a:\n  {}\n  b:\n    c: 1\n", [3]),
        ("netplan", "a:\n  {}\n  - b: 1\n    c: 1\n", [3]),
        ("launch-python", 'a = 1\n{}\nb = """\nc\n"""\nd\n', [3, 4, 5]),
        ("launch-python", "a = 1\n{}\nb = f(\n  c,\n)\n", [3]),
        ("shell-script", "a\n{}\ncat > b <<EOF\nc\nEOF\nd\n", [3, 4, 5]),
        ("cpp-node", "int a;\n{}\n#include <b>\nint c;\n", [3]),
    ],
)
def test_statement(kind: str, text: str, lines: list[int]) -> None:
    said = "bringup-lint: ignore[a/b]: why"
    comment = {"fastdds": f"!-- {said} --", "cpp-node": f"// {said}"}.get(kind, f"# {said}")
    if "goes on" in text:
        comment = f"!-- {said}"
        text = text.replace("goes on>", "goes on -->")
    assert list(only(text.format(comment), kind).lines or ()) == lines


def test_head_counts_for_the_file_as_a_whole() -> None:
    assert only('<?xml version="1.0"?>\n<!-- bringup-lint: ignore[a/b]: why -->\n<a/>\n', "fastdds").head
    assert not only("<a>\n<!-- bringup-lint: ignore[a/b]: why -->\n<b/></a>\n", "fastdds").head


@pytest.mark.parametrize("unit", ["# bringup-lint: ignore[", "# bringup-lint: ignore[a]: b ", "<!-- bringup-lint: "])
@pytest.mark.parametrize("end", ["", "\n", " \\\n"])
@pytest.mark.parametrize("kind", ["systemd-unit", "fastdds", "netplan", "shell-script", "launch-python"])
def test_hostile_comments_take_linear_time(unit: str, end: str, kind: str) -> None:
    assert is_linear(lambda size: list(read(Source("x", (unit + end) * size, kind))), 500)


def test_comments_that_name_no_rule_read_the_rules_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """One reading of all rules for each comment took seconds for a small file."""
    calls = []
    every = Registry.all
    monkeypatch.setattr(Registry, "all", lambda self: calls.append(1) or every(self))
    text = "[Service]\n" + "# bringup-lint: ignore[a]: b\n" * 20
    run(Robot(discover_text("a.service", text.encode())), Registry.of(), Config())
    assert len(calls) <= 1


def test_a_comment_counts_in_a_module_that_a_node_imports(tmp_path: Path) -> None:
    shutil.copytree(PROJECT / "fixtures/node/topic_name_invalid/bad_modules", tmp_path, dirs_exist_ok=True)
    module = tmp_path / "mower/mower/topics.py"
    module.write_text(
        "# bringup-lint: ignore-file[node/topic-name-invalid]: renamed by a bridge\n" + module.read_text()
    )
    run = lint("--select", "node", "--output-format", "concise", ".", cwd=tmp_path)
    assert "topic-name-invalid" not in run.stdout
