"""The interpreter that has ROS's own launch, which BRINGUP_LINT_ROS_PYTHON names; and rclpy, where this one has it."""

from __future__ import annotations

import importlib.metadata
import importlib.util
import os
import subprocess
from functools import cache

PYTHON = os.environ.get("BRINGUP_LINT_ROS_PYTHON", "")
_VERSION = "import launch, launch_xml, launch_yaml, importlib.metadata as m; print(m.version('launch'))"


@cache
def tool() -> str:
    """Such as ``launch 3.4.3``; without the number where no interpreter is named, or where it lacks the packages."""
    if not PYTHON:
        return "launch"
    environment = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
    run = subprocess.run([PYTHON, "-c", _VERSION], capture_output=True, text=True, env=environment, check=False)
    return f"launch {run.stdout.strip()}".strip()


def rclpy() -> str:
    """Such as ``rclpy 7.1.1``; without the number where it is not installed."""
    if importlib.util.find_spec("rclpy") is None:
        return "rclpy"
    return f"rclpy {importlib.metadata.version('ros-jazzy-rclpy')}"
