"""Run by an interpreter that has ROS's own launch: start every file for real and print what its processes see, as JSON.

Usage: python launch_environment_runner.py FILE... ; every process must write its environment to a file in the working
folder, whose name tells it from the others.
"""

from __future__ import annotations

import json
import logging
import os
import sys
import tempfile
from pathlib import Path

from launch import LaunchDescription
from launch import LaunchService
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import AnyLaunchDescriptionSource


def environments(path: str) -> dict[str, dict[str, str]]:
    before = dict(os.environ)
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        service = LaunchService(noninteractive=True)
        service.include_launch_description(
            LaunchDescription([IncludeLaunchDescription(AnyLaunchDescriptionSource(path))])
        )
        code = service.run()
        found = {each.name: pairs(each.read_text()) for each in Path(folder).iterdir()}
        os.chdir("/")
    os.environ.clear()
    os.environ.update(before)
    return {"code": code, "processes": found}


def pairs(text: str) -> dict[str, str]:
    return dict(line.split("=", 1) for line in text.splitlines() if "=" in line)


if __name__ == "__main__":
    logging.disable(logging.CRITICAL)
    print(json.dumps({path: environments(path) for path in sys.argv[1:]}))
