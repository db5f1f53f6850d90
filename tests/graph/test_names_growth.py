"""Many names, each of which is looked for in many places, are judged in linear time."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from tests.growth import is_linear
from tests.lint import lint

PACKAGE = """<package format="3">
  <name>skiff</name>
  <version>1.0.0</version>
  <description>A boat.</description>
  <maintainer email="a@example.com">A</maintainer>
  <license>MIT</license>
</package>
"""


def write(folder: Path, texts: dict[str, str]) -> None:
    for name, text in texts.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


def lines(size: int, *forms: str) -> str:
    return "".join(form.format(at) for at in range(size) for form in forms)


def images(size: int) -> dict[str, str]:
    built = "#!/bin/sh\n" + lines(size, "docker build -t hull{} .\n")
    return {"Dockerfile": lines(size, "FROM keel{0}:1 AS part{0}\nCOPY --from=mast{0} /a /a\n"), "build.sh": built}


def computed_image(size: int) -> dict[str, str]:
    return {
        "Dockerfile": f"FROM {'a-' * size}b AS part\n",
        "build.sh": f"#!/bin/sh\ndocker build -t {'$A-' * size}c .\n",
    }


def variables(size: int) -> dict[str, str]:
    task = "    - name: Rig\n      copy: {{content: '{{{{ sail_{0} }}}}', dest: /etc/sail{0}}}\n"
    plays = "- hosts: boats\n  tasks:\n" + lines(size, task)
    return {"hosts.ini": "[boats]\na ansible_host=192.0.2.1\n", "playbooks/site.yml": plays}


def braces(size: int) -> dict[str, str]:
    task = f"    - name: Rig\n      command: rig {'{{ sail }} b ' * size}\n"
    return {"playbooks/site.yml": "- hosts: boats\n  tasks:\n" + task}


def apt_calls(size: int) -> dict[str, str]:
    return {"up.sh": "#!/bin/sh\nDEBIAN_FRONTEND=noninteractive\n" + "apt-get install -y sail\n" * size}


def unit_questions(size: int) -> dict[str, str]:
    return {"up.sh": "#!/bin/sh\n" + "systemctl is-active --quiet a.service b.service || exit 1\n" * size}


def homes(size: int) -> dict[str, str]:
    return {
        "up.sh": "#!/bin/sh\n" + lines(size, "cp /home/alice/sail{}/a b\n"),
        "README.md": lines(size * 4, "cd ~/sails{}\n"),
    }


def called_scripts(size: int) -> dict[str, str]:
    return {"README.md": f"```\n{lines(size, 'cd rig', chr(10), './hoist_the_sail{}.sh', chr(10))}```\n", "rig/a": ""}


def taken_out(size: int) -> dict[str, str]:
    node = "        LifecycleNode(package='nav2_map_server', executable='map_server', name='map{0}', namespace=''),\n"
    given = lines(size, node, "        # 'map{0}x',\n")
    head = "from launch import LaunchDescription\nfrom launch_ros.actions import LifecycleNode\n\n\n"
    text = f"{head}def generate_launch_description():\n    return LaunchDescription([\n{given}    ])\n"
    return {"skiff/package.xml": PACKAGE, "skiff/launch/maps.launch.py": text}


def open_remarks(size: int) -> dict[str, str]:
    text = "<launch>\n" + '<!-- <node pkg="a" exec="b"/>\n' * size
    given = "/**:\n  ros__parameters:\n    path: /home/alice/a/b\n"
    return {"skiff/package.xml": PACKAGE, "skiff/launch/a.launch.xml": text, "skiff/config/a.yaml": given}


def misspelt_programs(size: int) -> dict[str, str]:
    built = lines(size, "add_executable(hoist_sail{0} a.cpp)\ninstall(TARGETS hoist_sail{0} DESTINATION lib/skiff)\n")
    nodes = lines(size, "        Node(package='skiff', executable='oist_sail{}'),\n")
    head = "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n\n\n"
    text = f"{head}def generate_launch_description():\n    return LaunchDescription([\n{nodes}    ])\n"
    build = f"cmake_minimum_required(VERSION 3.8)\nproject(skiff)\n{built}ament_package()\n"
    return {"skiff/package.xml": PACKAGE, "skiff/CMakeLists.txt": build, "skiff/launch/a.launch.py": text}


def domains(size: int) -> dict[str, str]:
    domain = "<Domain><General><NetworkInterfaceAddress>192.0.2.1</NetworkInterfaceAddress></General></Domain>\n"
    return {"cyclonedds.xml": f'<CycloneDDS xmlns="https://cdds.io/config">{domain * size}</CycloneDDS>'}


def missing_pictures(size: int) -> dict[str, str]:
    build = f"project(skiff)\ninstall(FILES\n{lines(size, '  art/a{}.png', chr(10))}DESTINATION share/skiff)\n"
    return {"skiff/package.xml": PACKAGE, "skiff/CMakeLists.txt": build, "skiff/art/b.png": ""}


def moved_services(size: int) -> dict[str, str]:
    files = {f"sail{at}/compose.yaml": f"services:\n  rig:\n    build: sail{at}\n" for at in range(size)}
    made = {f"sail{at}/Dockerfile": "FROM ros:jazzy\n" for at in range(size)}
    return {**files, **made, "README.md": "a/b/" * size * 20}


def waiting_units(size: int) -> dict[str, str]:
    unit = "[Unit]\nAfter=network-online.target\n[Service]\nExecStart=/bin/sh -c 'exec $RIG/lib/rig/sail{}.sh'\n"
    units = {f"sail{at}.service": unit.format(at) for at in range(size)}
    return {**units, **{f"sail{at}.sh": "#!/bin/sh\nros2 launch rig sail.launch.py\n" for at in range(size)}}


def started_units(size: int) -> dict[str, str]:
    units = {f".config/systemd/user/sail{at}.service": "[Install]\nWantedBy=multi-user.target\n" for at in range(size)}
    task = "    - name: Hoist\n      systemd:\n        name: sail{}.service\n        state: started\n"
    return {**units, "playbooks/site.yml": "- hosts: boats\n  tasks:\n" + lines(size, task)}


MAIN = "int main() {{ rclcpp::init(0, 0); {} }}\n"


def nested_loops(size: int) -> dict[str, str]:
    loops = "while (rclcpp::ok()) { rclcpp::spin_some(node);\n" * size + "}" * size
    return {"skiff/package.xml": PACKAGE, "skiff/src/a.cpp": "#include <rclcpp/rclcpp.hpp>\n" + MAIN.format(loops)}


def declared_parameters(size: int) -> dict[str, str]:
    declared = lines(size, 'declare_parameter("sail{}", 1);\n')
    node = f'class Rig : public rclcpp::Node {{ public: Rig() : Node("rig") {{\n{declared}}} }};\n'
    return {
        "skiff/package.xml": PACKAGE,
        "skiff/src/a.cpp": "#include <rclcpp/rclcpp.hpp>\n" + node + MAIN.format("std::make_shared<Rig>();"),
        "skiff/config/a.yaml": "rig:\n  ros__parameters:\n" + lines(size, "    sail{}: 1\n"),
    }


@pytest.mark.slow
@pytest.mark.parametrize(
    ("rule", "made", "small"),
    [
        ("docker/unknown-stage", images, 150),
        ("docker/unknown-stage", computed_image, 100),
        ("script/ansible-name-missing", variables, 100),
        ("script/command-without-shell", braces, 200),
        ("script/frontend-lost", apt_calls, 100),
        ("script/units-any-active", unit_questions, 100),
        ("script/home-of-one-user", homes, 150),
        ("script/guide-script-missing", called_scripts, 150),
        ("launch/lifecycle-node-unmanaged", taken_out, 60),
        ("params/absolute-home-path", open_remarks, 250),
        ("launch/executable-missing", misspelt_programs, 60),
        ("cyclonedds/deprecated-element", domains, 100),
        ("compose", moved_services, 50),
        ("systemd/network-online-no-wants", waiting_units, 60),
        ("systemd/user-unit-system-target", started_units, 60),
        ("node/busy-loop", nested_loops, 60),
        ("node/parameter-unread", declared_parameters, 150),
        ("package/installed-file-missing", missing_pictures, 200),
    ],
)
def test_time_grows_as_the_names(rule: str, made: Callable[[int], dict[str, str]], small: int, tmp_path: Path) -> None:
    def check(size: int) -> None:
        write(tmp_path, made(size))
        lint("--no-cache", "--quiet", "--select", rule, ".", cwd=tmp_path)

    assert is_linear(check, small)


def test_a_difference_of_very_many_times_is_no_error(tmp_path: Path) -> None:
    begin = "import rclpy\nfrom rclpy.node import Node\n\n\nclass Log(Node):\n"
    made = "    def __init__(self):\n        super().__init__('log')\n        now = self.get_clock().now()\n"
    end = f"        print(now{' - now' * 900})\n\n\nrclpy.init()\nrclpy.spin(Log())\n"
    write(tmp_path, {"log.py": begin + made + end})
    found = lint("--no-cache", "--quiet", "--select", "node/time-misfit", ".", cwd=tmp_path)
    assert "internal-error" not in found.stdout + found.stderr
