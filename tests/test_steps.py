"""What fails after the rules, while findings are silenced, graded, masked, drawn or rendered, costs that finding."""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest

from bringup_lint import engine
from bringup_lint import finish
from bringup_lint.finding import Finding
from bringup_lint.finding.redact import Mask
from bringup_lint.report import FORMATS
from bringup_lint.steps import failing
from bringup_lint.suppress import Ignores
from tests.lint import Run
from tests.lint import lint

UNIT = """[Unit]
After=network.target

[Service]
Environment=WIFI_PASSWORD=hunter22hunter
ExecStart=/usr/bin/ros2 launch {} a.launch.py
"""


@pytest.fixture
def tree(tmp_path: Path) -> Path:
    for name in ("good", "unlucky"):
        (tmp_path / f"{name}.service").write_text(UNIT.format(name))
    return tmp_path


def unlucky(own: Callable[..., Any], at: int) -> Callable[..., Any]:
    """A step that fails on the unlucky file, when the argument ``at`` is a finding of it."""

    def step(*arguments: Any, **options: Any) -> Any:
        if "unlucky" in arguments[at].source.name and arguments[at].rule != "lint/internal-error":
            raise KeyError(arguments[at].message)
        return own(*arguments, **options)

    return step


def check(tree: Path, output_format: str = "concise") -> Run:
    return lint("--select", "systemd/network-target", "--output-format", output_format, cwd=tree)


def assert_apart(run: Run) -> None:
    assert run.code == 3
    assert "Traceback" not in run.stderr
    assert "good.service:2:7: warning[systemd/network-target]" in run.stdout
    assert "unlucky.service:1:1: error[lint/internal-error]" in run.stdout
    assert "unlucky.service:2:7" not in run.stdout
    assert "hunter22" not in run.stdout


def test_silencing(tree: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Ignores, "apply", unlucky(Ignores.apply, 1))
    assert_apart(check(tree))


def test_grading(tree: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(engine, "_graded", unlucky(engine._graded, 0))
    assert_apart(check(tree))


def test_masking(tree: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Mask, "finding", unlucky(Mask.finding, 1))
    assert_apart(check(tree))


def test_reading_comments(tree: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from bringup_lint import suppress

    comment = "# bringup-lint: ignore[systemd/network-target]: wanted\n"
    for path in tree.iterdir():
        path.write_text(path.read_text().replace("After", f"{comment}After"))
    own = suppress.read

    def read(source: Any) -> Any:
        if "unlucky" in source.name:
            raise IndexError(source.name)
        return own(source)

    monkeypatch.setattr(suppress, "read", read)
    run = check(tree)
    assert run.code == 3
    assert "good.service" not in run.stdout
    assert "unlucky.service:3:7: warning[systemd/network-target]" in run.stdout
    assert "reading the comments in unlucky.service failed: IndexError" in run.stdout


@pytest.mark.parametrize("name", ["merged", "_comments"])
def test_steps_over_all_findings(tree: Path, monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    def fail(*arguments: object) -> None:
        raise RecursionError

    if name == "_comments":
        monkeypatch.setattr(Ignores, "complaints", fail)
    else:
        monkeypatch.setattr(engine, name, fail)
    run = check(tree)
    assert run.code == 3
    assert run.stdout.count("warning[systemd/network-target]") == 2
    assert run.stdout.count("lint/internal-error") == 1


def test_masking_that_always_fails_shows_nothing(tree: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(finish, "presented", lambda *arguments: 1 / 0)
    run = check(tree)
    assert run.code == 3
    assert "network.target" not in run.stdout
    assert "masking failed: ZeroDivisionError" in run.stdout


@pytest.mark.parametrize("output_format", FORMATS)
def test_rendering(tree: Path, monkeypatch: pytest.MonkeyPatch, output_format: str) -> None:
    module = import_module(f"bringup_lint.report.{output_format}")
    own = module.render

    def render(report: Any) -> str:
        for found in report.findings:
            if "unlucky" in found.source.name and found.rule != "lint/internal-error":
                raise ValueError(found.message)
        text: str = own(report)
        return text

    monkeypatch.setattr(module, "render", render)
    run = check(tree, output_format)
    assert run.code == 3
    assert f"rendering as {output_format} a finding of systemd/network-target failed: ValueError" in " ".join(
        run.stdout.split()
    )
    assert "good.service" in run.stdout


def test_a_picture_that_cannot_be_drawn(tree: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(finish, "_drawn", lambda *arguments: 1 / 0)
    run = check(tree, "html")
    assert run.code == 3
    assert "drawing the picture failed: ZeroDivisionError" in run.stdout
    assert "good.service" in run.stdout


def test_a_picture_that_cannot_be_rendered(tree: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from bringup_lint.report import html

    own = html.render

    def render(report: Any) -> str:
        if report.picture:
            raise ValueError
        text: str = own(report)
        return text

    monkeypatch.setattr(html, "render", render)
    run = check(tree, "html")
    assert run.code == 3
    assert "rendering as html failed: ValueError" in run.stdout
    assert run.stdout.count("systemd/network-target") >= 2


def test_a_finding_without_words_costs_itself(tree: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from bringup_lint.isolation import _validate
    from bringup_lint.source import Source

    with pytest.raises(TypeError):
        _validate(Finding(None, Source("a").whole))  # type: ignore[arg-type]


def test_failing_finds_all_by_halving() -> None:
    calls = []

    def step(part: Any) -> None:
        calls.append(part)
        if 3 in part or 700 in part:
            raise ValueError

    assert [item for item, _ in failing(range(1000), step)] == [3, 700]
    assert len(calls) < 50
