"""Who logs in where, by the commands of scripts."""

from __future__ import annotations

from pathlib import Path

import pytest

from bringup_lint.discover.walk import discover
from bringup_lint.graph.host.ssh_commands import ssh_logins
from bringup_lint.robot import Robot


@pytest.mark.parametrize(
    ("command", "found"),
    [
        ("ssh rover@10.0.0.2 true", [("rover", "rover@10.0.0.2")]),
        ("scp rover@10.0.0.2:a rover@10.0.0.3:b", [("rover", "rover@10.0.0.2:a")]),
        ("ssh git@github.com", []),
    ],
)
def test_logins(command: str, found: list[tuple[str, str]], tmp_path: Path) -> None:
    (tmp_path / "deploy.sh").write_text(f"#!/bin/sh\n{command}\n")
    robot = Robot(discover([str(tmp_path)]))
    assert [(user, str(word)) for user, word, _ in ssh_logins(robot.files)] == found
