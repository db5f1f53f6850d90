"""Node sources joined with packages and launch files, and the rules on them under odd sources."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import HealthCheck
from hypothesis import given
from hypothesis import settings
from hypothesis import strategies as st

from bringup_lint.discover.tree import Tree
from bringup_lint.discover.walk import discover
from bringup_lint.graph.nodes.resolved.starting import chain_to
from bringup_lint.graph.nodes.resolved.starting import runners_of
from bringup_lint.graph.nodes.resolved.starting import stopped_by
from bringup_lint.registry import Registry
from bringup_lint.robot import Robot
from bringup_lint.source import Source

PACKAGE = """<package format="3">
  <name>{name}</name><version>1.0.0</version><description>d</description>
  <maintainer email="a@example.org">A</maintainer><license>MIT</license>
  <export><build_type>{build}</build_type></export>
</package>
"""
LAUNCH = """from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    return LaunchDescription([{nodes}])
"""
NODE = """import rclpy
from rclpy.node import Node
{imports}
class {name}({base}):
    def __init__(self):
        super().__init__('{name}')

def main():
    rclpy.init()
    rclpy.spin({made}())
"""
RULES = (
    "shutdown-no-safe-state",
    "shutdown-publish-after-context",
    "shutdown-signal-handler-starved",
    "shutdown-only-keyboardinterrupt",
    "shutdown-double",
    "lifecycle-publish-after-deactivate",
    "blocking-in-callback",
    "asyncio-in-callback",
    "service-wait-no-timeout",
    "param-range-dict",
    "undefined-name",
    "node-name-invalid",
    "watchdog-unconditional",
)


def node(name: str = "Arm", base: str = "Node", imports: str = "", made: str = "") -> str:
    return NODE.format(name=name, base=base, imports=imports, made=made or name)


def robot(folder: Path, files: dict[str, str]) -> Robot:
    for path, text in files.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text(text)
    return Robot(discover([str(folder)]))


def python_package(scripts: str, **files: str) -> dict[str, str]:
    setup = f"from setuptools import setup\nsetup(name='arm', entry_points={{'console_scripts': [{scripts}]}})\n"
    launch = LAUNCH.format(nodes="Node(package='arm', executable='run', name='arm')")
    modules = {f"arm/arm/{name}.py": text for name, text in files.items()}
    return {
        "arm/package.xml": PACKAGE.format(name="arm", build="ament_python"),
        "arm/setup.py": setup,
        "arm/launch/arm.launch.py": launch,
        **modules,
    }


def started_class(found: Robot) -> str | None:
    (started,) = found.launch.nodes
    program = found.nodes.program_of(started)
    return str(program.classes[0].name) if program is not None and len(program.classes) == 1 else None


def test_console_script(tmp_path: Path) -> None:
    found = robot(tmp_path, python_package("'run = arm.driver:main'", driver=node()))
    assert started_class(found) == "Arm"
    (file,) = found.nodes.judged
    assert [each.action.span.source.basename for each in found.nodes.launched(file)] == ["arm.launch.py"]
    assert found.nodes.program("arm", "run").declared.span.text == "run"


def test_main_and_class_in_different_files(tmp_path: Path) -> None:
    main = "import rclpy\nfrom arm.driver import Arm\ndef main():\n    rclpy.init()\n    rclpy.spin(Arm())\n"
    found = robot(tmp_path, python_package("'run = arm.start:main'", driver=node(), start=main))
    assert started_class(found) == "Arm"
    (cls,) = (each for each in found.nodes.classes if each.name == "Arm")
    assert [file.source.basename for file in found.nodes.makers(cls)] == ["driver.py", "start.py"]


def test_main_that_another_file_has(tmp_path: Path) -> None:
    start = "from arm.driver import main\n"
    found = robot(tmp_path, python_package("'run = arm.start:main'", driver=node(), start=start))
    assert started_class(found) == "Arm"
    assert found.nodes.program("arm", "run").file.source.basename == "driver.py"


def test_two_nodes_in_one_program_are_not_one(tmp_path: Path) -> None:
    text = node() + "    rclpy.spin(Leg())\n\nclass Leg(Node):\n    pass\n"
    found = robot(tmp_path, python_package("'run = arm.driver:main'", driver=text))
    assert started_class(found) is None
    assert {str(each.name) for each in found.nodes.program("arm", "run").classes} == {"Arm", "Leg"}


def test_setup_cfg(tmp_path: Path) -> None:
    files = python_package("", driver=node())
    files["arm/setup.py"] = "from setuptools import setup\nsetup()\n"
    files["arm/setup.cfg"] = "[options.entry_points]\nconsole_scripts =\n    run = arm.driver:main\n"
    assert started_class(robot(tmp_path, files)) == "Arm"


@pytest.mark.parametrize(
    "install",
    [
        "install(PROGRAMS scripts/arm.py DESTINATION lib/${PROJECT_NAME} RENAME run)",
        "install(PROGRAMS scripts/run DESTINATION lib/${PROJECT_NAME})",
    ],
)
def test_installed_by_cmake(tmp_path: Path, install: str) -> None:
    script = "arm.py" if "RENAME" in install else "run"
    files = {
        "arm/package.xml": PACKAGE.format(name="arm", build="ament_cmake"),
        "arm/CMakeLists.txt": f"cmake_minimum_required(VERSION 3.8)\nproject(arm)\n{install}\nament_package()\n",
        "arm/launch/arm.launch.py": LAUNCH.format(nodes="Node(package='arm', executable='run', name='arm')"),
        f"arm/scripts/{script}": "#!/usr/bin/env python3\n" + node() + "\nmain()\n",
    }
    assert started_class(robot(tmp_path, files)) == "Arm"


def test_classes_that_build_on_classes_of_other_files(tmp_path: Path) -> None:
    files = python_package(
        "'run = arm.child:main'",
        base=node("Base").replace("import Node", "import Node as N").replace("(Node)", "(N)"),
        child="from .base import Base\n" + node("Child", "Base"),
        grandchild="import arm.child\n" + node("Grandchild", "arm.child.Child"),
        stranger="from elsewhere import Base\n" + node("Stranger", "Base"),
    )
    found = robot(tmp_path, files)
    by_name = {str(each.name): each for file in found.nodes.sources for each in file.classes}
    assert {name: each.is_node for name, each in by_name.items()} == {
        "Base": True,
        "Child": True,
        "Grandchild": True,
        "Stranger": None,
    }
    assert [str(each.name) for each in by_name["Grandchild"].lineage] == ["Grandchild", "Child", "Base"]


def test_two_packages_of_one_name_give_no_join(tmp_path: Path) -> None:
    files = python_package("'run = arm.driver:main'", driver=node())
    files |= {f"other/{path}": text for path, text in files.items()}
    found = robot(tmp_path, files)
    assert [found.nodes.program_of(started) for started in found.launch.nodes] == [None, None]


def test_unit_that_starts_a_file(tmp_path: Path) -> None:
    files = python_package("'run = arm.driver:main'", driver=node())
    files["arm/setup.py"] = files["arm/setup.py"].replace(
        "entry_points", "data_files=[('share/arm/launch', ['launch/arm.launch.py'])], entry_points"
    )
    files["etc/systemd/system/arm.service"] = (
        "[Service]\nExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch arm arm.launch.py'\n"
        "KillSignal=SIGINT\n"
    )
    found = robot(tmp_path, files)
    (file,) = found.nodes.judged
    assert [runner.name for runner in runners_of(found.nodes, file)] == ["arm.service"]
    assert stopped_by(found.nodes, file) == {"SIGINT"}
    assert [step.span.source.basename for step in chain_to(found.nodes, file)] == ["arm.service", "arm.launch.py"]


@pytest.mark.parametrize(
    ("path", "purpose"),
    [
        ("arm/arm/driver.py", "robot"),
        ("arm/test/test_driver.py", "test"),
        ("arm/arm/latest.py", "robot"),
        ("arm_examples/arm_examples/driver.py", "example"),
        ("arm/tools/plot.py", "example"),
        ("arm_gazebo/scripts/driver.py", "simulation"),
        ("arm/arm/similar.py", "robot"),
    ],
)
def test_purpose(tmp_path: Path, path: str, purpose: str) -> None:
    package = path.partition("/")[0]
    found = robot(
        tmp_path, {f"{package}/package.xml": PACKAGE.format(name=package, build="ament_python"), path: node()}
    )
    (file,) = found.nodes.sources
    assert found.nodes.purpose(file.source).value == purpose


PIECES = [
    "import rclpy, signal, asyncio, time, subprocess\nfrom rclpy.node import Node\nfrom std_msgs.msg import Float64\n",
    "from rclpy.signals import SignalHandlerOptions\nfrom rclpy.lifecycle import LifecycleNode\n",
    "class A(Node):\n    def __init__(self):\n        super().__init__('a-b')\n"
    "        self.create_timer(1, self.tick)\n"
    "        self.pub = self.create_publisher(Float64, 'cmd', 1)\n        self.create_timer(1, lambda: self.stop())\n"
    "        self.client = self.create_client(T, 's')\n",
    "    async def tick(self):\n        await asyncio.sleep(1)\n        time.sleep(3)\n        self.client.call(1)\n",
    "    def stop(self):\n        self.pub.publish(Float64())\n        self.stop()\n"
    "        self.client.wait_for_service()\n",
    "    def on_deactivate(self, state):\n        super().on_deactivate(state)\n        self.stop()\n",
    "    def destroy_node(self):\n        self.stop(); super().destroy_node()\n",
    "def main():\n    rclpy.init()\n    node = A()\n",
    "    signal.signal(signal.SIGTERM, node.stop)\n",
    "    node.context.on_shutdown(node.stop)\n",
    "    try:\n        rclpy.spin(node)\n    except KeyboardInterrupt:\n        pass\n"
    "    finally:\n        node.stop()\n"
    "        node.destroy_node()\n        rclpy.shutdown()\n",
    "    while True:\n        rclpy.spin_once(node)\n",
    "rclpy.init(signal_handler_options=SignalHandlerOptions.NO)\nrclpy.spin(rclpy.create_node('9'))\n",
    "ParameterDescriptor(floating_point_range=[{'from_value': 0}, dict(step=1), {**x}])\n",
    "SetParametersResult()\n",
    "class A(A):\n    pass\n",
    "if __name__ == '__main__':\n    main()\n",
]


@settings(suppress_health_check=list(HealthCheck))
@given(st.lists(st.one_of(st.sampled_from(PIECES), st.text(max_size=6)), max_size=10).map("".join))
def test_no_source_makes_a_rule_fail(text: str) -> None:
    source = Source("arm/arm/driver.py", text, "python-node")
    tree = Tree()
    tree.sources.append(source)
    found = Robot(tree)
    for name in RULES:
        for each in Registry.of().get(f"node/{name}").check(found):
            assert 0 <= each.span.start <= each.span.end <= len(text)
            for edit in each.fix.edits if each.fix else ():
                assert 0 <= edit.span.start <= edit.span.end <= len(text)
    assert found.failures == []
