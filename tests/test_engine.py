"""Adding rules, failing rules, suppression and fixes."""

from __future__ import annotations

import json
import textwrap
from pathlib import Path
from typing import Any

import pytest

from bringup_lint import budget
from bringup_lint.discover.held import Held
from bringup_lint.engine import Outcome
from bringup_lint.engine import run
from bringup_lint.model.unit import UnitFile
from bringup_lint.source import Source
from tests.lint import lint

RULE = '''
"""Units must not be called legacy.

## What it finds
A unit called legacy.

## Why it matters on a robot
It is old.

## Bad
```
legacy.service
```

## Good
```
robot.service
```

## When to ignore it
Never.

## References
- none
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("warning", fix="safe")
def no_legacy(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("systemd-unit"):
        at = source.text.find("/bin/legacy")
        if at >= 0:
            word = source.located(at + 5, at + 11)
            BODY
'''
REPORT = 'yield finding(word, "legacy is gone", fix=fix("rename", (word, "modern")))'


@pytest.fixture
def tree(tmp_path: Path) -> Path:
    (tmp_path / "robot.service").write_text("[Service]\n# old\nExecStart=/bin/legacy\n")
    return tmp_path


def own_rule(folder: Path, body: str = REPORT, name: str = "no_legacy") -> Path:
    path = folder / "own" / "site"
    path.mkdir(parents=True, exist_ok=True)
    (path / f"{name}.py").write_text(textwrap.dedent(RULE).lstrip().replace("BODY", body).replace("no_legacy", name))
    return path.parent


def run_own(tree: Path, *arguments: str):
    return lint("--rules", tree / "own", "--select", "site", "--select", "lint", "--output-format", "concise",
                *arguments, "robot.service", cwd=tree)  # fmt: skip


def test_a_rule_is_one_file(tree: Path) -> None:
    own_rule(tree)
    assert run_own(tree).stdout == "robot.service:3:16: warning[site/no-legacy] legacy is gone\n"


@pytest.mark.parametrize(
    ("rule", "finding", "reported"),
    [
        ("high", "", "high"),
        ("medium", "", "medium"),
        ("high", ', confidence="medium"', "medium"),
        ("medium", ', confidence="high"', "medium"),
    ],
)
def test_confidence_is_the_rules_and_a_finding_can_only_lower_it(
    tree: Path, rule: str, finding: str, reported: str
) -> None:
    folder = own_rule(tree, body=f'yield finding(word, "legacy is gone"{finding})')
    path = folder / "site/no_legacy.py"
    path.write_text(path.read_text().replace('fix="safe")', f'confidence="{rule}")'))
    run = lint("--rules", "own", "--select", "site", "--output-format", "json", "robot.service", cwd=tree)
    assert [found["confidence"] for found in json.loads(run.stdout)["findings"]] == [reported]


def test_failing_rule_is_reported_and_the_others_run(tree: Path) -> None:
    own_rule(tree)
    own_rule(tree, body="raise KeyError(word)", name="broken")
    run = run_own(tree)
    assert run.code == 3
    assert "lint/internal-error" in run.stdout
    assert "site/broken failed: KeyError in broken.py" in run.stdout
    assert "[site/no-legacy]" in run.stdout


def test_failing_parser_is_reported_and_the_other_files_are_checked(
    tree: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from bringup_lint.graph.systemd import unit_loading
    from bringup_lint.parsers import unit

    def parse(source):
        if "broken" in source.name:
            raise IndexError(source.name)
        return unit.parse(source)

    monkeypatch.setattr(unit_loading, "parse", parse)
    (tree / "broken.service").write_text("[Service]\nExecStart=/bin/true\n")
    own_rule(tree, body="yield finding(word, str([unit.name for unit in robot.units.judged]))")
    run = lint("--rules", "own", "--select", "site", "--output-format", "concise", ".", cwd=tree)
    assert run.code == 3
    assert "reading broken.service failed: IndexError" in run.stdout
    assert "['robot.service']" in run.stdout


def test_a_rule_that_never_ends_is_stopped_and_the_others_run(tree: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(budget, "RULE", 0.2)
    own_rule(tree)
    own_rule(tree, body="while True: pass", name="endless")
    run = run_own(tree)
    assert run.code == 1
    assert "Not judged whole: the rule site/endless takes more than 0 seconds" in run.stdout
    assert "[site/no-legacy]" in run.stdout


def test_a_parser_that_never_ends_is_stopped_and_the_other_files_are_checked(
    tree: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from bringup_lint.graph.systemd import unit_loading
    from bringup_lint.parsers import unit

    def parse(source: Source) -> UnitFile:
        while "endless" in source.name:
            pass
        return unit.parse(source)

    monkeypatch.setattr(budget, "FILE", 0.2)
    monkeypatch.setattr(unit_loading, "parse", parse)
    (tree / "endless.service").write_text("[Service]\nExecStart=/bin/true\n")
    own_rule(tree, body="yield finding(word, str([unit.name for unit in robot.units.judged]))")
    run = lint("--rules", "own", "--select", "site", "--output-format", "concise", ".", cwd=tree)
    assert run.code == 1
    assert "endless.service:1:1: error[lint/time-budget] Not judged: to parse it takes more than" in run.stdout
    assert "['robot.service']" in run.stdout


def test_a_c_plus_plus_source_that_takes_too_many_steps_is_reported(tree: Path) -> None:
    (tree / "relay.cpp").write_text(
        '#include "rclcpp/rclcpp.hpp"\nclass Relay : public rclcpp::Node {};\n' + "<!-- " * 20_000
    )
    run = lint("--output-format", "concise", ".", cwd=tree)
    assert run.code == 1
    assert "relay.cpp:1:1: error[lint/time-budget]" in run.stdout


def test_rules_do_not_run_when_the_time_of_the_run_is_spent(tree: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(budget, "RUN", -1)
    own_rule(tree)
    run = run_own(tree)
    assert "Not run: the rules before site/no-legacy" in run.stdout


@pytest.mark.parametrize("text", ["x = (", "import absent_module", "pass"])
def test_rule_file_that_cannot_be_loaded_exits_2(tree: Path, text: str) -> None:
    own_rule(tree)
    (tree / "own/site/no_legacy.py").write_text(text)
    run = run_own(tree)
    assert run.code == 2
    assert "no_legacy.py" in run.stderr


def test_own_rule_cannot_take_the_id_of_a_builtin_one(tree: Path) -> None:
    folder = tree / "own" / "lint"
    folder.mkdir(parents=True)
    (folder / "encoding.py").write_text("")
    assert "the id lint/encoding is taken" in run_own(tree).stderr


def suppressed(tree: Path, comment: str, *arguments: str) -> str:
    own_rule(tree)
    (tree / "robot.service").write_text(f"[Service]\n{comment}\n# old\nExecStart=/bin/legacy\n")
    return run_own(tree, *arguments).stdout


def test_comment_on_a_line_of_its_own_counts_for_the_next_line(tree: Path) -> None:
    assert suppressed(tree, "# bringup-lint: ignore[site/no-legacy] -- kept for the tests") == ""


def test_comment_can_name_a_family(tree: Path) -> None:
    assert suppressed(tree, "; bringup-lint: ignore[site] -- kept") == ""


def test_ignore_file(tree: Path) -> None:
    assert suppressed(tree, "# bringup-lint: ignore-file[site/no-legacy] -- kept") == ""


def test_several_names(tree: Path) -> None:
    out = suppressed(tree, "# bringup-lint: ignore[site/no-legacy, lint/encoding] -- kept")
    assert out == "robot.service:2:40: warning[lint/unused-ignore] ignore[lint/encoding] silences nothing here\n"


def test_missing_reason_is_asked_for(tree: Path) -> None:
    assert "lint/ignore-without-reason" in suppressed(tree, "# bringup-lint: ignore[site/no-legacy]")


def test_no_ignores_shows_all(tree: Path) -> None:
    out = suppressed(tree, "# bringup-lint: ignore[site/no-legacy] -- kept", "--no-ignores")
    assert "[site/no-legacy]" in out
    assert "lint/" not in out


def test_trailing_comment_counts_for_its_line(tree: Path) -> None:
    own_rule(tree)
    (tree / "robot.service").write_text("[Service]\nExecStart=/bin/legacy # bringup-lint: ignore[site] -- shell\n")
    assert run_own(tree).stdout == ""


def test_fix(tree: Path) -> None:
    own_rule(tree)
    run = run_own(tree, "--fix")
    assert run.code == 0
    assert (tree / "robot.service").read_text() == "[Service]\n# old\nExecStart=/bin/modern\n"
    assert "Fixed 1 finding." in run.stderr


@pytest.mark.parametrize("said", ['fix="none")', 'fix="unsafe")', ")"])
def test_a_fix_is_unsafe_unless_the_rule_says_that_it_is_safe(tree: Path, said: str) -> None:
    path = own_rule(tree) / "site/no_legacy.py"
    path.write_text(path.read_text().replace(', fix="safe")', said if said == ")" else f", {said}"))
    before = (tree / "robot.service").read_text()
    run = run_own(tree, "--fix")
    assert (tree / "robot.service").read_text() == before
    assert "Not fixed: 1 site/no-legacy (unsafe: --unsafe-fixes)" in run.stderr


@pytest.mark.parametrize("written", ["legacy", "legacy/legacy", "legacy /bin/legacy"])
@pytest.mark.parametrize("option", ["--fix", "--diff"])
def test_a_fix_after_which_as_much_is_left_is_taken_back(tree: Path, written: str, option: str) -> None:
    own_rule(tree, REPORT.replace("modern", written))
    before = (tree / "robot.service").read_text()
    run = run_own(tree, option)
    assert (tree / "robot.service").read_text() == before
    assert "Not fixed: site/no-legacy (as much would be left to fix afterwards)" in run.stderr
    assert "Fixed" not in run.stderr and "Would fix" not in run.stderr
    assert "+" not in run.stdout


@pytest.mark.parametrize("option", ["--fix", "--diff"])
@pytest.mark.parametrize("written", ["modern", "legacy"])
def test_a_round_costs_one_run(tree: Path, monkeypatch: pytest.MonkeyPatch, option: str, written: str) -> None:
    runs: list[object] = []

    def counting(*arguments: Any, **named: Any) -> Outcome:
        runs.append(arguments)
        return run(*arguments, **named)

    monkeypatch.setattr("bringup_lint.engine.run", counting)
    own_rule(tree, REPORT.replace("modern", written))
    run_own(tree, option)
    assert len(runs) == 2


@pytest.mark.parametrize("option", ["--fix", "--diff"])
def test_models_of_files_that_no_fix_changes_are_kept(tree: Path, monkeypatch: pytest.MonkeyPatch, option: str) -> None:
    again: list[str] = []
    shared = Held.shared

    def noting(held: Held, source: Source) -> Source:
        found = shared(held, source)
        again.extend([source.basename] if found is not source else [])
        return found

    monkeypatch.setattr(Held, "shared", noting)
    (tree / "robot.service").write_text("[Service]\nExecStart=/bin/x\nStartLimitInterval=9\n")
    (tree / "other.service").write_text("[Service]\nExecStart=/bin/x\n")
    lint(option, "--select", "systemd/legacy-key", cwd=tree)
    assert again == ["other.service"]


def test_suppressed_findings_are_not_fixed(tree: Path) -> None:
    before = suppressed(tree, "# bringup-lint: ignore[site/no-legacy] -- kept", "--fix")
    assert before == ""
    assert "legacy\n" in (tree / "robot.service").read_text()


def test_fix_keeps_mode_line_ends_and_byte_order_mark(tree: Path) -> None:
    own_rule(tree)
    path = tree / "robot.service"
    path.write_bytes("\ufeff[Service]\r\nExecStart=/bin/legacy\r\n".encode())
    path.chmod(0o640)
    run_own(tree, "--fix")
    assert path.read_bytes() == "\ufeff[Service]\r\nExecStart=/bin/modern\r\n".encode()
    assert path.stat().st_mode & 0o777 == 0o640


def test_fix_never_writes_through_a_link(tree: Path) -> None:
    own_rule(tree)
    (tree / "robot.service").rename(tree / "real.service")
    (tree / "robot.service").symlink_to("real.service")
    run_own(tree, "--fix")
    assert (tree / "robot.service").is_symlink()
