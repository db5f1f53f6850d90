"""From the names of executables and parameters to where they are declared, in each language."""

from __future__ import annotations

import asyncio
from pathlib import Path

import pytest
from lsprotocol import types

from bringup_lint.registry import Registry
from bringup_lint.server.analysis import Analysis
from bringup_lint.server.folder import Folder
from bringup_lint.server.folder import State
from bringup_lint.server.navigation import definition
from tests.server.conftest import editing

MANIFEST = (
    "<package format='3'><name>{name}</name><exec_depend>x</exec_depend>"
    "<export><build_type>{kind}</build_type></export></package>"
)
WORKSPACE = {
    "src/rover/package.xml": MANIFEST.format(name="rover", kind="ament_python"),
    "src/rover/setup.py": (
        "from setuptools import setup\n\n"
        "setup(name='rover', entry_points={'console_scripts': ['drive_node = rover.drive:main']},\n"
        "      data_files=[('share/rover/config', ['config/rover.yaml']),\n"
        "                  ('share/rover/launch', ['launch/a.launch.py'])])\n"
    ),
    "src/rover/setup.cfg": "[install]\ninstall_scripts=$base/lib/rover\n",
    "src/rover/rover/__init__.py": "",
    "src/rover/rover/drive.py": (
        "import rclpy\nfrom rclpy.node import Node\n\n\n"
        "class Drive(Node):\n    def __init__(self):\n        super().__init__('drive')\n"
        "        self.declare_parameter('max_speed', 0.5)\n"
        "        self.declare_parameters('gains', [('p', 1.0)])\n"
        "        self.limit = self.get_parameter('max_speed').value\n\n\n"
        "def main():\n    rclpy.init()\n    rclpy.spin(Drive())\n"
    ),
    "src/rover/config/rover.yaml": "drive:\n  ros__parameters:\n    max_speed: 0.7\n    gains:\n      p: 2.0\n",
    "src/rover/launch/a.launch.py": (
        "import os\nfrom ament_index_python.packages import get_package_share_directory\n"
        "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n\n\n"
        "def generate_launch_description():\n"
        "    config = os.path.join(get_package_share_directory('rover'), 'config', 'rover.yaml')\n"
        "    return LaunchDescription([\n"
        "        Node(package='rover', executable='drive_node', name='drive', parameters=[config]),\n"
        "        Node(package='arm', executable='arm_node', name='arm', parameters=[{'arm_rate': 50}]),\n"
        "    ])\n"
    ),
    "src/arm/package.xml": MANIFEST.format(name="arm", kind="ament_cmake"),
    "src/arm/CMakeLists.txt": (
        "project(arm)\nadd_executable(arm_node src/arm.cpp)\n"
        "install(TARGETS arm_node DESTINATION lib/${PROJECT_NAME})\nament_package()\n"
    ),
    "src/arm/src/arm.cpp": (
        '#include <rclcpp/rclcpp.hpp>\nint main() {\n  auto node = rclcpp::Node::make_shared("arm");\n'
        '  node->declare_parameter<int>("arm_rate", 10);\n  node->get_parameter("arm_rate");\n}\n'
    ),
}
DRIVE, LAUNCH, CPP = "src/rover/rover/drive.py", "src/rover/launch/a.launch.py", "src/arm/src/arm.cpp"
LEADS = [
    (LAUNCH, "drive_node", [(DRIVE, "main"), ("src/rover/setup.py", "drive_node")]),
    (LAUNCH, "arm_node", [(CPP, ""), ("src/arm/CMakeLists.txt", "arm_node DESTINATION")]),
    (LAUNCH, "rover', executable", [("src/rover/package.xml", "rover")]),
    (LAUNCH, "arm_rate", [(CPP, '"arm_rate", 10')]),
    ("src/rover/config/rover.yaml", "max_speed", [(DRIVE, "'max_speed', 0.5")]),
    ("src/rover/config/rover.yaml", "p: 2.0", [(DRIVE, "'p', 1.0")]),
    (DRIVE, "max_speed', 0.5", [("src/rover/config/rover.yaml", "max_speed")]),
    (DRIVE, "max_speed').value", [(DRIVE, "'max_speed', 0.5")]),
    (CPP, 'arm_rate");', [(CPP, '"arm_rate", 10')]),
]
"""A file, what is in it from the name on, and the files and texts to which the name leads."""


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    for name, text in WORKSPACE.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, "utf-8")
    return tmp_path


@pytest.fixture
def analysis(workspace: Path, monkeypatch: pytest.MonkeyPatch) -> Analysis:
    monkeypatch.chdir(workspace)
    folder = Folder(str(workspace), Registry.of(), lambda config: frozenset())
    return folder.check(State(folder.generation, {}))


def place(file: str, text: str) -> types.Position:
    before, _, _ = WORKSPACE[file].partition(text)
    return types.Position(before.count("\n"), len(before.rpartition("\n")[2]))


def inside(file: str, text: str) -> types.Position:
    start = place(file, text)
    return types.Position(start.line, start.character + 1)


@pytest.mark.parametrize(("file", "text", "leads"), LEADS)
def test_a_name_leads_to_its_declaration(
    analysis: Analysis, workspace: Path, file: str, text: str, leads: list[tuple[str, str]]
) -> None:
    found = definition(analysis, str(workspace / file), inside(file, text))
    wanted = [
        ((workspace / name).as_uri(), place(name, word) if word else types.Position(0, 0)) for name, word in leads
    ]
    lines = [(each.uri, each.range.start.line) for each in found]
    assert lines == [(uri, position.line) for uri, position in wanted]


def test_other_words_lead_nowhere(analysis: Analysis, workspace: Path) -> None:
    assert definition(analysis, str(workspace / DRIVE), inside(DRIVE, "rclpy.init")) == []
    assert definition(analysis, str(workspace / DRIVE), inside(DRIVE, "value")) == []


def test_an_unsaved_declaration_is_found(workspace: Path) -> None:
    async def test() -> None:
        async with editing(workspace) as editor:
            editor.open(workspace / DRIVE, "# one line more\n" + WORKSPACE[DRIVE])
            file = editor.open(workspace / "src/rover/config/rover.yaml")
            at = types.DefinitionParams(
                types.TextDocumentIdentifier(file), inside("src/rover/config/rover.yaml", "max_speed")
            )
            found = await editor.text_document_definition_async(at)
            assert isinstance(found, (list, tuple))
            assert [each.range.start.line for each in found if isinstance(each, types.Location)] == [8]

    asyncio.run(asyncio.wait_for(test(), 120))
