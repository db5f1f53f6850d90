"""What rules say under circumstances that git keeps of no fixture: owners of files, a repository around a file."""

from __future__ import annotations

import shutil
from pathlib import Path

from bringup_lint.discover.walk import discover
from bringup_lint.registry import Registry
from bringup_lint.registry import load
from bringup_lint.robot import Robot
from tests.conftest import PROJECT
from tests.lint import lint


def test_logrotate_ignores_files_of_others() -> None:
    rule_id = "logrotate/file-mode"
    robot = Robot(discover(["/"], root=str(PROJECT / "fixtures/logrotate/file_mode/good")))
    rule = load(Registry.of().paths[rule_id], rule_id)
    assert list(rule.check(robot)) == []
    for file in robot.logs.files:
        file.source.uid = 4711
    assert [(each.span.source.robot_path, each.message) for each in rule.check(robot)] == [
        ("/etc/logrotate.d/robot", "logrotate ignores the file: root does not own it"),
    ]


def test_scripts_of_a_package_around_a_launch_file_are_not_judged(tmp_path: Path) -> None:
    shutil.copytree(PROJECT / "fixtures/launch/entry_point_missing/bad", tmp_path, dirs_exist_ok=True)
    (tmp_path / ".git").mkdir()
    command = ("--select", "launch/entry-point-missing", "--output-format", "concise")
    assert "arm/setup.py" in lint(*command, ".", cwd=tmp_path).stdout
    assert lint(*command, "arm/launch/arm.launch.py", cwd=tmp_path).stdout == ""
