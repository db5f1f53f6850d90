"""Copies of one file: what holds for all of them alike is said once."""

from __future__ import annotations

import json
from pathlib import Path

from tests.lint import lint

UNIT = "[Unit]\nDescription=Arm\n\n[Service]\nExecStart=/opt/robot/bin/arm\nRestrt=always\n"
ASKED = ("--isolated", "--exit-zero", "--select", "systemd/unknown-key")


def write(tree: Path, units: dict[str, str]) -> None:
    for robot, text in units.items():
        folder = tree / robot
        folder.mkdir()
        (folder / "arm.service").write_text(text, "utf-8")


def test_copies_are_one_finding(tmp_path: Path) -> None:
    write(tmp_path, {"kite": UNIT, "lark": UNIT, "wren": UNIT})
    (found,) = json.loads(lint(*ASKED, "--output-format", "json", ".", cwd=tmp_path).stdout)["findings"]
    assert [each["location"]["path"] for each in found["related"]] == ["lark/arm.service", "wren/arm.service"]
    assert "= copies: lark/arm.service:6:1\n" in lint(*ASKED, ".", cwd=tmp_path).stdout
    assert lint(*ASKED, "--output-format", "concise", ".", cwd=tmp_path).stdout.endswith(
        "(also at lark/arm.service:6:1, wren/arm.service:6:1)\n"
    )


def test_a_file_that_differs_is_no_copy(tmp_path: Path) -> None:
    write(tmp_path, {"kite": UNIT, "lark": UNIT.replace("Arm", "The arm")})
    found = json.loads(lint(*ASKED, "--output-format", "json", ".", cwd=tmp_path).stdout)["findings"]
    assert [each["location"]["path"] for each in found] == ["kite/arm.service", "lark/arm.service"]
    assert [each["related"] for each in found] == [[], []]
