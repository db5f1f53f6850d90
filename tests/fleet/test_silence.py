"""Findings of a fleet can be silenced everywhere, and what silences nothing is reported."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import pytest

from tests.lint import lint
from tests.rules.test_fixtures import case_id
from tests.rules.test_fixtures import cases
from tests.rules.test_fixtures import set_modes
from tests.sample import sampled

CASES = [(rule_id, case) for rule_id, case in cases("bad") if rule_id.startswith("fleet/")]
TRIED = sampled(CASES, 6, pytest.mark.slow)


def copied(case: Path, to: Path) -> Path:
    """A fixture, with an inventory."""
    set_modes(case)
    folder = shutil.copytree(case, to, symlinks=True)
    if not (folder / "fleet.toml").exists():
        robots = sorted(each.name for each in (folder / "robots").iterdir())
        entries = [f'[[robot]]\nname = "{name}"\nroot = "robots/{name}"\n' for name in robots]
        (folder / "fleet.toml").write_text("\n".join(entries))
    return folder


def judged(folder: Path, *arguments: str) -> dict[str, Any]:
    options = ("--workers", "1", "--now", "2026-01-15", "--min-severity", "info")
    arguments = arguments if "--select" in arguments else ("--select", "fleet,lint", *arguments)
    run = lint("fleet", *options, "--output-format", "json", *arguments, ".", cwd=folder)
    assert run.code in (0, 1), run.stderr + run.stdout
    return json.loads(run.stdout)


def accept(folder: Path, text: str) -> None:
    with (folder / "fleet.toml").open("a") as file:
        file.write(f"\n[[accept]]\n{text}\n")


@pytest.mark.parametrize(("rule_id", "case"), TRIED, ids=case_id)
def test_accepting_silences(rule_id: str, case: Path, tmp_path: Path) -> None:
    folder = copied(case, tmp_path / "fleet")
    before = judged(folder)["findings"]
    accept(folder, f'rule = "{rule_id}"\nreason = "known"')
    after = judged(folder)["findings"]
    assert [each["message"] for each in after] == [each["message"] for each in before]
    assert {each["accepted"] for each in after if each["rule"] == rule_id} == {"known"}
    assert judged(folder, "--no-ignores")["findings"] == before


@pytest.mark.parametrize(("rule_id", "case"), TRIED, ids=case_id)
def test_configuration_silences(rule_id: str, case: Path, tmp_path: Path) -> None:
    folder = copied(case, tmp_path / "fleet")
    (folder / "bringup-lint.toml").write_text(f'[per-file-ignores]\n"robots/" = ["{rule_id}"]\n')
    by_path = [each["accepted"] for each in judged(folder)["findings"] if each["rule"] == rule_id]
    assert set(by_path) == {"per-file-ignores of bringup-lint.toml"}
    (folder / "bringup-lint.toml").write_text(f'[severity]\n"{rule_id}" = "off"\n')
    assert [each for each in judged(folder)["findings"] if each["rule"] == rule_id] == []


@pytest.fixture
def pair(tmp_path: Path) -> Path:
    for name in ("one", "two"):
        (tmp_path / name / "etc").mkdir(parents=True)
        (tmp_path / name / "etc/machine-id").write_text("0" * 32 + "\n")
    robots = '[[robot]]\nname = "one"\nroot = "one"\n\n[[robot]]\nname = "two"\nroot = "two"\n'
    (tmp_path / "fleet.toml").write_text(robots)
    return tmp_path


def test_a_pattern_for_one_robot_does_not_silence_what_two_share(pair: Path) -> None:
    (pair / "bringup-lint.toml").write_text('[per-file-ignores]\n"one/" = ["fleet"]\n')
    assert [each["accepted"] for each in judged(pair)["findings"]] == [""]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ('rule = "fleet/same-host-name"', ["fleet/same-host-name finds nothing that is accepted here"]),
        ('rule = "fleet/same-machine-id"\nkey = "x"', ["fleet/same-machine-id finds nothing that is accepted here"]),
        ('rule = "fleet/same-machine-id"\nrobots = ["on"]', ["No robot of the fleet is called 'on'"]),
        ('rule = "fleet/same-machine-id"', []),
        ('rule = "fleet"', []),
    ],
)
def test_what_is_accepted_for_nothing_is_reported(pair: Path, text: str, said: list[str]) -> None:
    accept(pair, f'{text}\nreason = "known"')
    unused = [each for each in judged(pair)["findings"] if each["rule"] == "lint/unused-ignore"]
    assert [each["message"] for each in unused] == said
    assert {(each["places"][0]["path"], each["places"][0]["line"]) for each in unused} <= {("fleet.toml", 9)}


def test_rules_that_did_not_run_prove_nothing(pair: Path) -> None:
    accept(pair, 'rule = "fleet/same-host-name"\nreason = "known"')
    assert judged(pair, "--select", "lint")["findings"] == []


def test_the_summary_counts_what_is_silenced_on_single_robots(pair: Path) -> None:
    for name in ("one", "two"):
        (pair / name / "etc/systemd/system").mkdir(parents=True)
        unit = "[Service]\n# bringup-lint: ignore[systemd/legacy-key] -- old\nStandardOutput=syslog\nExecStart=/bin/a\n"
        (pair / name / "etc/systemd/system/a.service").write_text(unit + "StandardError=syslog\n")
    (pair / "bringup-lint.toml").write_text('[per-file-ignores]\n"one/" = ["systemd/legacy-key"]\n')
    said = judged(pair, "--select", "systemd/legacy-key")
    assert [each["suppressed_by"] for each in said["robots"]] == [
        {"bringup-lint.toml": 1, "comments": 1},
        {"comments": 1},
    ]
    assert said["summary"]["suppressed_by"] == {"bringup-lint.toml": 1, "comments": 2}
    run = lint("fleet", "--workers", "1", "--select", "systemd/legacy-key", ".", cwd=pair)
    assert "On single robots: 1 suppressed by bringup-lint.toml, 2 suppressed by comments: --no-ignores\n" in run.stdout
    page = lint("fleet", "--workers", "1", "--select", "systemd/legacy-key", "--output-format", "html", ".", cwd=pair)
    assert "1 suppressed by bringup-lint.toml" in page.stdout
    assert judged(pair, "--select", "systemd/legacy-key", "--no-ignores")["summary"]["suppressed_by"] == {}
