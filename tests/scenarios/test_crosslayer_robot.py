"""The robots with one defect for each rule that joins layers: fixing one removes its finding and changes no other."""

from __future__ import annotations

import json
import shutil
from collections import Counter
from pathlib import Path

import pytest

from bringup_lint.toml import read_toml
from tests.conftest import PROJECT
from tests.lint import lint
from tests.rules.test_fixtures import set_modes

ROBOTS = PROJECT / "fixtures" / "robots"
DEFECTS = {name: read_toml((ROBOTS / name / "defects.toml").read_text("utf-8")) for name in ("crosslayer", "skiff")}
ARGUMENTS = ("--root", ".", "--now", "2026-06-01", "--min-severity", "info", "--output-format", "json", "/")
PAGE = PROJECT / "docs" / "cross-layer.md"
Found = tuple[str, str, str]
BATCHES = [("crosslayer", sorted(DEFECTS["crosslayer"])[at::16]) for at in range(16)]
BATCHES += [("skiff", [rule]) for rule in DEFECTS["skiff"]]
"""Rules of different families, whose edits do not meet."""


@pytest.fixture(scope="module")
def trees(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    copies = {name: tmp_path_factory.mktemp(name) for name in DEFECTS}
    for name, copy in copies.items():
        shutil.copytree(ROBOTS / name, copy, symlinks=True, dirs_exist_ok=True)
        set_modes(copy)
    return {name: copy / "tree" for name, copy in copies.items()}


@pytest.fixture(scope="module")
def robot(trees: dict[str, Path]) -> Path:
    return trees["crosslayer"]


@pytest.fixture(scope="module")
def before(trees: dict[str, Path]) -> dict[str, Counter[Found]]:
    return {name: findings(tree) for name, tree in trees.items()}


def findings(tree: Path) -> Counter[Found]:
    """Rule, file and message of what is found; lines move when something is fixed above them."""
    run = lint(*ARGUMENTS, cwd=tree)
    assert run.code in (0, 1), run.stderr
    found = [each for each in json.loads(run.stdout)["findings"] if not each["suppressed"]]
    return Counter((each["rule"], each["location"]["path"], each["message"]) for each in found)


@pytest.mark.slow
@pytest.mark.parametrize(("name", "rules"), BATCHES, ids=[rules[0] for _, rules in BATCHES])
def test_fixing_a_defect_removes_its_finding_alone(
    name: str, rules: list[str], trees: dict[str, Path], before: dict[str, Counter[Found]]
) -> None:
    """A few at a time; when something else changes than they should, one by one."""
    defects = DEFECTS[name]

    def changed(rules: list[str]) -> tuple[set[tuple[str, str]], list[Found]]:
        return changes(trees[name], before[name], [edit for rule in rules for edit in defects[rule]["edits"]])

    def expected(rules: list[str]) -> tuple[set[tuple[str, str]], list[Found]]:
        return {(rule, defects[rule]["file"]) for rule in rules}, []

    if changed(rules) != expected(rules):
        assert {rule: changed([rule]) for rule in rules} == {rule: expected([rule]) for rule in rules}
        raise AssertionError(f"{rules} change something only together")


def changes(
    robot: Path, before: Counter[Found], edits: list[tuple[str, str, str]]
) -> tuple[set[tuple[str, str]], list[Found]]:
    """The findings that go, and those that come, when some edits are made."""
    kept = {name: (robot / name).read_text("utf-8") for name, _, _ in edits}
    try:
        for name, old, new in edits:
            text = (robot / name).read_text("utf-8")
            assert text.count(old) == 1, f"{old!r} in {name}"
            (robot / name).write_text(text.replace(old, new), "utf-8")
        after = findings(robot)
    finally:
        for name, text in kept.items():
            (robot / name).write_text(text, "utf-8")
    return {(found[0], found[1]) for found in before - after}, sorted(after - before)


@pytest.mark.parametrize("name", DEFECTS)
def test_every_finding_is_a_planted_defect(name: str, before: dict[str, Counter[Found]]) -> None:
    found, planted = before[name], DEFECTS[name]
    assert {(rule, file) for rule, file, _ in found} == {(rule, defect["file"]) for rule, defect in planted.items()}
    assert set(found.values()) == {1}


@pytest.mark.parametrize(
    ("rule", "steps"),
    [
        (
            "device/link-undefined",
            "curlew-drivers.service, curlew-drivers, drivers.launch.py, lidar.launch.py, lidar.launch.py, lidar.yaml",
        ),
        ("cyclonedds/interface-not-in-netplan", "curlew-drivers.service, ros.env, cyclonedds.xml"),
        ("fastdds/whitelist-interface-missing", "curlew-video-bridge.service, video.env, fastdds-video.xml"),
        ("env/cyclonedds-uri-file-missing", "curlew-tide.service, tide.env"),
        ("launch/plugin-missing", "curlew-perception.service, perception.launch.py"),
        ("systemd/notify-ros-launch", "curlew-health.service, health.launch.py, alive.py"),
        ("params/use-sim-time-real-robot", "curlew-survey.service, survey.launch.py, survey.launch.py, survey.yaml"),
        ("node/qos-incompatible", "curlew-watch.service, watch.launch.py, guard.py"),
        ("node/shutdown-publish-after-context", "curlew-watch.service, watch.launch.py, eye.py"),
    ],
)
def test_chains_lead_from_a_unit_to_the_defect(rule: str, steps: str, robot: Path) -> None:
    run = lint("--select", rule, *ARGUMENTS, cwd=robot)
    (found,) = json.loads(run.stdout)["findings"]
    assert ", ".join(step["location"]["path"].rpartition("/")[2] for step in found["chain"]) == steps


def test_chains_are_code_flows_and_numbered_paths(robot: Path) -> None:
    sarif = json.loads(lint("--root", ".", "--output-format", "sarif", "/", cwd=robot).stdout)
    flows = [result["codeFlows"][0]["threadFlows"] for result in sarif["runs"][0]["results"] if "codeFlows" in result]
    assert len(flows) > 30
    assert all(len(flow) == 1 and len(flow[0]["locations"]) > 1 for flow in flows)
    assert all(step["location"]["message"]["text"] for (flow,) in flows for step in flow["locations"])
    text = lint("--root", ".", "--select", "device/link-undefined", "/", cwd=robot).stdout
    assert "= path: 1. curlew-drivers.service runs curlew-drivers\n" in text
    assert "          6. /dev/curlew/lidr is opened\n" in text


def test_page_lists_every_rule(update_expected: bool) -> None:
    text = PAGE.read_text("utf-8")
    expected = text[: text.index(TABLE)] + table()
    if update_expected:
        PAGE.write_text(expected, "utf-8")
    assert PAGE.read_text("utf-8") == expected


TABLE = "| rule | found at | compared with | edges |"


def table() -> str:
    rows = [TABLE, "|---|---|---|---|"]
    for rule, defect in (each for defects in DEFECTS.values() for each in defects.items()):
        one, other = defect["between"]
        rows.append(f"| `{rule}` | {one} | {other} | {defect['edges'].replace(' ', ', ')} |")
    return "\n".join(rows) + "\n"
