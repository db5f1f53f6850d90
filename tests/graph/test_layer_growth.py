"""Files that repeat very much what a layer looks at are judged in linear time."""

from __future__ import annotations

from collections.abc import Callable
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


def node_with_flags(flags: int) -> str:
    names = range(flags)
    start = "".join(f"        self.busy{at} = False\n" for at in names)
    asks = "".join(f"        if self.busy{at}:\n            return\n" for at in names)
    sets = "".join(f"        self.busy{at} = True\n" for at in names)
    return f"""import rclpy
from rclpy.action import ActionClient
from rclpy.node import Node


class Driver(Node):
    def __init__(self):
        super().__init__("driver")
{start}        self.client = ActionClient(self, Dock, "dock")
        self.create_timer(1.0, self.tick)

    def tick(self):
{asks}{sets}        self.client.send_goal_async(Dock.Goal()).add_done_callback(self.answered)

    def answered(self, future):
        handle = future.result()
        if not handle.accepted:
            return
        handle.get_result_async().add_done_callback(self.done)

    def done(self, future):
{start}"""


@pytest.mark.slow
def test_time_grows_as_the_flags_of_a_node(tmp_path: Path) -> None:
    def check(size: int) -> None:
        (tmp_path / "driver.py").write_text(node_with_flags(size))
        lint("--no-cache", "--quiet", "--select", "node/goal-rejected-busy", ".", cwd=tmp_path)

    assert is_linear(check, 60)


def node_with_choices(choices: int) -> str:
    numbers = range(choices)
    made = "".join(f"        if self.given{at}:\n            value{at} = 1\n" for at in numbers)
    used = "".join(f"        print(value{at})\n" for at in numbers)
    return f"""import rclpy
from rclpy.node import Node


class Sorter(Node):
    def __init__(self):
        super().__init__("sorter")
        self.create_timer(1.0, self.tick)

    def tick(self):
{made}{used}

rclpy.init()
rclpy.spin(Sorter())
"""


@pytest.mark.slow
def test_time_grows_as_the_names_that_a_choice_alone_gives_a_value(tmp_path: Path) -> None:
    def check(size: int) -> None:
        (tmp_path / "sorter.py").write_text(node_with_choices(size))
        lint("--no-cache", "--quiet", "--select", "node/unbound-local,node/undefined-attribute", ".", cwd=tmp_path)

    assert is_linear(check, 250)


NODE = """import rclpy
import serial
from rclpy.node import Node


class Winch(Node):
    def __init__(self):
        super().__init__("winch")
        self.port = serial.Serial("/dev/winch", 9600)
        self.create_subscription(Twist, "pull", self.pull, 10)

    def pull(self, msg):
        if msg.is_cancel_requested:
            return
{}

def main():
    rclpy.init()
    rclpy.spin(Winch())
"""
STATEMENTS = {
    "node/blocking-in-callback": "        self.port.readline()\n",
    "node/zero-divisor": "        if self.asks:\n            pass\n        turn = 1.0 / msg.angular.z\n",
    "node/goal-canceled-unasked": "        turn = asked()\n        if self.busy:\n            msg.canceled()\n",
}
"""What one callback repeats."""


@pytest.mark.slow
@pytest.mark.parametrize(("rule", "statement"), STATEMENTS.items())
def test_time_grows_as_the_statements_of_a_node(rule: str, statement: str, tmp_path: Path) -> None:
    def check(size: int) -> None:
        (tmp_path / "winch.py").write_text(NODE.format(statement * size))
        lint("--no-cache", "--quiet", "--select", rule, ".", cwd=tmp_path)

    assert is_linear(check, 200)


BOAT = "#include <rclcpp/rclcpp.hpp>\nclass Boat : public rclcpp_lifecycle::LifecycleNode {{\n{}}};\n"


def configured(size: int) -> str:
    steps = "".join(f"R Boat{each}::on_configure() {{ setup(); }}\n" for each in range(size))
    return BOAT.format(f"void setup() {{ {'row(1);' * size} }}\n") + steps


def handled(size: int) -> str:
    handlers = (f'void stop{each}(int number) {{ RCLCPP_INFO(log, "ends"); }}\n' for each in range(size))
    made = (f"signal(SIGINT, stop{each});\n" for each in range(size))
    return f"#include <rclcpp/rclcpp.hpp>\n{''.join(handlers)}int main() {{ rclcpp::Node node; {''.join(made)} }}\n"


def published(size: int) -> str:
    made = 'q.reliable();\nqueue_ = create_publisher<std_msgs::msg::String>("depth", q);\n'
    return BOAT.format(f"void make() {{ rclcpp::QoS q(1);\n{made * size} }}\n")


def answered(size: int) -> str:
    answers = "return false;\n" * size
    made = 'service_ = create_service<S>("row", std::bind(&Boat::row, this, _1, _2));'
    row = f"bool row(const S::SharedPtr asked, S::SharedPtr given) {{\n{answers} given->speed = 1; return true; }}\n"
    return BOAT.format(f"{row}void make() {{ {made} }}\n")


def joined(size: int) -> str:
    runs = (f"void run{each}() {{ row(); }}\nstd::thread t{each}_;\n" for each in range(size))
    starts = (f"t{each}_ = std::thread(&Boat::run{each}, this);\n" for each in range(size))
    joins = (f"t{each}_.join();\n" for each in range(size))
    made = f"{''.join(runs)}void start() {{ {''.join(starts)} }}\nR on_cleanup() {{ {''.join(joins)} }}\n"
    return BOAT.format(made)


def ended(size: int) -> str:
    calls = "".join(f"exit({each});\n" for each in range(size))
    return BOAT.format(f"Boat() {{ {calls} }}\n") + "RCLCPP_COMPONENTS_REGISTER_NODE(Boat)\n"


def logged(size: int) -> str:
    return BOAT.format(f"void row() {{ {''.join(f'RCLCPP_INFO(log, t{each}.c_str());' for each in range(size))} }}\n")


def waited(size: int) -> str:
    calls = (f"sleep_for(std::chrono::seconds(static_cast<int>(t{each})));\n" for each in range(size))
    return BOAT.format(f"void row() {{ {''.join(calls)} }}\n")


@pytest.mark.slow
@pytest.mark.parametrize(
    ("rule", "made"),
    [
        ("node/component-ends-container", ended),
        ("node/log-format-foreign", logged),
        ("node/duration-cut", waited),
        ("node/thread-not-joined", joined),
        ("node/lifecycle-declares-again", configured),
        ("node/signal-handler-waits", handled),
        ("node/qos-command-best-effort", published),
        ("node/service-answer-unread", answered),
    ],
)
def test_time_grows_as_what_a_cpp_file_repeats(rule: str, made: Callable[[int], str], tmp_path: Path) -> None:
    def check(size: int) -> None:
        (tmp_path / "boat.cpp").write_text(made(size))
        lint("--no-cache", "--quiet", "--select", rule, ".", cwd=tmp_path)

    assert is_linear(check, 100)


@pytest.mark.slow
def test_time_grows_as_the_guarded_declarations_of_a_python_node(tmp_path: Path) -> None:
    def check(size: int) -> None:
        asks = (f"        if self.first{at}:\n            self.declare_parameter('p{at}', 1)\n" for at in range(size))
        head = "from rclpy.lifecycle import LifecycleNode\n\n\nclass Boat(LifecycleNode):\n"
        (tmp_path / "boat.py").write_text(f"{head}    def on_configure(self, state):\n{''.join(asks)}")
        lint("--no-cache", "--quiet", "--select", "node/lifecycle-declares-again", ".", cwd=tmp_path)

    assert is_linear(check, 100)


@pytest.mark.slow
def test_time_grows_as_the_services_of_one_container_name(tmp_path: Path) -> None:
    def check(size: int) -> None:
        services = (f"  rover{each}:\n    image: rover:1\n    container_name: rover\n" for each in range(size))
        (tmp_path / "compose.yaml").write_text(f"services:\n{''.join(services)}")
        lint("--no-cache", "--quiet", "--select", "compose/container-name-shared", ".", cwd=tmp_path)

    assert is_linear(check, 50)


@pytest.mark.slow
def test_time_grows_as_the_variables_of_a_script(tmp_path: Path) -> None:
    def check(size: int) -> None:
        lines = (f"PART_{each}x=1\necho $PART_{each}y $PART_ONE_{each}q\n" for each in range(size))
        (tmp_path / "start.sh").write_text(f"#!/bin/bash\n{''.join(lines)}")
        lint("--no-cache", "--quiet", "--select", "script/misspelt-variable", ".", cwd=tmp_path)

    assert is_linear(check, 50)
