"""What launch files lead to: scopes, includes, conditions, packages and their install rules."""

from __future__ import annotations

import textwrap
from pathlib import Path

import pytest

from bringup_lint.discover.tree import Tree
from bringup_lint.discover.walk import discover
from bringup_lint.graph.edges.launch import launch_edges
from bringup_lint.graph.launch.launch import Launch
from bringup_lint.graph.launch.python_expression import NotEvaluated
from bringup_lint.graph.launch.python_expression import evaluate
from bringup_lint.graph.launch.started import exclusive
from bringup_lint.graph.launch.started import namespace
from bringup_lint.graph.workspace import Place
from bringup_lint.model.launch_values import Literal
from bringup_lint.robot import Robot
from bringup_lint.source import Located
from bringup_lint.source import Source

CMAKE_PACKAGE = "<package format='3'><name>{}</name><buildtool_depend>ament_cmake</buildtool_depend></package>"


def tree(folder: Path, files: dict[str, str]) -> Launch:
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(textwrap.dedent(text), "utf-8")
    robot = Robot(discover([str(folder)]))
    launch = robot.launch
    assert robot.failures == []
    return launch


def started(launch: Launch, name: str) -> list[tuple[str | None, bool | None]]:
    (file,) = [file for file in launch.launch_files if file.source.name.endswith(name)]
    return [(node.fqn, node.by_default) for node in launch.expansion(file).nodes]


def test_arguments_flow_into_includes_and_leak_out(tmp_path: Path) -> None:
    launch = tree(
        tmp_path,
        {
            "launch/top.launch.xml": """\
                <launch>
                  <include file="$(dirname)/part.launch.xml"><arg name="who" value="first"/></include>
                  <include file="$(dirname)/part.launch.xml"/>
                  <group><include file="$(dirname)/part.launch.xml"><arg name="who" value="inner"/></include></group>
                  <node pkg="p" exec="e" name="$(var who)_last"/>
                </launch>""",
            "launch/part.launch.xml": """\
                <launch>
                  <arg name="who" default="nobody"/>
                  <node pkg="p" exec="e" name="$(var who)"/>
                </launch>""",
        },
    )
    assert [name for name, _ in started(launch, "top.launch.xml")] == ["/first", "/first", "/inner", "/first_last"]


def test_conditions_are_decided_by_default(tmp_path: Path) -> None:
    launch = tree(
        tmp_path,
        {
            "launch/a.launch.xml": """\
                <launch>
                  <arg name="sim" default="false"/>
                  <node pkg="p" exec="e" name="a" if="$(var sim)"/>
                  <node pkg="p" exec="e" name="b" unless="$(var sim)"/>
                  <node pkg="p" exec="e" name="c" if="$(env SIM)"/>
                  <node pkg="p" exec="e" name="never" if="false"/>
                  <group if="$(var sim)" scoped="false"><let name="who" value="sim"/></group>
                  <node pkg="p" exec="e" name="d_$(var who real)"/>
                </launch>"""
        },
    )
    assert started(launch, "a.launch.xml") == [("/a", False), ("/b", True), ("/c", None), ("/d_real", True)]
    (expansion,) = launch.expansions
    one, other, third, _ = expansion.nodes
    assert exclusive(one, other)
    assert not exclusive(one, third)


def test_include_cycle_ends(tmp_path: Path) -> None:
    launch = tree(
        tmp_path,
        {
            "launch/a.launch.xml": '<launch><include file="$(dirname)/b.launch.xml"/></launch>',
            "launch/b.launch.xml": '<launch><include file="$(dirname)/a.launch.xml"/></launch>',
        },
    )
    assert [len(expansion.cycle) for expansion in launch.expansions] == [1, 1]


@pytest.mark.slow
def test_doubling_includes_and_lets_end(tmp_path: Path) -> None:
    files = {
        f"launch/f{n}.launch.xml": f"""\
            <launch><let name="x" value="$(var x a)$(var x b)"/>
            <include file="$(dirname)/f{n + 1}.launch.xml"/><include file="$(dirname)/f{n + 1}.launch.xml"/></launch>"""
        for n in range(24)
    }
    files["launch/f24.launch.xml"] = "<launch/>"
    launch = tree(tmp_path, files)
    assert launch.expansion(launch.launch_files[0]).open


@pytest.mark.parametrize(
    ("pushed", "own", "expected"),
    [
        ((), None, "/"),
        ((), "", "/"),
        ((), "a", "/a"),
        (("a",), None, "/a"),
        (("a",), "b", "/a/b"),
        (("a",), "/b", "/b"),
        (("a", "b"), "", "/a/b"),
        (("/a/",), "b/", "/a/b"),
        (("/",), "b", "/b"),
    ],
)
def test_namespace(pushed: tuple[str, ...], own: str | None, expected: str) -> None:
    def value(text: str) -> Literal:
        source = Source("x", text)
        return Literal(Located(text, source.whole), source.whole)

    assert namespace(tuple(map(value, pushed)), None if own is None else value(own)) == expected


PYTHON_PACKAGE = {
    "p/package.xml": "<package><name>p</name><export><build_type>ament_python</build_type></export></package>",
    "p/setup.py": """\
        import os
        from glob import glob
        from setuptools import find_packages, setup
        package_name = 'p'
        share = os.path.join('share', package_name)
        setup(name=package_name, packages=find_packages(exclude=['test']),
              data_files=[(share, ['package.xml']),
                          (share + '/launch', glob(os.path.join('launch', '*launch.[pxy][yma]*')))],
              entry_points={'console_scripts': ['run = p.run:main', f'{package_name}_two=p.two:main']})""",
    "p/launch/a.launch.py": "def generate_launch_description(): return None",
    "p/launch/notes.txt": "",
    "p/config/a.yaml": "",
}
CMAKE = {
    "c/package.xml": CMAKE_PACKAGE.format("c"),
    "c/CMakeLists.txt": """\
        project(c) # a comment )
        include(GNUInstallDirs)
        set(dirs launch config)
        list(APPEND dirs maps)
        #[[ a block ]]
        add_executable(one src/one.cpp)
        install(TARGETS one RUNTIME DESTINATION lib/${PROJECT_NAME} LIBRARY DESTINATION lib)
        install(PROGRAMS scripts/two.py DESTINATION "lib/${PROJECT_NAME}" RENAME two)
        install(DIRECTORY ${dirs} DESTINATION share/${PROJECT_NAME})
        install(FILES extra/one.yaml DESTINATION share/${PROJECT_NAME}/config/extra)
        rclcpp_components_register_nodes(lib "c::A" "c::B")
        add_subdirectory(sub)
        ament_package()""",
    "c/sub/CMakeLists.txt": "install(PROGRAMS three DESTINATION lib/${PROJECT_NAME})",
    "c/launch/a.launch.xml": "<launch/>",
    "c/extra/one.yaml": "",
    "c/other/b.yaml": "",
}


def found(launch: Launch, package: str, path: str) -> tuple[str | None, bool | None] | None:
    result = launch.workspace.find(Place("share", package, path))
    return None if result is None else (result.file and Path(result.file).name, result.installed)


def test_python_package(tmp_path: Path) -> None:
    launch = tree(tmp_path, PYTHON_PACKAGE)
    package = launch.workspace.packages["p"]
    assert set(package.executables) == {"run", "p_two"}
    assert package.installs_known and package.executables_known
    assert found(launch, "p", "launch/a.launch.py") == ("a.launch.py", True)
    assert found(launch, "p", "launch/notes.txt") == ("notes.txt", False)
    assert found(launch, "p", "config/a.yaml") == ("a.yaml", False)
    assert found(launch, "p", "config/b.yaml") == (None, False)
    assert found(launch, "q", "config/b.yaml") is None


def test_cmake_package(tmp_path: Path) -> None:
    launch = tree(tmp_path, CMAKE)
    package = launch.workspace.packages["c"]
    assert set(package.executables) == {"one", "two", "three"}
    assert package.executables["one"].span.text == "one"
    assert package.plugins == ["c::A", "c::B"]
    assert package.installs_known and package.executables_known and package.plugins_known
    assert found(launch, "c", "launch/a.launch.xml") == ("a.launch.xml", True)
    assert found(launch, "c", "config/extra/one.yaml") == ("one.yaml", True)
    assert found(launch, "c", "other/b.yaml") == ("b.yaml", False)


@pytest.mark.parametrize(
    "line",
    [
        "foreach(x ${unknown})\ninstall(PROGRAMS ${x} DESTINATION lib/${PROJECT_NAME})\nendforeach()",
        "foreach(x RANGE ${COUNT})\ninstall(PROGRAMS s${x} DESTINATION lib/${PROJECT_NAME})\nendforeach()",
        "my_macro(launch)",
        "install(DIRECTORY ${unknown} DESTINATION share/${PROJECT_NAME})",
        "add_subdirectory(missing)",
        "include(cmake/install.cmake)",
    ],
)
def test_what_is_not_understood_proves_nothing(tmp_path: Path, line: str) -> None:
    files = {"c/package.xml": CMAKE_PACKAGE.format("c"), "c/CMakeLists.txt": f"project(c)\n{line}\n"}
    launch = tree(tmp_path, files | {"c/launch/a.launch.xml": "<launch/>"})
    assert found(launch, "c", "launch/a.launch.xml") == ("a.launch.xml", None)


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("install(DIRECTORY ${unknown} DESTINATION share/${PROJECT_NAME})", (None, False)),
        ("my_macro(launch/a)", (None, False)),
        ("my_macro(launch/b)", None),
        ("add_subdirectory(missing)", None),
        ("include(cmake/install.cmake)", None),
        ("include(CTest)", (None, False)),
        ("add_subdirectory(extra)", (None, False)),
        ("file(DOWNLOAD https://example.com/launch.tar launch.tar)", None),
    ],
)
def test_a_file_that_nothing_is_called_is_absent(tmp_path: Path, line: str, expected: object) -> None:
    files = {"c/package.xml": CMAKE_PACKAGE.format("c"), "c/CMakeLists.txt": f"project(c)\nmy_macro()\n{line}\n"}
    launch = tree(tmp_path, files | {"c/launch/a.launch.xml": "<launch/>", "c/extra/CMakeLists.txt": "\n"})
    assert found(launch, "c", "launch/b.launch.xml") == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("'a' == 'a'", True),
        ("not True and False", False),
        ("'a' in ['a', 'b']", True),
        ("'x' if 1 < 2 else 'y'", "x"),
        ("int('3') + 1", 4),
        ("'True'.lower() == 'true'", True),
    ],
)
def test_expression(text: str, expected: object) -> None:
    assert evaluate(text) == expected


@pytest.mark.parametrize(
    "text", ["x", "true", "__import__('os')", "'a' * 10**9", "(" * 500, "1/0", "open('x')", "[].append(1)"]
)
def test_expression_that_is_not_evaluated(text: str) -> None:
    with pytest.raises(NotEvaluated):
        evaluate(text)


def test_edges_lead_from_launch_files_to_parameters(tmp_path: Path) -> None:
    launch = tree(
        tmp_path,
        {
            "r/package.xml": CMAKE_PACKAGE.format("r"),
            "r/CMakeLists.txt": "project(r)\ninstall(DIRECTORY launch config DESTINATION share/${PROJECT_NAME})",
            "r/config/a.yaml": "",
            "r/launch/top.launch.xml": """\
                <launch><arg name="on" default="true"/>
                <include file="$(dirname)/part.launch.xml" if="$(var on)"/></launch>""",
            "r/launch/part.launch.xml": """\
                <launch><node pkg="p" exec="e" name="n">
                <param from="$(find-pkg-share r)/config/a.yaml"/></node></launch>""",
        },
    )
    edges = [
        (edge.kind, Path(edge.source.name).name, Path(edge.target.name).name, edge.said)
        for edge in launch_edges(Tree(), launch)
    ]
    assert edges == [
        ("includes", "top.launch.xml", "part.launch.xml", "include (if $(var on))"),
        ("starts", "part.launch.xml", "n", "node (if $(var on))"),
        ("loads-params", "n", "a.yaml", "parameters"),
    ]
