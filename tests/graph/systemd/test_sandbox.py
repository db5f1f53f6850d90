"""What a service may write, and where its nodes log. The cases were tried on systemd 252."""

from __future__ import annotations

from pathlib import Path

import pytest

from bringup_lint.discover.walk import discover
from bringup_lint.graph.systemd.questions.log_directory import LogDirectory
from bringup_lint.graph.systemd.questions.log_directory import log_directory
from bringup_lint.graph.systemd.sandbox import Sandbox
from bringup_lint.graph.systemd.units import Units
from bringup_lint.robot import Robot


def units_of(folder: Path, *lines: str) -> Units:
    text = "\n".join(["[Service]", "ExecStart=/opt/ros/jazzy/lib/rover/arm", *lines])
    (folder / "one.service").write_text(text + "\n")
    return Robot(discover([str(folder)])).units


def sandbox(folder: Path, *lines: str) -> Sandbox:
    units = units_of(folder, *lines)
    return units.sandbox(units.services[0])


def log_of(folder: Path, *lines: str) -> LogDirectory | None:
    units = units_of(folder, *lines)
    return log_directory(units, units.started(units.services[0])[0])


@pytest.mark.parametrize(
    ("lines", "path", "mode"),
    [
        (["ProtectSystem=strict"], "/srv/x", "ro"),
        (["ProtectSystem=strict"], "/home/rover/.ros", "rw"),
        (["ProtectSystem=strict"], "/root/.ros", "rw"),
        (["ProtectSystem=strict"], "/dev/shm/x", "rw"),
        (["ProtectSystem=strict"], "/tmp/x", "ro"),
        (["ProtectSystem=strict", "PrivateTmp=yes"], "/tmp/x", "rw"),
        (["ProtectSystem=strict", "PrivateTmp=disconnected"], "/tmp/x", "rw"),
        (["ProtectSystem=strict", "PrivateTmp=no"], "/tmp/x", "ro"),
        (["ProtectSystem=strict", "LogsDirectory=rover"], "/var/log/rover/a", "rw"),
        (["ProtectSystem=strict", "ReadWritePaths=-/var/lib/rover"], "/var/lib/rover/a", "rw"),
        (["ProtectSystem=strict", "ReadWritePaths=/srv", "ReadWritePaths="], "/srv/a", "ro"),
        (["ProtectSystem=full"], "/etc/x", "ro"),
        (["ProtectSystem=yes"], "/usr/share/x", "ro"),
        (["ProtectHome=yes", "ReadWritePaths=/home/rover"], "/home/rover/a", "hidden"),
        (["ProtectHome=tmpfs", "BindPaths=/home/rover"], "/home/rover/a", "rw"),
        (["ProtectHome=tmpfs"], "/home/rover/a", "empty"),
        (["ProtectHome=read-only", "ReadWritePaths=/home/rover"], "/home/rover/a", "rw"),
        (["DynamicUser=yes"], "/srv/x", "ro"),
        (["DynamicUser=yes"], "/var/tmp/x", "rw"),
        (["InaccessiblePaths=/srv"], "/srv/x", "hidden"),
    ],
)
def test_view(tmp_path: Path, lines: list[str], path: str, mode: str) -> None:
    assert sandbox(tmp_path, *lines).view(path).mode == mode


@pytest.mark.parametrize(
    ("lines", "path"), [([], "/srv/x"), (["ProtectSystem=full"], "/srv/x"), (["ProtectHome=no"], "/home/a")]
)
def test_nothing_restricts(tmp_path: Path, lines: list[str], path: str) -> None:
    assert sandbox(tmp_path, *lines).view(path) is None


@pytest.mark.parametrize(
    ("lines", "path"),
    [
        (["User=rover"], "/home/rover/.ros/log"),
        (["User=rover", "Environment=ROS_LOG_DIR=/var/log/rover/"], "/var/log/rover"),
        (["User=rover", "Environment=ROS_HOME=/var/lib/rover"], "/var/lib/rover/log"),
        (["User=rover", "Environment=HOME=/srv/rover"], "/srv/rover/.ros/log"),
        (["DynamicUser=yes"], None),
    ],
)
def test_log_directory(tmp_path: Path, lines: list[str], path: str | None) -> None:
    log = log_of(tmp_path, *lines)
    assert log is not None
    assert log.path == path


@pytest.mark.parametrize("lines", [["User=%i"], ["User=1000"], ["EnvironmentFile=/etc/rover.env"], []])
def test_log_directory_is_not_known(tmp_path: Path, lines: list[str]) -> None:
    assert log_of(tmp_path, *lines) is None
