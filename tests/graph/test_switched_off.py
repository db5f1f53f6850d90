"""What a tree explicitly does not start, and what it starts somewhere."""

from __future__ import annotations

from pathlib import Path

import pytest

from bringup_lint.discover.walk import discover
from bringup_lint.robot import Robot
from tests.lint import lint

SETUP = "from setuptools import setup\nsetup(entry_points={'console_scripts': [\n    %s\n]})\n"
NODE = "import rclpy\nfrom rclpy.node import Node\n\n\ndef main():\n    rclpy.init()\n    rclpy.spin(Node('n'))\n"
CPP = "#include <rclcpp/rclcpp.hpp>\nint main(int argc, char** argv) { rclcpp::init(argc, argv); }\n"
COMPONENT = CPP + "RCLCPP_COMPONENTS_REGISTER_NODE(otter::Weir)\n"
PARAMS = "weir:\n  ros__parameters:\n    rate: 5.0\n"
LAUNCH = """\
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch_ros.actions import ComposableNodeContainer, Node
from launch_ros.descriptions import ComposableNode


def generate_launch_description():
    %s
    return LaunchDescription([
        Node(package='otter', executable='base'),
        %s
    ])
"""
XML = '<launch>\n  <node pkg="otter" exec="base"/>\n  %s\n</launch>\n'
WEIR = "weir = Node(package='otter', executable='weir', parameters=[folder + '/weir.yaml'])"
COMPOSED = "weir = ComposableNode(package='otter', plugin='otter::Weir')"
INCLUDE = "weir = IncludeLaunchDescription(folder + '/weir.launch.py')"
UNLOADED = "container = ComposableNodeContainer(package='rclcpp_components', composable_node_descriptions=[weir])"


def switched_off(folder: Path, files: dict[str, str]) -> list[str]:
    """The files that are switched off."""
    for name, text in {"package.xml": "<package><name>otter</name></package>", **files}.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    robot = Robot(discover([str(folder)]))
    return sorted(
        Path(each.absolute).relative_to(folder).as_posix() for each in robot.sources if not robot.leads_to(each)
    )


MODULE = {"otter/weir.py": NODE, "setup.py": SETUP % "'weir = otter.weir:main', 'base = otter.base:main'"}
ALONE = {**MODULE, "launch/a.launch.py": LAUNCH % (WEIR, "# weir,"), "config/weir.yaml": PARAMS}
BOTH = ["config/weir.yaml", "otter/weir.py"]
BUILT = "project(otter)\nadd_executable(weir src/weir.cpp)\n"


@pytest.mark.parametrize(
    ("files", "expected"),
    [
        (ALONE, BOTH),
        ({**ALONE, "launch/a.launch.py": LAUNCH % (WEIR, "")}, BOTH),
        ({**ALONE, "launch/a.launch.py": LAUNCH % (WEIR, "weir,")}, []),
        ({**ALONE, "launch/a.launch.py": LAUNCH % (f"{WEIR}\n    locals()", "")}, []),
        ({**ALONE, "launch/a.launch.py": LAUNCH % ("global weir\n    " + WEIR, "")}, []),
        ({**ALONE, "launch/a.launch.py": LAUNCH % (f"# {WEIR}", "")}, BOTH),
        ({**ALONE, "launch/a.launch.py": LAUNCH % (f"'''{WEIR}'''", "")}, BOTH),
        ({**ALONE, "launch/a.launch.py": LAUNCH % ("'''with 'weir' and 'weir.yaml' '''", "")}, []),
        ({**ALONE, "launch/a.launch.py": LAUNCH % (f"# ros2 run: {WEIR}", "")}, []),
        ({**ALONE, "launch/a.launch.py": LAUNCH % ("# 'weir.launch.py' and 'weir.yaml' are used by hand", "")}, []),
        (
            {**ALONE, "launch/b.launch.py": LAUNCH % ("", "*[Node(package='o', executable=f'we{n}') for n in 'ir'],")},
            BOTH,
        ),
        (
            {**ALONE, "launch/b.launch.py": LAUNCH % ("", "*[Node(package='o', executable=f'{n}_run') for n in 'ab'],")}
            | {"launch/a.launch.py": LAUNCH % (WEIR.replace("'weir'", "'a_run'"), "")}
            | {"setup.py": SETUP % "'a_run = otter.weir:main'"},
            ["config/weir.yaml"],
        ),
        (
            {**ALONE, "weir.service": "[Service]\nExecStart=python3 -m otter.weir\n"}
            | {"setup.py": SETUP % "# 'weir = otter.weir:main'"},
            ["config/weir.yaml"],
        ),
        ({**ALONE, "launch/a.launch.py": LAUNCH % ("", "")}, []),
        ({**ALONE, "launch/a.launch.py": "def broken(:\n"}, []),
        ({**ALONE, "launch/b.launch.xml": XML % '<node pkg="otter" exec="weir"/>'}, ["config/weir.yaml"]),
        ({**ALONE, "launch/b.launch.xml": XML % '<!-- <node pkg="otter" exec="weir"/> -->'}, BOTH),
        ({**ALONE, "launch/b.launch.xml": XML % "<!-- ros2 run otter weir -->"}, BOTH),
        ({"launch/b.launch.xml": XML % "<!-- 'weir.yaml' is for tests -->", "config/weir.yaml": PARAMS}, []),
        (
            {**ALONE, "launch/b.launch.xml": XML % '<node pkg="o" exec="x"><param from="$(var d)/weir.yaml"/></node>'},
            BOTH[1:],
        ),
        ({**ALONE, "README.md": "ros2 run otter weir --params-file weir.yaml\n"}, []),
        ({**ALONE, "README.md": "ros2 run \\\n  otter weir \\\n  --params-file weir.yaml\n"}, []),
        ({**ALONE, "README.md": "## weir\n"}, BOTH),
        ({**ALONE, "apps/start.xml": "<app>ros2 run otter weir</app>"}, BOTH[:1]),
        ({**ALONE, "start.sh": "#!/bin/sh\nros2 run otter weir\n"}, BOTH[:1]),
        ({**ALONE, "start.sh": "#!/bin/sh\n# ros2 run otter weir\nros2 run otter base\n"}, BOTH),
        ({**ALONE, "otter/base.py": NODE + "# from otter.weir import main\n"}, BOTH),
        ({**ALONE, "otter/base.py": "from otter.weir import main\n" + NODE}, BOTH[:1]),
        ({**ALONE, "otter/base.py": "import subprocess\n" + NODE + "subprocess.run(['weir'])\n"}, BOTH[:1]),
        ({**ALONE, "launch/b.launch.py": LAUNCH % ("", "*(n + '.yaml' for n in ('weir', 'x')),")}, []),
        ({**ALONE, "launch/b.launch.py": LAUNCH % ("", "folder + 'we*.yaml',")}, BOTH[1:]),
        ({**ALONE, "arm/weir.yaml": PARAMS}, BOTH[1:]),
        ({**MODULE, "setup.py": SETUP % "# 'weir = otter.weir:main',\n    'base = otter.base:main'"}, BOTH[1:]),
        ({**MODULE, "setup.py": SETUP % "'base = otter.base:main'"}, []),
        (
            {**MODULE, "setup.py": SETUP % "# 'weir = otter.weir:main',", "start.sh": "#!/bin/sh\npython3 weir.py\n"},
            [],
        ),
        (
            {
                "otter/weir.py": NODE,
                "setup.cfg": "[options]\n weir = otter.weir:main\n",
                "a.launch.py": LAUNCH % (WEIR, ""),
            },
            BOTH[1:],
        ),
        ({"src/weir.cpp": CPP, "CMakeLists.txt": BUILT, "a.launch.py": LAUNCH % (WEIR, "")}, ["src/weir.cpp"]),
        (
            {"src/weir.cpp": CPP, "lib/weir.cpp": "", "CMakeLists.txt": BUILT, "a.launch.py": LAUNCH % (WEIR, "")},
            [],
        ),
        (
            {
                "src/weir.cpp": CPP,
                "CMakeLists.txt": BUILT + "add_library(all src/weir.cpp)\n",
                "a.launch.py": LAUNCH % (WEIR, ""),
            },
            [],
        ),
        (
            {"src/weir.cpp": CPP, "CMakeLists.txt": "project(otter)\n# add_executable(weir src/weir.cpp)\n"},
            ["src/weir.cpp"],
        ),
        (
            {
                "src/weir.cpp": CPP,
                "CMakeLists.txt": "project(otter)\nfile(GLOB all src/*.cpp)\n# add_executable(weir src/weir.cpp)\n",
            },
            [],
        ),
        ({"src/weir.cpp": CPP, "CMakeLists.txt": f"project(otter)\n# {BUILT}\nadd_library(x src/weir.cpp)\n"}, []),
        (
            {
                "src/weir.cpp": CPP,
                "CMakeLists.txt": "# add_executable(weir src/weir.cpp)\nament_auto_add_library(all DIRECTORY src)\n",
            },
            [],
        ),
        (
            {"src/weir.cpp": COMPONENT, "a.launch.py": LAUNCH % (f"{COMPOSED}\n    {UNLOADED}", "")},
            ["src/weir.cpp"],
        ),
        ({"src/weir.cpp": COMPONENT, "a.launch.py": LAUNCH % (f"{COMPOSED}\n    {UNLOADED}", "container")}, []),
        (
            {
                "src/weir.cpp": COMPONENT,
                "CMakeLists.txt": 'rclcpp_components_register_node(w PLUGIN "otter::Weir" EXECUTABLE base)\n',
                "a.launch.py": LAUNCH % (COMPOSED, ""),
            },
            [],
        ),
        (
            {
                **ALONE,
                "launch/a.launch.py": LAUNCH % (INCLUDE, "# weir,"),
                "launch/weir.launch.py": LAUNCH.replace("base", "weir") % ("", "folder + 'weir.yaml',"),
            },
            ["config/weir.yaml", "launch/weir.launch.py", "otter/weir.py"],
        ),
        (
            {
                **ALONE,
                "launch/a.launch.py": LAUNCH % (INCLUDE, "weir,"),
                "launch/weir.launch.py": LAUNCH.replace("base", "weir") % ("", "folder + 'weir.yaml',"),
            },
            [],
        ),
    ],
)
def test_only_what_nothing_starts_is_switched_off(tmp_path: Path, files: dict[str, str], expected: list[str]) -> None:
    assert switched_off(tmp_path, files) == expected


def test_what_is_found_there_is_information(tmp_path: Path) -> None:
    for name, text in ALONE.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text.replace("ros__parameters", "ros_parameters"))
    (tmp_path / "package.xml").write_text("<package><name>otter</name></package>")
    arguments = ("--select", "params/missing-ros-parameters", "--output-format", "concise", ".")
    assert "info[params/missing-ros-parameters]" in lint(*arguments, cwd=tmp_path).stdout
    (tmp_path / "bringup-lint.toml").write_text('[purpose]\n"config" = "robot"\n')
    assert "warning[params/missing-ros-parameters]" in lint(*arguments, cwd=tmp_path).stdout
