"""The robot with one defect for each rule that joins layers: mending one removes its finding and changes no other."""

from __future__ import annotations

import json
import shutil
from collections import Counter
from pathlib import Path

import pytest

from bringup_lint.toml import read_toml
from tests.conftest import PROJECT
from tests.lint import lint
from tests.test_fixtures import set_modes

ROBOT = PROJECT / "fixtures" / "robots" / "crosslayer"
DEFECTS = read_toml((ROBOT / "defects.toml").read_text("utf-8"))
ARGUMENTS = ("--root", ".", "--min-severity", "info", "--output-format", "json", "/")
PAGE = PROJECT / "docs" / "cross-layer.md"
Found = tuple[str, str, str]


@pytest.fixture(scope="module")
def robot(tmp_path_factory: pytest.TempPathFactory) -> Path:
    copy = tmp_path_factory.mktemp("crosslayer")
    shutil.copytree(ROBOT, copy, symlinks=True, dirs_exist_ok=True)
    set_modes(copy)
    return copy / "tree"


@pytest.fixture(scope="module")
def before(robot: Path) -> Counter[Found]:
    return findings(robot)


def findings(tree: Path) -> Counter[Found]:
    """Rule, file and message of what is found; lines move when something is mended above them."""
    run = lint(*ARGUMENTS, cwd=tree)
    assert run.code in (0, 1), run.stderr
    found = [each for each in json.loads(run.stdout)["findings"] if not each["suppressed"]]
    return Counter((each["rule"], each["location"]["path"], each["message"]) for each in found)


@pytest.mark.parametrize("rule", sorted(DEFECTS))
def test_mending_a_defect_removes_its_finding_alone(rule: str, robot: Path, before: Counter[Found]) -> None:
    defect = DEFECTS[rule]
    kept = {name: (robot / name).read_text("utf-8") for name, _, _ in defect["edits"]}
    try:
        for name, old, new in defect["edits"]:
            text = (robot / name).read_text("utf-8")
            assert text.count(old) == 1, f"{old!r} in {name}"
            (robot / name).write_text(text.replace(old, new), "utf-8")
        after = findings(robot)
    finally:
        for name, text in kept.items():
            (robot / name).write_text(text, "utf-8")
    gone = [(found[0], found[1]) for found in before - after]
    assert (gone, list(after - before)) == ([(rule, defect["file"])], [])


def test_every_finding_is_a_planted_defect(before: Counter[Found]) -> None:
    assert {(rule, file) for rule, file, _ in before} == {(rule, defect["file"]) for rule, defect in DEFECTS.items()}
    assert set(before.values()) == {1}


def test_chains_lead_from_a_unit_to_the_defect(robot: Path) -> None:
    run = lint("--select", "device/link-undefined", *ARGUMENTS, cwd=robot)
    (found,) = json.loads(run.stdout)["findings"]
    places = [step["path"].rpartition("/")[2] for step in (each["location"] for each in found["chain"])]
    assert places == [
        "curlew-drivers.service",
        "curlew-drivers",
        "drivers.launch.py",
        "lidar.launch.py",
        "lidar.launch.py",
        "lidar.yaml",
    ]


def test_page_lists_every_rule(update_expected: bool) -> None:
    text = PAGE.read_text("utf-8")
    expected = text[: text.index(TABLE)] + table()
    if update_expected:
        PAGE.write_text(expected, "utf-8")
    assert PAGE.read_text("utf-8") == expected


TABLE = "| rule | found at | held against | edges |"


def table() -> str:
    rows = [TABLE, "|---|---|---|---|"]
    for rule, defect in DEFECTS.items():
        one, other = defect["between"]
        rows.append(f"| `{rule}` | {one} | {other} | {defect['edges'].replace(' ', ', ')} |")
    return "\n".join(rows) + "\n"
