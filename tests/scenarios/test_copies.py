"""Copies of one file: what holds for all of them alike is said once, where one file cannot come or go by itself."""

from __future__ import annotations

import json
from pathlib import Path

from tests.lint import lint

UNIT = "[Unit]\nDescription=Arm\n\n[Service]\nExecStart=/opt/robot/bin/arm\nRestrt=always\n"
ASKED = ("--isolated", "--exit-zero", "--select", "systemd/unknown-key")


def write(tree: Path, units: dict[str, str]) -> None:
    for path, text in units.items():
        (tree / path).parent.mkdir(parents=True, exist_ok=True)
        (tree / path).write_text(text, "utf-8")


def test_copies_under_another_name_are_one_finding(tmp_path: Path) -> None:
    write(tmp_path, {"arm.service": UNIT, "left.service": UNIT, "right.service": UNIT})
    (found,) = json.loads(lint(*ASKED, "--output-format", "json", ".", cwd=tmp_path).stdout)["findings"]
    assert [each["location"]["path"] for each in found["related"]] == ["left.service", "right.service"]
    assert "= copies: left.service:6:1\n" in lint(*ASKED, ".", cwd=tmp_path).stdout
    assert lint(*ASKED, "--output-format", "concise", ".", cwd=tmp_path).stdout.endswith(
        "(also at left.service:6:1, right.service:6:1)\n"
    )


def test_files_of_several_robots_are_findings_of_their_own(tmp_path: Path) -> None:
    write(tmp_path, {"kite/arm.service": UNIT})
    lint(*ASKED, "--write-baseline", "known.json", ".", cwd=tmp_path)
    write(tmp_path, {"lark/arm.service": UNIT})
    run = lint(*ASKED, "--baseline", "known.json", "--output-format", "concise", ".", cwd=tmp_path)
    assert run.stdout.startswith("lark/arm.service:6:1: error")


def test_what_asks_for_another_change_is_no_copy(tmp_path: Path) -> None:
    settings = "driver:\n  ros__parameters:\n    port: /dev/ttyUSB1\n"
    rule = 'SUBSYSTEM=="tty", ATTRS{{idVendor}}=="0403", ATTRS{{serial}}=="{0}", SYMLINK+="{0}_port"\n'
    write(
        tmp_path,
        {
            "etc/udev/rules.d/70-tty.rules": rule.format("arm") + rule.format("lidar"),
            "config/arm.yaml": settings,
            "config/lidar.yaml": settings,
        },
    )
    asked = ("--isolated", "--exit-zero", "--select", "device/unstable-path", "--output-format", "json", ".")
    found = json.loads(lint(*asked, cwd=tmp_path).stdout)["findings"]
    assert [each["location"]["path"] for each in found] == ["config/arm.yaml", "config/lidar.yaml"]
