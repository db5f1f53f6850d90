"""Files that repeat very much what a layer looks at are judged in linear time."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import pytest

from bringup_lint.discover.walk import discover
from bringup_lint.robot import Robot
from bringup_lint.source import Source
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


def early_members(size: int) -> str:
    used = " + ".join(["buffer_"] * size * 4)
    return BOAT.format(f'Boat() : Node("boat"), listener_({used}) {{}}\nListener listener_;\nBuffer buffer_;\n')


def branches(size: int) -> str:
    chain = "".join(f" else if (wind == {at}) {{ reef(); }}" for at in range(size * 4))
    return BOAT.format("") + f"void turn(int wind) {{ if (wind == 0) {{ reef(); }}{chain} }}\n"


def unmade(size: int) -> str:
    turns = "".join(f"void Sail{at}::turn() {{ if (a) {{}} else if (a) {{}} }}\n" for at in range(size))
    return BOAT.format("") + "class Sail\n" * size * 4 + f";\n{turns}"


def spun(size: int) -> str:
    spins, returns = "rclcpp::spin(boat);\n" * size, "if (dry) return 0;\n" * size
    return BOAT.format("") + f"int main() {{ try {{ {spins} }} catch (const std::exception & e) {{}}\n{returns} }}\n"


LOST = "try { seen = buffer_->lookupTransform(a, b, c); } catch (const tf2::TransformException & e) { printf(e); }\n"


def looked_up(size: int) -> str:
    return BOAT.format(f"void row() {{ geometry_msgs::msg::TransformStamped seen;\n{LOST * size} }}\n")


def shut(size: int) -> str:
    return BOAT.format(f"Boat() {{ {'if (!port_) { rclcpp::shutdown(); }' * size} }}\n")


def started(size: int) -> str:
    threads = "std::thread one(&Boat::row, this);\nstd::thread two([this] { row(); });\n" * size
    return BOAT.format(f"void start() {{ {threads} }}\nvoid row() {{ {'pull(); throw 1;' * size} }}\n")


def saved(size: int) -> str:
    row = "std::ofstream file(path_); given->success = true;\n" * size
    return BOAT.format(f"void save() {{ {row} auto inner = [&] {{ {row} }}; }}\n")


def asked_parts(size: int) -> str:
    row = 'std::string given = send_command("a"); speed = given.substr(2, 3);\n' * size
    return BOAT.format(f"void row() {{ {row} }}\nstd::string send_command(A a) {{ return read(a); }}\n")


def opened_ports(size: int) -> str:
    row = 'try { port_.Open("/dev/ttyUSB0"); } catch (const std::exception & e) { printf("shut"); }\n' * size
    return BOAT.format(f"LibSerial::SerialPort port_;\nvoid row() {{ {row} }}\n")


def guarded(size: int) -> str:
    values = "int first = wind; int second = first;\n" + "first = second; second = first;\n" * size
    start = "tick_ = create_wall_timer(1s, std::bind(&Boat::tick, this));"
    tick = f"void tick() {{ {values} if (second > 2) {{ speed = knots_; }} {'if (dry) return;' * size} knots_ = 1; }}\n"
    return BOAT.format(f"double knots_;\nBoat() {{ {start} }}\n{tick}")


def ends(size: int) -> str:
    row = "if (handle->is_canceling()) { pull(); }\nif (dry) { handle->canceled(given); }\n" * size
    return BOAT.format(f"void row() {{ {row} }}\n")


def switched(size: int) -> str:
    row = "".join(f'declare_parameter<bool>("dry{each}", "false");\n' for each in range(size * 3))
    return BOAT.format(f'Boat() : Node("boat") {{ {row} }}\n')


@pytest.mark.slow
@pytest.mark.parametrize(
    ("rule", "made"),
    [
        ("node/bool-from-text", switched),
        ("node/component-ends-container", ended),
        ("node/transform-unhandled", looked_up),
        ("node/shutdown-goes-on", shut),
        ("node/thread-throws", started),
        ("node/write-unchecked", saved),
        ("node/member-unset", guarded),
        ("node/goal-canceled-unasked", ends),
        ("node/answer-short", asked_parts),
        ("node/device-unchecked", opened_ports),
        ("node/log-format-foreign", logged),
        ("node/duration-cut", waited),
        ("node/thread-not-joined", joined),
        ("node/lifecycle-declares-again", configured),
        ("node/signal-handler-waits", handled),
        ("node/qos-command-best-effort", published),
        ("node/service-answer-unread", answered),
        ("node/member-early", early_members),
        ("node/failure-exits-zero", spun),
        ("node/branch-repeated", branches),
        ("node/branch-repeated", unmade),
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


def functions(size: int) -> str:
    names = range(size)
    return "".join(f"f{each}() {{ ls; }}\n" for each in names) + "if check_$1; then :; fi\n"


def counts(size: int) -> str:
    names = range(size)
    return "".join(f"n{each}=0\n" for each in names) + "".join(f"((n{each}++))\n" for each in names)


def asked_flags(size: int) -> str:
    return "".join(f'busy={at}\nif [ "$busy" ]; then ls; fi\n' for at in range(size * 4))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("rule", "made"),
    [
        ("script/status-never-seen", functions),
        ("script/count-ends-script", counts),
        ("script/count-ends-script", lambda size: f"n=0\n((n++))\necho {'eval ' * size * 5}\n"),
        ("script/count-ends-script", lambda size: f"ls\n# (({' ' * size * 20}\n"),
        ("script/yes-ends-script", lambda size: f"set -o pipefail\n{'yes | ' * size * 5}cat\n"),
        ("script/second-run-ends", lambda size: "".join(f"mkdir /opt/rover{each}x\n" for each in range(size * 5))),
        ("script/second-run-ends", lambda size: f"mkdir /opt/rover\necho {'[ ' * size * 10}\n"),
        ("script/error-page-stored", lambda size: f"curl https://a.b/c -o /opt/rover\necho {'sum ' * size * 10}\n"),
        ("script/condition-always-true", asked_flags),
        ("script/kill-without-stop", lambda size: f"pkill -9 ros2\ntrue {'docker ' * size * 10}\n"),
        ("script/syntax", lambda size: "".join(f"sed s/@TOKEN{at}@/x/ a\n" for at in range(size * 10))),
        ("script/apt-asks", lambda size: "".join(f"n{at}=0\n" for at in range(size * 4)) + "apt install rover\n"),
        ("script/apt-asks", lambda size: f"{'apt install rover; ' * size * 2}\n"),
        ("script/status-never-seen", lambda size: "".join(f"x=$(grep a b)\nx=${{x:-{at}}}\n" for at in range(size))),
        (
            "script/second-run-ends",
            lambda size: "".join(f"cd /a{at}\ngit clone https://a.b/c{at}\n" for at in range(size)),
        ),
    ],
)
def test_time_grows_as_what_a_script_repeats(rule: str, made: Callable[[int], str], tmp_path: Path) -> None:
    def check(size: int) -> None:
        (tmp_path / "start.sh").write_text(f"#!/bin/bash\nset -e\n{made(size)}")
        lint("--no-cache", "--quiet", "--select", rule, ".", cwd=tmp_path)

    assert is_linear(check, 160)


def shells(size: int) -> str:
    return "FROM ros:jazzy\n" + 'SHELL ["/bin/bash", "-c"]\nRUN apt-get install -y rover\n' * size


def copies(size: int) -> str:
    builds = "RUN colcon build --symlink-install\n" * size
    brought = "".join(f"COPY --from=0 /w{at}/install /w{at}/install\n" for at in range(size))
    return f"FROM ros:jazzy\n{builds}FROM ros:jazzy\n{brought}"


def middleware(size: int) -> str:
    taken = "COPY --from=made /ws/install /ws/install\n" * size
    made = "FROM ros:jazzy AS made\n" + "RUN colcon build\n" * size
    return f"{made}FROM ros:jazzy\nENV RMW_IMPLEMENTATION=rmw_zenoh_cpp\n{taken}CMD ros2 run boat row\n"


@pytest.mark.slow
def test_time_grows_as_what_a_called_script_needs(tmp_path: Path) -> None:
    (tmp_path / "tools").mkdir()
    (tmp_path / "README.md").write_text("    bash tools/start.sh\n")

    def check(size: int) -> None:
        for at in range(size):
            (tmp_path / f"tools/a{at}.txt").touch()
        lines = "".join(f"cp a{at}.txt /opt\n" for at in range(size))
        (tmp_path / "tools/start.sh").write_text(f"#!/bin/bash\nset -e\n{lines}")
        lint("--no-cache", "--quiet", "--select", "script/called-from-elsewhere", ".", cwd=tmp_path)

    assert is_linear(check, 100)


def stages(size: int) -> str:
    steps = 'SHELL ["/bin/bash", "-c"]\nRUN yes | apt-get install rover\n'
    return f"FROM ros:jazzy AS s0\n{steps}" + "".join(f"FROM s{at} AS s{at + 1}\n{steps}" for at in range(size))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("rule", "made"),
    [
        ("docker/run-without-effect", lambda size: "FROM ros:jazzy\n" + "RUN cd /rover\n" * size),
        ("docker/built-for-host", lambda size: f"FROM --platform=$BUILDPLATFORM rover\n# platform:{' ' * size * 20}\n"),
        ("script/apt-asks", lambda size: f"FROM ros:jazzy\nRUN {'apt-get install -y rover && ' * size * 3}:\n"),
        ("script/yes-ends-script", stages),
        ("docker/failure-hidden", shells),
        ("env/rmw-package-missing", middleware),
        ("env/rmw-package-missing", lambda size: middleware(0) + f"RUN {'rosdep git curl ' * size * 5}\n"),
        ("docker/links-left-behind", copies),
        ("docker/links-left-behind", lambda size: f"FROM ros:jazzy\nRUN {'rm -r ' * size * 5}\n"),
    ],
)
def test_time_grows_as_what_a_dockerfile_repeats(rule: str, made: Callable[[int], str], tmp_path: Path) -> None:
    def check(size: int) -> None:
        (tmp_path / "Dockerfile").write_text(made(size))
        lint("--no-cache", "--quiet", "--select", rule, ".", cwd=tmp_path)

    assert is_linear(check, 160)


@pytest.mark.slow
@pytest.mark.parametrize("step", ["chmod 1 ", "mkdir a "])
def test_time_grows_as_what_a_step_of_an_image_repeats(step: str, tmp_path: Path) -> None:
    (tmp_path / "compose.yaml").write_text("services:\n  rover:\n    build: .\n    volumes: [maps:/var/maps]\n")

    def check(size: int) -> None:
        (tmp_path / "Dockerfile").write_text(f"FROM ros:jazzy\nRUN {step * size}\nUSER rover\n")
        (tmp_path / "start.sh").write_text(f"#!/bin/bash\n{step * size}\n")
        lint("--no-cache", "--quiet", "--select", "compose/mount-of-root", ".", cwd=tmp_path)

    assert is_linear(check, 800)


@pytest.mark.slow
def test_time_grows_as_the_units_that_a_script_installs(tmp_path: Path) -> None:
    def check(size: int) -> None:
        for at in range(size):
            unit = "[Service]\nExecStart=/opt/rover/part\n[Install]\nWantedBy=multi-user.target\n"
            (tmp_path / f"part{at}.service").write_text(unit)
        lines = "".join(f"cp part{at}.service /etc/systemd/system/\n" for at in range(size))
        (tmp_path / "install.sh").write_text(f"#!/bin/bash\n{lines}")
        lint("--no-cache", "--quiet", "--select", "systemd/never-enabled", ".", cwd=tmp_path)

    assert is_linear(check, 30)


@pytest.mark.slow
def test_time_grows_as_the_units_that_name_one_that_is_gone(tmp_path: Path) -> None:
    def check(size: int) -> None:
        for at in range(size):
            unit = "[Unit]\nAfter=pulseaudio.service\n[Service]\nExecStart=/opt/rover/part\n"
            (tmp_path / f"part{at}.service").write_text(unit)
        lint("--no-cache", "--quiet", "--select", "systemd/missing-wanted-unit", ".", cwd=tmp_path)

    assert is_linear(check, 60)


@pytest.mark.slow
def test_time_grows_as_the_tags_that_scripts_ask_for(tmp_path: Path) -> None:
    def check(size: int) -> None:
        task = "    - name: row\n      ansible.builtin.apt:\n        name: oar\n      tags: [row]\n"
        (tmp_path / "deploy.yml").write_text(f"- hosts: all\n  tasks:\n{task * size}")
        lines = "".join(f"ansible-playbook deploy.yml --tags part{at}\n" for at in range(size))
        (tmp_path / "deploy.sh").write_text(f"#!/bin/bash\n{lines}")
        lint("--no-cache", "--quiet", "--select", "script/ansible-tag-missing", ".", cwd=tmp_path)

    assert is_linear(check, 60)


@pytest.mark.slow
def test_time_grows_as_the_units_beside_each_other(tmp_path: Path) -> None:
    def check(size: int) -> None:
        for at in range(size):
            unit = f"[Service]\nExecStart=/bin/bash -c 'ros2 launch rover part{at}.launch.py'\n"
            (tmp_path / f"part{at}.service").write_text(unit)
        lines = "".join(f"cp part{at}.service /etc/systemd/system\n" for at in range(size // 2))
        (tmp_path / "install.sh").write_text(f"#!/bin/bash\n{lines}")
        lint("--no-cache", "--quiet", "--select", "systemd/restart-missing", ".", cwd=tmp_path)

    assert is_linear(check, 30)


NODE = "import rclpy\n\nrclpy.init()\n"


def attributes(size: int) -> str:
    a_class = "class C{0}:\n    def get(self):\n        return self.a{0}\n\n\nC{0}().b{0} = 1\n"
    return NODE + "".join(a_class.format(at) for at in range(size))


def objects(size: int) -> str:
    methods = "".join(f"    def row{at}(self):\n        self.a{at} = 1\n\n" for at in range(size))
    calls = "".join(f"boat.row{at}()\nprint(boat.b{at})\n" for at in range(size))
    return f"{NODE}class Boat:\n{methods}\nboat = Boat()\n{calls}"


def failed_calls(size: int) -> str:
    calls = "        x = get()\n" * size * 8
    return f"{NODE}def read():\n    try:\n{calls}    except Exception:\n        pass\n    print(x)\n"


def constructor(body: str) -> str:
    start = "class Boat(Node):\n    def __init__(self):\n        super().__init__('boat')\n"
    return f"from rclpy.node import Node\n\n\n{start}{body}        self.create_timer(1.0, self.row)\n"


def given_up_with_flags(size: int) -> str:
    ends = "            return\n"
    branches = (
        f"        if dry:\n            self.get_logger().error('dry')\n            self.flag{at} = 1\n{ends}"
        for at in range(size)
    )
    return constructor("".join(branches)) + "".join(f"print(boat.flag{at})\n" for at in range(size))


def calls_of_method(size: int) -> str:
    gives_up = "        if dry:\n            self.get_logger().error('dry')\n            return\n"
    looks = "        f(1)\n" * size
    return f"{constructor(gives_up + looks.replace('f(1)', 'self.look()'))}    def look(self):\n{looks}"


@pytest.mark.slow
@pytest.mark.parametrize(
    ("rule", "made"),
    [
        ("node/undefined-attribute", attributes),
        ("node/undefined-attribute", objects),
        ("node/call-misfit", objects),
        ("node/unbound-local", failed_calls),
        ("node/constructor-gives-up", given_up_with_flags),
        ("node/constructor-gives-up", calls_of_method),
    ],
)
def test_time_grows_as_what_a_python_file_repeats(rule: str, made: Callable[[int], str], tmp_path: Path) -> None:
    def check(size: int) -> None:
        (tmp_path / "boat.py").write_text(made(size))
        lint("--no-cache", "--quiet", "--select", rule, ".", cwd=tmp_path)

    assert is_linear(check, 160)


def test_a_condition_of_very_many_calls_is_no_error(tmp_path: Path) -> None:
    tick = f"void tick() {{ if (wind{'.gust()' * 3_000}) {{ speed = knots_; }} knots_ = 1; }}\n"
    start = "Boat() { tick_ = create_wall_timer(1s, std::bind(&Boat::tick, this)); }\n"
    (tmp_path / "boat.cpp").write_text(BOAT.format(f"double knots_;\n{start}{tick}"))
    found = lint("--no-cache", "--quiet", "--select", "node/member-unset", ".", cwd=tmp_path)
    assert "internal-error" not in found.stdout + found.stderr


def test_a_name_of_very_many_parts_is_no_error(tmp_path: Path) -> None:
    long = "a." * 900
    gives_up = f"        if dry:\n            {long}error('dry')\n            return\n"
    (tmp_path / "boat.py").write_text(f"{constructor(gives_up)}\n\nclass Row({long}b):\n    pass\n\n\nRow()\n")
    found = lint("--no-cache", "--quiet", "--select", "node", ".", cwd=tmp_path)
    assert "internal-error" not in found.stdout + found.stderr


def test_a_stage_is_not_numbered_by_a_digit_that_is_none(tmp_path: Path) -> None:
    (tmp_path / "Dockerfile").write_text("FROM ros:jazzy AS made\nFROM ros:jazzy\nCOPY --from=\u00b2 /a /b\n")
    found = lint("--no-cache", "--quiet", "--select", "docker/distribution-ended", ".", cwd=tmp_path)
    assert "internal-error" not in found.stdout + found.stderr


@pytest.mark.slow
def test_time_grows_as_the_services_that_start_a_job(tmp_path: Path) -> None:
    def check(size: int) -> None:
        wanted = "".join(f"WantedBy=rover{at}.service\n" for at in range(size))
        unit = f"[Service]\nType=oneshot\nExecStart=/opt/rover/up\n\n[Install]\n{wanted}"
        (tmp_path / "up.service").write_text(unit)
        lint("--no-cache", "--quiet", "--select", "systemd/job-not-before", ".", cwd=tmp_path)

    assert is_linear(check, 800)


def test_a_stage_may_have_any_number(tmp_path: Path) -> None:
    (tmp_path / "Dockerfile").write_text(f"FROM ros:jazzy\nCOPY --from={'9' * 5_000} /a/install /b\n")
    found = lint("--no-cache", "--quiet", "--select", "docker", ".", cwd=tmp_path)
    assert "internal-error" not in found.stdout + found.stderr


@pytest.mark.parametrize("function", ["{\n}", "{", "(\n)", ""])
def test_a_function_of_a_script_may_have_nothing_in_it(function: str, tmp_path: Path) -> None:
    (tmp_path / "start.sh").write_text(f"#!/bin/bash\nset -e\nrow_a() {function}\nx=$(grep a b)\nx=${{x:-1}}\nrow_b\n")
    found = lint("--no-cache", "--quiet", "--select", "script", ".", cwd=tmp_path)
    assert "internal-error" not in found.stdout + found.stderr


@pytest.mark.parametrize("count", ["\u00b2", "9" * 5_000])
def test_a_count_may_be_any_number_or_none(count: str, tmp_path: Path) -> None:
    service = f"    image: rover:1\n    container_name: rover\n    scale: {count}\n    group_add: ['{count}']\n"
    devices = f"    devices: [/dev/ttyUSB0]\n    user: rover:{count}\n"
    (tmp_path / "compose.yaml").write_text(f"services:\n  rover:\n{service}{devices}")
    found = lint("--no-cache", "--quiet", "--select", "compose", ".", cwd=tmp_path)
    assert "internal-error" not in found.stdout + found.stderr


MAIN = "def main():\n    pass\n\n\n"
HERE = "        row()  # here\n"


def handed_on(size: int) -> str:
    calls, asks = "    pull(hard)\n" * size, f"    if hard:\n{HERE}" * size
    return f"{MAIN}def pull(hard=False):\n{calls}{asks}\n\npull()\n"


def built_on_each_other(size: int) -> str:
    names = [f"Boat{at}" for at in range(min(size, 40))]
    classes = (f"class {name}({', '.join(names)}):\n    def pull{name}(self):\n{HERE}" for name in names)
    return MAIN + "".join(classes) + "#" * size * 20


def uncalled_functions(size: int) -> str:
    return MAIN + "".join(f"def pull{at}():\n    pull{at + 1}()\n{HERE[4:]}" for at in range(size))


def called_alike(size: int) -> str:
    return MAIN + f"class Boat:\n    def pull(self):\n        self.pull()\n{HERE}" * size


def set_by_each_other(size: int) -> str:
    sets = "".join(f"        self.a{at} = self.a{at + 1}\n        self.a{at} = self.a{at + 2}\n" for at in range(size))
    asks = "".join(f"        if self.a{at}:\n    {HERE}" for at in range(size))
    return f"{MAIN}class Boat:\n    def __init__(self):\n{sets}{asks}"


@pytest.mark.slow
@pytest.mark.parametrize("made", [handed_on, built_on_each_other, uncalled_functions, called_alike, set_by_each_other])
def test_time_grows_as_the_code_that_may_never_run(made: Callable[[int], str], tmp_path: Path) -> None:
    def check(size: int) -> None:
        (tmp_path / "boat.py").write_text(made(size))
        robot = Robot(discover([str(tmp_path)]))
        source = Source(str(tmp_path / "boat.py"), made(size))
        for found in re.finditer("here", source.text):
            robot.leads_to(source.span(*found.span()))

    assert is_linear(check, 50)


@pytest.mark.parametrize(
    "head",
    [
        f"@boat{'.row' * 900}\ndef pull():\n    if True:\n",
        f"def pull():\n    if {'not ' * 900}True:\n",
        f"def pull():\n    if {'(a or not ' * 150}True{')' * 150}:\n",
        f"class Boat(boat{'.row' * 900}):\n    def pull(self):\n",
    ],
)
def test_code_of_very_many_parts_is_no_error(head: str, tmp_path: Path) -> None:
    text = f"{head}{HERE}\n\n{MAIN}pull()\n"
    (tmp_path / "boat.py").write_text(text)
    source = Source(str(tmp_path / "boat.py"), text)
    at = text.index("here")
    assert Robot(discover([str(tmp_path)])).leads_to(source.span(at, at + 4))


PACKAGE = """<package format="3">
  <name>boat</name>
  <version>1.0.0</version>
  <description>Boat</description>
  <maintainer email="boat@example.com">Boat</maintainer>
  <license>MIT</license>
  <export><build_type>ament_python</build_type></export>
</package>
"""


def python_package(folder: Path, module: str) -> None:
    """A package with one module, of which it makes a program."""
    (folder / "boat").mkdir(exist_ok=True)
    (folder / "boat/__init__.py").touch()
    (folder / "boat/row.py").write_text(f"import os\nfrom pathlib import Path\n\n{module}")
    (folder / "package.xml").write_text(PACKAGE)
    setup = "name='boat', packages=['boat'], entry_points={'console_scripts': ['row = boat.row:main']}"
    (folder / "setup.py").write_text(f"from setuptools import setup\n\nsetup({setup})\n")


@pytest.mark.parametrize(
    "path",
    [
        f"__file__{' + str(1)' * 900}",
        f"Path(__file__){'.parent' * 900}",
        f"boat{'.at()' * 900}",
        f"Path(__file__).parents[{'9' * 12}]",
    ],
)
def test_a_path_of_very_many_steps_is_no_error(path: str, tmp_path: Path) -> None:
    python_package(tmp_path, f"PLACE = {path}\nif {path}:\n    PLACE = None\n")
    found = lint("--no-cache", "--quiet", "--select", "package/data-not-installed", ".", cwd=tmp_path)
    assert "internal-error" not in found.stdout + found.stderr


@pytest.mark.slow
def test_time_grows_as_the_files_beside_a_module(tmp_path: Path) -> None:
    def check(size: int) -> None:
        python_package(tmp_path, "".join(f"P{at} = os.path.join(__file__, 'a{at}')\n" for at in range(size)))
        lint("--no-cache", "--quiet", "--select", "package/data-not-installed", ".", cwd=tmp_path)

    assert is_linear(check, 400)
