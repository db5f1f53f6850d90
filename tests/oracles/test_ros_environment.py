"""What bringup-lint says about values of ROS variables, against the real rcl and Fast DDS of the wheels."""

from __future__ import annotations

import random
from pathlib import Path

import pytest

from bringup_lint.parsers.ros_values import MAX_DOMAIN
from bringup_lint.parsers.ros_values import RMW_IMPLEMENTATIONS
from bringup_lint.parsers.ros_values import domain_id
from bringup_lint.toml import read_toml
from tests.lint import lint
from tests.oracles.answers import Oracle
from tests.oracles.ros_node import Started
from tests.oracles.ros_node import start
from tests.oracles.ros_python import rclpy

VALUES = read_toml((Path(__file__).parent / "ros_environment.toml").read_text("utf-8"))
TEXTS = 300
UNIT = """[Service]
EnvironmentFile=/etc/robot/ros.env
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch demo drivers.launch.py'
"""
READ_ONCE = ("RMW_", "RCUTILS_")
"""Variables that a process reads only at its first context."""


def verdict(folder: Path, name: str, value: str) -> list[str]:
    """The messages about the meaning of a value, errors and warnings."""
    (folder / "etc/robot").mkdir(parents=True, exist_ok=True)
    (folder / "etc/systemd/system").mkdir(parents=True, exist_ok=True)
    (folder / "etc/systemd/system/robot.service").write_text(UNIT)
    (folder / "etc/robot/ros.env").write_text(f"{name}='{value}'\n")
    run = lint("--target-ros", "jazzy", "--select", "env", "--output-format", "concise", ".", cwd=folder)
    lines = [line for line in run.stdout.splitlines() if line.startswith("etc/robot/ros.env:1:")]
    return [line for line in lines if "[env/ros-domain-id-ephemeral]" not in line]


def trouble(name: str, value: str, real: Started) -> str:
    """Why the real thing does not do what is written; empty when it does."""
    if not real.running:
        return "does not start"
    if name == "ROS_DOMAIN_ID":
        as_written = str(real.domain) == value and real.domain <= MAX_DOMAIN
        return "" if value == "" or as_written else f"domain {real.domain}"
    if name == "ROS_LOCALHOST_ONLY":
        meant = {"": None, "0": "disabled", "1": "enabled"}.get(value, "one of 0 and 1")
        return "" if meant is None or f"'localhost_only' is {meant}" in real.output else f"not {meant}"
    if name == "RCUTILS_CONSOLE_OUTPUT_FORMAT":
        return "printed as it is" if "{" in real.output else ""
    complaints = ("Invalid value", "unexpected value")
    silent = "" if "hello" in real.output else "no log"
    return next((words for words in complaints if words in real.output), silent)


def is_there(name: str, value: str) -> bool:
    """The wheels bring one middleware; another one that exists can't be tried."""
    return name != "RMW_IMPLEMENTATION" or value not in RMW_IMPLEMENTATIONS or value == "rmw_fastrtps_cpp"


def troubles(name: str, values: list[str]) -> list[str]:
    started = start([{name: value} for value in values], each_alone=name.startswith(READ_ONCE))
    return [trouble(name, value, answer) for value, answer in zip(values, started, strict=True)]


@pytest.mark.parametrize("name", VALUES)
def test_values(name: str, answers: Oracle, tmp_path: Path) -> None:
    values = [value for value in VALUES[name] if is_there(name, value)]
    real = dict(answers.of(f"rcl/{name.lower()}", rclpy(), values, lambda values: troubles(name, values)).pairs)
    said = {value: verdict(tmp_path, name, value) for value in real}
    flagged = {value for value in real if said[value]}
    assert flagged == {value for value in real if real[value]}, (said, real)
    assert any(real.values()) and not all(real.values())


def switches(values: list[str]) -> list[str]:
    """What the values of ROS_LOCALHOST_ONLY mean."""
    started = start([{"ROS_LOCALHOST_ONLY": value} for value in values], node=False)
    return ["enabled" if "'localhost_only' is enabled" in answer.output else "disabled" for answer in started]


def test_localhost_only_means_what_the_message_says(answers: Oracle, tmp_path: Path) -> None:
    values = [value for value in VALUES["ROS_LOCALHOST_ONLY"] if value not in ("", "0", "1")]
    for value, means in answers.of("rcl/localhost", rclpy(), values, switches).pairs:
        assert f"means {means}" in verdict(tmp_path, "ROS_LOCALHOST_ONLY", value)[0]


@pytest.mark.skipif(rclpy() == "rclpy", reason="needs ros-jazzy-rclpy")
def test_logging_that_fails_does_not_stop_the_process() -> None:
    (answer,) = start([{"RCUTILS_COLORIZED_OUTPUT": "true"}])
    assert answer.running
    assert "hello" not in answer.output
    assert len(answer.output) > 10_000


def domains(texts: list[str]) -> list[int | None]:
    return [answer.domain for answer in start([{"ROS_DOMAIN_ID": text} for text in texts], node=False)]


def test_every_domain_id_is_read_as_rcl_reads_it(answers: Oracle) -> None:
    chance = random.Random(3)
    letters = " +-0123456789xXaAfF.\t_;,'"
    made = ["".join(chance.choices(letters, k=chance.randint(1, 5))) for _ in range(TEXTS)]
    given = answers.of("rcl/domains", rclpy(), [*VALUES["ROS_DOMAIN_ID"], *made], domains)
    wrong = {text: (real, domain_id(text)) for text, real in given.pairs if real != domain_id(text).number}
    assert wrong == {}
    assert sum(real is not None for _, real in given.pairs) > TEXTS // 5
