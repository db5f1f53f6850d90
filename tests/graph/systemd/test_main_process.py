"""What becomes of the shells that start a robot's programs: which process systemd supervises in the end."""

from __future__ import annotations

from pathlib import Path

import pytest

from bringup_lint.discover.walk import discover
from bringup_lint.robot import Robot

SETUP = "source /opt/ros/jazzy/setup.bash"
LAUNCH = "ros2 launch rover base.launch.py"


def main_of(folder: Path, line: str) -> str:
    (folder / "one.service").write_text(f"[Service]\nExecStart={line}\n")
    robot = Robot(discover([str(folder)]))
    return robot.units.supervision(robot.units.services[0]).main.kind


@pytest.mark.parametrize(
    ("line", "kind"),
    [
        (f"/bin/bash -c '{SETUP} && exec {LAUNCH}'", "launch"),
        (f"/bin/bash -c '{SETUP}; {LAUNCH}'", "launch"),
        (f"/bin/bash -c '{SETUP} && {LAUNCH} map:=\"a b\"'", "launch"),
        (f"/bin/bash -lc '{SETUP} && {LAUNCH}'", "launch"),
        (f"/bin/bash -o pipefail -c '{SETUP} && {LAUNCH}'", "launch"),
        (f"/bin/bash -c 'exec \"$@\"' rover {LAUNCH}", "launch"),
        (f"/bin/sh -c '. /opt/ros/jazzy/setup.sh && {LAUNCH}'", "shell"),
        (f"/bin/sh -c '. /opt/ros/jazzy/setup.sh && exec {LAUNCH}'", "launch"),
        (f"/bin/bash -c '{SETUP} && {LAUNCH}; echo done'", "shell"),
        (f"/bin/bash -c '{SETUP} && {LAUNCH} | tee /tmp/log'", "shell"),
        (f"/bin/bash -c '{LAUNCH} &'", "shell"),
        (f"/bin/bash -c 'trap cleanup EXIT; {LAUNCH}'", "shell"),
        (f"/bin/bash -c 'if true; then {LAUNCH}; fi'", "shell"),
        (f"/bin/bash -c 'if true; then exec {LAUNCH}; fi'", "unknown"),
        ("/bin/bash -c 'exec ros2 run rover base'", "run"),
        ("/bin/bash -c 'exec nice -n 5 /opt/rover/install/rover/lib/rover/base'", "node"),
        ("/opt/ros/jazzy/lib/demo_nodes_cpp/talker", "node"),
        (f"/ros_entrypoint.sh {LAUNCH}", "launch"),
        ("/usr/bin/docker run --rm rover ros2 launch rover base.launch.py", "container"),
        ("/bin/bash /opt/rover/lost.sh", "lost"),
        ("/opt/rover/lost.sh", "lost"),
        ("/usr/bin/python3 -u /opt/rover/node.py", "python"),
        ("/usr/bin/socat - -", "program"),
        ("$PROGRAM", "unknown"),
        ("/opt/rover/stays.sh", "shell"),
        (f"/opt/rover/entry.sh {LAUNCH}", "launch"),
        ("/opt/rover/replaced.sh", "launch"),
        ("/opt/rover/tool", "python"),
    ],
)
def test_main_process(tmp_path: Path, line: str, kind: str) -> None:
    scripts = tmp_path / "opt" / "rover"
    scripts.mkdir(parents=True)
    (scripts / "stays.sh").write_text(f"#!/bin/bash\n{SETUP}\n{LAUNCH}\n")
    (scripts / "replaced.sh").write_text(f"#!/bin/bash\nset -e\n{SETUP}\nexec {LAUNCH}\n")
    (scripts / "entry.sh").write_text(f'#!/bin/bash\n{SETUP}\nexec "$@"\n')
    (scripts / "tool").write_text("#!/usr/bin/env python3\nimport rclpy\n")
    assert main_of(tmp_path, line) == kind
