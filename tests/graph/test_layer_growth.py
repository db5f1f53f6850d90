"""Files that repeat very much what a layer looks at are judged in linear time."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.growth import is_linear
from tests.lint import lint


def launch_file(calls: int) -> str:
    lines = "".join(f"        DeclareLaunchArgument('a{at}', default_value=True),\n" for at in range(calls))
    return f"""from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument


def generate_launch_description():
    return LaunchDescription([
{lines}    ])
"""


@pytest.mark.slow
def test_time_grows_as_the_calls(tmp_path: Path) -> None:
    def check(size: int) -> None:
        (tmp_path / "robot.launch.py").write_text(launch_file(size))
        lint("--no-cache", "--quiet", "--select", "launch/call-refused", ".", cwd=tmp_path)

    assert is_linear(check, 400)


def test_a_long_path_of_a_dockerfile_keeps_nobody_busy(tmp_path: Path) -> None:
    def check(size: int) -> None:
        (tmp_path / "Dockerfile").write_text(f"FROM ros:jazzy\nRUN mkdir -p /{'a/' * size}b\nUSER rover\n")
        lint("--no-cache", "--quiet", "--select", "docker/build-without-root", ".", cwd=tmp_path)

    assert is_linear(check, 4_000)
