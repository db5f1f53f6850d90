"""Whoever starts processes has one shape: units, compose services, images, cron lines, scripts."""

from __future__ import annotations

import textwrap
from pathlib import Path

import pytest

from bringup_lint.discover.walk import discover
from bringup_lint.discover.walk import discover_text
from bringup_lint.graph.runners.runner import RunnerKind
from bringup_lint.robot import Robot
from tests.growth import is_linear

LAUNCH = (
    "from launch import LaunchDescription\n\n\ndef generate_launch_description():\n    return LaunchDescription([])\n"
)


def robot(folder: Path, files: dict[str, str]) -> Robot:
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(textwrap.dedent(text), "utf-8")
    found = Robot(discover([str(folder)]))
    assert found.runners.all is not None and found.failures == []
    return found


RUNNERS = {
    "unit": (
        {
            "etc/systemd/system/rover.service": """\
                [Service]
                User=rover
                ExecStart=/opt/ros/jazzy/bin/ros2 launch r a.launch.py
                """
        },
        (RunnerKind.UNIT, "rover.service", "rover", "SIGTERM"),
    ),
    "service": (
        {
            "compose.yaml": """\
                services:
                  base:
                    image: ros:jazzy
                    user: rover
                    stop_signal: SIGINT
                    command: ros2 launch r a.launch.py
                """
        },
        (RunnerKind.SERVICE, "service 'base'", "rover", "SIGINT"),
    ),
    "image of a service": (
        {
            "compose.yaml": "services:\n  base:\n    build: .\n",
            "Dockerfile": """\
                FROM ros:jazzy
                USER rover
                STOPSIGNAL SIGINT
                CMD ["ros2", "launch", "r", "a.launch.py"]
                """,
        },
        (RunnerKind.SERVICE, "service 'base'", "rover", "SIGINT"),
    ),
    "image alone": (
        {"Dockerfile": 'FROM ros:jazzy\nENTRYPOINT ["/ros_entrypoint.sh"]\nCMD ros2 launch r a.launch.py\n'},
        (RunnerKind.IMAGE, "the image of Dockerfile", "root", "SIGTERM"),
    ),
    "cron": (
        {"etc/cron.d/rover": "@reboot rover . /opt/ros/jazzy/setup.sh; ros2 launch r a.launch.py\n"},
        (RunnerKind.CRON, "the @reboot line of rover", "rover", "SIGTERM"),
    ),
    "script": (
        {"scripts/start.sh": "#!/bin/bash\nros2 launch r a.launch.py\n"},
        (RunnerKind.SCRIPT, "start.sh", None, "SIGTERM"),
    ),
    "supervised program": (
        {
            "etc/supervisor/conf.d/rover.conf": """\
                [program:drive]
                command=bash -c "source /opt/ros/jazzy/setup.bash && exec ros2 launch r a.launch.py"
                user=rover
                stopsignal=INT
                """
        },
        (RunnerKind.PROGRAM, "program 'drive'", "rover", "SIGINT"),
    ),
}


@pytest.mark.parametrize("name", RUNNERS)
def test_every_maker_gives_the_same_shape(tmp_path: Path, name: str) -> None:
    files, expected = RUNNERS[name]
    (runner,) = [each for each in robot(tmp_path, files).runners.all if each.runs_ros]
    assert (runner.kind, runner.name, runner.user, runner.stop.signal) == expected
    (launch,) = runner.launches
    assert (launch.ros.package, launch.ros.target) == ("r", "a.launch.py")


def test_the_command_of_an_image_starts_its_launch_file(tmp_path: Path) -> None:
    files = {**RUNNERS["image of a service"][0], "src/r/launch/a.launch.py": LAUNCH, "src/r/package.xml": "<package/>"}
    found = robot(tmp_path, files)
    (each,) = found.runners.launches
    assert each.file is not None and each.file.source.basename == "a.launch.py"
    assert [
        edge.target.name.rpartition("/")[2]
        for edges in found.graph.out.values()
        for edge in edges
        if edge.kind == "runs"
    ] == ["a.launch.py"]


def test_scripts_are_followed_into_containers(tmp_path: Path) -> None:
    files = {
        "compose.yaml": """\
            services:
              base:
                image: lab/base:1
                volumes: ["./scripts:/opt/scripts:ro"]
                command: /opt/scripts/run.sh
            """,
        "scripts/run.sh": "#!/bin/bash\nexport ROS_DOMAIN_ID=7\nexec ros2 launch r a.launch.py\n",
    }
    (runner,) = robot(tmp_path, files).runners.all
    assert runner.starts[0].environment.text("ROS_DOMAIN_ID") == "7"


def test_a_script_that_a_unit_starts_is_no_runner_of_its_own(tmp_path: Path) -> None:
    files = {
        "etc/systemd/system/rover.service": "[Service]\nExecStart=/opt/rover/start.sh\n",
        "opt/rover/start.sh": "#!/bin/bash\nexec ros2 launch r a.launch.py\n",
    }
    assert [runner.kind for runner in robot(tmp_path, files).runners.all] == [RunnerKind.UNIT]


def test_scripts_that_call_each_other_end(tmp_path: Path) -> None:
    calls = "\n".join(["/opt/rover/a.sh", "/opt/rover/b.sh"] * 20)
    files = {
        "etc/systemd/system/rover.service": "[Service]\nExecStart=/opt/rover/a.sh\n",
        "opt/rover/a.sh": f"#!/bin/bash\n{calls}\n",
        "opt/rover/b.sh": f"#!/bin/bash\n{calls}\n",
    }
    (runner,) = robot(tmp_path, files).runners.all
    assert len(runner.lines[0].steps) == 81


def test_a_crontab_sets_variables_for_the_lines_below(tmp_path: Path) -> None:
    text = "A=1\n@reboot rover /opt/one\nA=2\nB=3\n@reboot rover /opt/two\n"
    one, two = robot(tmp_path, {"etc/cron.d/rover": text}).runners.all
    assert [one.environment.text(name) for name in "AB"] == ["1", None]
    assert [two.environment.text(name) for name in "AB"] == ["2", "3"]


@pytest.mark.parametrize("unit", ["@reboot rover /opt/rover\n", "A=1\n@reboot rover /opt/rover\n"])
def test_a_crontab_is_followed_in_linear_time(unit: str) -> None:
    def follow(size: int) -> object:
        return list(Robot(discover_text("etc/cron.d/rover", (unit * size).encode())).runners.all)

    assert is_linear(follow, 250)
