"""No output shows a planted secret, though findings are on the lines beside it."""

from __future__ import annotations

from pathlib import Path

import pytest

from bringup_lint.discover.kinds import HEAD_SIZE
from bringup_lint.discover.kinds import kind_of
from bringup_lint.report import FORMATS
from bringup_lint.source import Source
from bringup_lint.suppress.forms import form_of
from tests.conftest import PROJECT
from tests.lint import lint
from tests.report.planted import Planted
from tests.report.planted import planted

OUTPUTS = (
    ("--output-format", "text"),
    *(("graph", "--format", name) for name in ("dot", "mermaid", "json", "html")),
    ("--diff", "--unsafe-fixes", "--min-severity", "info"),
)


def annotated(each: Planted, path: str) -> str:
    """The text with a comment without effect above the statement that shows the secret."""
    form = form_of(Source(path, each.text, kind_of(path, lambda: each.text[:HEAD_SIZE])))
    if form is None:
        return each.text
    lines = each.text.split("\n")
    at = next(number for number, line in enumerate(lines) if each.secret in line)
    at -= at > 0 and "=" in lines[at - 1] and "<" in lines[at - 1]
    indent = lines[at][: len(lines[at]) - len(lines[at].lstrip(" "))]
    lines.insert(at, indent + form("bringup-lint: ignore[udev/label-unused]"))
    return "\n".join(lines)


@pytest.fixture(scope="module")
def tree(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("planted")
    for number, each in enumerate(planted()):
        path = folder / f"robot{number}" / each.file
        path.parent.mkdir(parents=True)
        path.write_text(annotated(each, each.file))
    return folder


@pytest.mark.slow
@pytest.mark.parametrize("output", OUTPUTS, ids=" ".join)
def test_output_shows_no_secret(tree: Path, output: tuple[str, ...]) -> None:
    run = lint(*output, cwd=tree)
    assert run.code in (0, 1), run.stderr
    text = run.stdout + run.stderr
    assert len(text) > 500
    assert [each for each in planted() if each.secret in text] == []


@pytest.fixture(scope="module")
def folder(tree: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The reports of one run, each in a file with the name of its format."""
    folder = tmp_path_factory.mktemp("reports")
    each = [("--output-format", name, "--output-file", str(folder / name)) for name in FORMATS]
    run = lint(*(word for words in each for word in words), cwd=tree)
    assert run.code in (0, 1), run.stderr
    assert run.stdout == ""
    return folder


@pytest.mark.slow
@pytest.mark.parametrize("name", FORMATS)
def test_report_shows_no_secret(folder: Path, name: str) -> None:
    text = (folder / name).read_text("utf-8")
    assert len(text) > 500
    assert [each for each in planted() if each.secret in text] == []


def test_baseline_holds_no_secret(tree: Path, tmp_path: Path) -> None:
    lint("--write-baseline", tmp_path / "known.json", cwd=tree)
    text = (tmp_path / "known.json").read_text()
    assert [each for each in planted() if each.secret in text] == []


@pytest.mark.slow
@pytest.mark.parametrize("each", planted(), ids=lambda each: f"{each.file}-{each.secret}")
def test_explain_repeats_no_secret(each: Planted, tmp_path: Path) -> None:
    run = lint("explain", f"qqqq\n{each.text}", cwd=tmp_path)
    assert each.secret not in run.stdout + run.stderr


@pytest.mark.parametrize("output", FORMATS)
def test_live_shows_no_secret(tree: Path, output: str) -> None:
    seen = PROJECT / "fixtures/live/qos_incompatible/bad/graph.yaml"
    run = lint("live", "--load", seen, "--select", "lint,live", "--output-format", output, cwd=tree)
    assert run.code in (0, 1), run.stderr
    assert len(run.stdout) > 500
    assert [each for each in planted() if each.secret in run.stdout + run.stderr] == []


def test_findings_are_beside_secrets(tree: Path) -> None:
    run = lint("--output-format", "concise", "--select", "lint", cwd=tree)
    assert run.stdout.count("lint/ignore-without-reason") > 150
