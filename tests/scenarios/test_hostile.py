"""Inputs that once made something fail inside or never end: the run ends, and every rule gets through."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from bringup_lint.config import Config
from bringup_lint.discover.walk import discover
from bringup_lint.engine import run
from bringup_lint.registry import Registry
from bringup_lint.robot import Robot
from tests.conftest import PROJECT
from tests.lint import lint

HOSTILE = sorted((PROJECT / "fixtures/hostile").iterdir())


@pytest.mark.parametrize("tree", HOSTILE, ids=lambda tree: tree.name)
def test_everything_gets_through(tree: Path) -> None:
    outcome = run(Robot(discover((str(tree),))), Registry.of(), Config(min_severity="info"))
    assert outcome.failures == ()
    for found in outcome.findings:
        places = [found.span, *(edit.span for edit in (found.fix.edits if found.fix else ()))]
        assert all(0 <= span.start <= span.end <= len(span.source.text) for span in places), found


@pytest.mark.parametrize("output", ["text", "sarif", "html"])
@pytest.mark.parametrize("tree", HOSTILE, ids=lambda tree: tree.name)
def test_everything_is_reported(tree: Path, output: str, tmp_path: Path) -> None:
    shutil.copytree(tree, tmp_path / "tree")
    run = lint("--min-severity", "info", "--output-format", output, "tree", cwd=tmp_path)
    assert run.code in (0, 1), run.stderr


def test_the_checks_fuzz_for_a_minute() -> None:
    assert "benchmarks/fuzz.py all -max_total_time=60" in (PROJECT / ".ci/run").read_text("utf-8")
