"""Hostile and merely unusual trees, each of a size that a real file or repository can have.

Each function writes one tree into a folder; ``SHAPES`` lists them by name.
"""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterable
from pathlib import Path

UNITS = "etc/systemd/system"
SERVICE = (
    "[Unit]\n{unit}\n[Service]\nExecStart=/usr/bin/ros2 run robot node_{n}\n\n[Install]\nWantedBy=multi-user.target\n"
)
IMPORTS = "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n\n\n"
ENTRY = "def generate_launch_description():\n"


def write(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)


def _units(folder: Path, lines: Iterable[str]) -> None:
    for n, line in enumerate(lines):
        write(folder / UNITS / f"robot-{n}.service", SERVICE.format(n=n, unit=line))


def dropins(folder: Path) -> None:
    write(folder / UNITS / "robot.service", SERVICE.format(n=0, unit="Description=Robot"))
    for n in range(5000):
        write(folder / UNITS / f"robot.service.d/{n:04}.conf", f"[Service]\nEnvironment=V{n}=1\n")


def chain(folder: Path) -> None:
    _units(folder, (f"Requires=robot-{n + 1}.service\nAfter=robot-{n + 1}.service" for n in range(5000)))


def ring(folder: Path) -> None:
    _units(folder, (f"After=robot-{(n + 1) % 5000}.service" for n in range(5000)))


def unrelated(folder: Path) -> None:
    _units(folder, (f"Description=Robot {n}" for n in range(5000)))


def web(folder: Path) -> None:
    names = [" ".join(f"robot-{n * 7 % 1000}.service" for n in range(k * 31, k * 31 + 30)) for k in range(1000)]
    _units(folder, (f"After={line}" for line in names))


def launch_python(folder: Path) -> None:
    nodes = "".join(
        f'        Node(package="robot", executable="node", name="node_{n}", remappings=[("odom", "/odom_{n}")]),\n'
        for n in range(3000)
    )
    write(folder / "launch/robot.launch.py", f"{IMPORTS}{ENTRY}    return LaunchDescription([\n{nodes}    ])\n")


def launch_xml(folder: Path) -> None:
    nodes = "".join(
        f'<node pkg="robot" exec="node" name="node_{n}"><remap from="odom" to="/odom_{n}"/></node>\n'
        for n in range(3000)
    )
    write(folder / "launch/robot.launch.xml", f"<launch>\n{nodes}</launch>\n")


def includes_deep(folder: Path) -> None:
    for n in range(200):
        write(folder / f"launch/l{n}.launch.xml", _includes([n + 1]))


def includes_twice(folder: Path) -> None:
    for n in range(40):
        write(folder / f"launch/l{n}.launch.xml", _includes([n + 1, n + 1]))


def _includes(numbers: list[int]) -> str:
    lines = "".join(f'<include file="$(dirname)/l{n}.launch.xml"/>\n' for n in numbers)
    return f"<launch>\n{lines}</launch>\n"


def parameters(folder: Path) -> None:
    values = "".join(f"    value_{n}: {n}\n" for n in range(260_000))
    write(folder / "config/robot.yaml", f"robot:\n  ros__parameters:\n{values}")


def parameter_nodes(folder: Path) -> None:
    nodes = "".join(f"node_{n}:\n  ros__parameters:\n    use_sim_time: true\n    rate: {n}\n" for n in range(52_000))
    write(folder / "config/robot.yaml", nodes)


def udev_rules(folder: Path) -> None:
    lines = "".join(
        f'SUBSYSTEM=="tty", ATTRS{{idVendor}}=="0403", ATTRS{{idProduct}}=="6001", ATTRS{{serial}}=="A{n:06}", '
        f'SYMLINK+="robot/device{n}"\n'
        for n in range(41_000)
    )
    write(folder / "etc/udev/rules.d/99-robot.rules", lines)


def xml_elements(folder: Path) -> None:
    elements = '<NetworkInterface name="eth0"/>\n' * 240_000
    write(
        folder / "cyclonedds.xml",
        f"<CycloneDDS><Domain><General><Interfaces>{elements}</Interfaces></General></Domain></CycloneDDS>",
    )


def node_classes(folder: Path) -> None:
    classes = "".join(
        f"class N{n}(Node):\n    def __init__(self):\n        super().__init__('n{n}')\n"
        f"        self.create_timer(0.1, self.tick)\n\n    def tick(self):\n        self.call_async({n})\n\n\n"
        for n in range(3000)
    )
    write(folder / "robot/nodes.py", f"import rclpy\nfrom rclpy.node import Node\n\n\n{classes}")


def launch_statements(folder: Path) -> None:
    statements = "".join(f"    x{n % 1000} = 'a{n}'\n" for n in range(200_000))
    write(
        folder / "launch/robot.launch.py",
        f"{IMPORTS}{ENTRY}{statements}    return LaunchDescription([])\n",
    )


def services(folder: Path) -> None:
    names = "".join(
        f"  s{n}:\n    image: ros:jazzy\n    command: ros2 run robot node\n    depends_on: [s{max(n - 1, 0)}]\n"
        for n in range(5000)
    )
    write(folder / "compose.yaml", f"services:\n{names}")


def interfaces(folder: Path) -> None:
    names = "".join(
        f"    eth{n}:\n      addresses: [10.{n // 250}.{n % 250}.1/16]\n"
        "      routes: [{to: default, via: 10.0.0.2}]\n"
        for n in range(5000)
    )
    write(folder / "etc/netplan/01-robot.yaml", f"network:\n  version: 2\n  ethernets:\n{names}")


def other_files(folder: Path) -> None:
    for n in range(20_000):
        write(folder / f"web/{n % 100}/{n}.json", "{}\n")
    write(folder / "robot.service", SERVICE.format(n=0, unit=""))


def links(folder: Path) -> None:
    write(folder / "robot.service", SERVICE.format(n=0, unit=""))
    for n in range(20_000):
        (folder / f"l{n}.service").symlink_to("robot.service" if n % 2 else f"l{n + 1}.service")


def long_command(folder: Path) -> None:
    write(folder / "robot.service", "[Service]\nExecStart=/usr/bin/robot " + "--option value " * 500_000 + "\n")


def long_shell(folder: Path) -> None:
    write(folder / "robot.service", "[Service]\nExecStart=/bin/sh -c '" + "echo $x; " * 800_000 + "'\n")


def variables(folder: Path) -> None:
    lines = "".join(f"Environment=V{n}=value\n" for n in range(300_000))
    write(folder / "robot.service", f"[Service]\nExecStart=/usr/bin/robot\n{lines}")


def placeholders(folder: Path) -> None:
    write(folder / "robot.service", "[Service]\nExecStart=/usr/bin/robot " + "{{" * 100_000 + "\n")
    write(folder / "other.service", "[Service]\nExecStart=/usr/bin/robot " + "<%" * 100_000 + "\n")


def ignores(folder: Path) -> None:
    write(
        folder / "robot.service", "[Service]\nExecStart=/usr/bin/robot\n# " + "# bringup-lint: ignore[" * 30_000 + "\n"
    )


def long_word(folder: Path) -> None:
    write(folder / "launch/robot.launch.xml", f'<launch><node pkg="a" exec="b" args="{"9" * 200_000}"/></launch>\n')


def long_number(folder: Path) -> None:
    write(folder / "config/robot.yaml", f"a:\n  ros__parameters:\n    x: {'9' * 200_000}x\n")


def no_section(folder: Path) -> None:
    write(folder / UNITS / "robot.service", "<<E\n" * 100_000)


def flow_nesting(folder: Path) -> None:
    write(folder / "etc/netplan/01-robot.yaml", "network: " + "[" * 100_000 + "\n")


def comments_on_top(folder: Path) -> None:
    write(folder / "launch/robot.launch.xml", "<!-- c -->\n" * 700 + "<other/>\n")


def return_comments(folder: Path) -> None:
    write(folder / "config/robot.yaml", "network:\r\n" + "  # c\r\n" * 1000 + "  foo: 1\r\n")
    write(folder / "config/other.yaml", "---\r\n" * 1000 + "a: [\r\nb:\r\n  ros__parameters:\r\n    c: 1\r\n")


def section_heads(folder: Path) -> None:
    write(folder / "robot.conf", "[Unit]\n[Service]\n" * 480)


def blank_heads(folder: Path) -> None:
    for name in (
        "etc/default/robot",
        "Dockerfile",
        "launch/robot.launch",
        "firewall.sh",
        "robot.rules",
        "etc/ssh/sshd_config.d/a.conf",
    ):
        write(folder / name, "\n" * 8192)


SHAPES: dict[str, Callable[[Path], None]] = {
    shape.__name__: shape
    for shape in (
        dropins, chain, ring, unrelated, web, launch_python, launch_xml, includes_deep, includes_twice, parameters,
        parameter_nodes, udev_rules, xml_elements, node_classes, launch_statements, services, interfaces, other_files,
        links, long_command, long_shell, variables, placeholders, ignores, long_word, long_number, no_section,
        flow_nesting, comments_on_top, return_comments, section_heads, blank_heads,
    )
}  # fmt: skip


def generate(folder: Path, name: str) -> Path:
    """Write the tree of a shape."""
    SHAPES[name](folder)
    return folder
