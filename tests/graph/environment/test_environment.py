"""Environment files and the environment of processes."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bringup_lint.parsers.env_file import parse
from bringup_lint.robot import Robot
from bringup_lint.source import Source
from tests.graph.systemd.test_units import load
from tests.graph.systemd.test_units import only


def entries(text: str) -> dict[str, str]:
    return {str(entry.name): str(entry.value) for entry in parse(Source("x.env", text)).entries}


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("A=1\nB = 2 3 \n", {"A": "1", "B": "2 3"}),
        ("# A=1\n ; B=2\nC=3 # x\n", {"C": "3 # x"}),
        ('A=\'x y\'\nB="$HOME"\nC=x"y"\n', {"A": "x y", "B": "$HOME", "C": 'x"y"'}),
        ("A='one\ntwo'\nB=3\n", {"A": "one\ntwo", "B": "3"}),
        ('A=one\\\ntwo\nB="\\$x\\n"\n', {"A": "onetwo", "B": "$x\\n"}),
        ("A='x' # y\n", {"A": "x# y"}),
        ("A=\nB", {"A": ""}),
        ("A=1\r\nB=2\r\n", {"A": "1", "B": "2"}),
        ("export A=1\nB-C=2\nplain\nD=4", {"D": "4"}),
    ],
)
def test_values(text, expected):
    assert entries(text) == expected


def test_problems_have_their_places():
    found = parse(Source("x.env", "export A=1\nB-C=2\nplain\nD='open\nE=1\n"))
    assert [(problem.code, problem.where.line) for problem in found.problems] == [
        ("export-prefix", 1),
        ("bad-name", 2),
        ("missing-equals", 3),
        ("unterminated-quote", 4),
    ]


@given(st.text(alphabet="A=1 \"'\\\n#;x$", max_size=60))
def test_any_text_is_read_and_spans_lie_inside(text):
    source = Source("x.env", text)
    found = parse(source)
    for entry in found.entries:
        assert 0 <= entry.value.span.start <= entry.value.span.end <= len(text)
        for at in range(len(entry.value)):
            assert text[entry.value.origin(at)] == entry.value[at]
    for problem in found.problems:
        assert 0 <= problem.where.span.start <= problem.where.span.end <= len(text)


def test_files_beat_environment_and_resets_count(tmp_path, monkeypatch):
    units = load(
        tmp_path,
        {
            "etc/systemd/system/a.service": "[Service]\nExecStart=/bin/true\nEnvironment=X=1 Y=1\nEnvironment=\n"
            "EnvironmentFile=/etc/robot/one.env\nEnvironment=A=unit B=unit "
            "C=%p\nUnsetEnvironment=B\nPassEnvironment=P\n",
            "etc/robot/one.env": "A=file\nA=file2\n",
        },
        monkeypatch,
    )
    environment = units.environment(only(units, "a.service"))
    assert environment.complete
    assert environment.text("A") == "file2"
    assert [variable.origin for variable in environment.chain("A")] == [
        "Environment=",
        "EnvironmentFile=",
        "EnvironmentFile=",
    ]
    assert environment.defines("B") is False
    assert environment.text("C") == "a"
    assert environment.defines("P") is True
    assert environment.defines("X") is False


def test_file_that_is_not_in_the_tree_leaves_it_open(tmp_path, monkeypatch):
    text = "[Service]\nExecStart=/bin/true\nEnvironmentFile=-/etc/robot/none.env\n"
    units = load(tmp_path, {"a.service": text}, monkeypatch)
    assert units.environment(only(units, "a.service")).defines("A") is None
    units = load(tmp_path / "root", {"etc/systemd/system/a.service": text}, monkeypatch, root=True)
    assert units.environment(only(units, "a.service")).defines("A") is False


def test_shell_text_and_scripts_add_to_it(tmp_path, monkeypatch):
    units = load(
        tmp_path,
        {
            "a.service": "[Service]\nEnvironment=D=humble\nExecStart=/opt/robot/start.sh\n",
            "opt/robot/start.sh": "#!/bin/bash\nsource /opt/ros/${D}/setup.bash\nexport ID=7 NAME=$D-x\n"
            "if [ -e /x ]; then export ID=8; fi\nOTHER=${NONE:-fallback}\nexec ros2 launch a b.launch.py\n",
        },
        monkeypatch,
    )
    unit = only(units, "a.service")
    (process,) = units.started(unit)
    environment = units.process_environment(process)
    assert environment.text("NAME") == "humble-x"
    assert environment.text("OTHER") == "fallback"
    assert environment.text("ID") is None
    assert len(environment.chain("ID")) == 2
    assert environment.complete


def test_launch_adds_to_the_environment_of_its_unit(tmp_path, monkeypatch):
    units = load(
        tmp_path,
        {
            "etc/systemd/system/a.service": "[Service]\nEnvironment=ROS_DOMAIN_ID=1 RMW_IMPLEMENTATION=a\n"
            "EnvironmentFile=/etc/robot/ros.env\n"
            "ExecStart=/bin/bash -c 'export ROS_LOG_DIR=/x; ros2 launch a.launch.xml'\n",
            "etc/robot/ros.env": "ROS_DOMAIN_ID=2\n",
            "a.launch.xml": "<launch><node pkg='a' exec='plain'/><set_env name='ROS_DOMAIN_ID' value='3'/>"
            "<node pkg='a' exec='own'><env name='ROS_DOMAIN_ID' value='4$(env ROS_DOMAIN_ID)'/></node>"
            "<node pkg='a' exec='more' if='false'/><node pkg='a' exec='next'/></launch>",
        },
        monkeypatch,
    )
    ros = Robot(units.files.tree).ros
    (launcher,) = ros.launchers
    seen = {each.node.label(): each.environment for each in ros.launched_by(launcher)}
    assert {name: each.text("ROS_DOMAIN_ID") for name, each in seen.items()} == {"plain": "2", "own": "43", "next": "3"}
    assert [(each.text, each.origin) for each in seen["own"].chain("ROS_DOMAIN_ID")] == [
        ("1", "Environment="),
        ("2", "EnvironmentFile="),
        ("3", "SetEnvironmentVariable"),
        ("43", "additional_env"),
    ]
    assert seen["own"].text("ROS_LOG_DIR") == "/x"
    assert [process.name for process in ros.processes] == ["a.service", "own of a.service", "next of a.service"]
    assert ros.is_settled(launcher)


def test_only_the_launched_processes_count_when_all_of_them_are_changed(tmp_path, monkeypatch):
    compose = "services:\n  base:\n    image: ros:jazzy\n    environment: {ROS_DOMAIN_ID: 5}\n"
    launch = "launch:\n- set_env: {name: ROS_DOMAIN_ID, value: '6'}\n- node: {pkg: a, exec: b}\n"
    files = {
        "compose.yaml": compose + "    command: bash -c 'export ROS_HOME=/y && ros2 launch a.launch.yaml'\n",
        "a.launch.yaml": launch,
        "run.sh": "#!/bin/sh\nROS_DOMAIN_ID=7 ros2 launch a.launch.yaml\n",
    }
    ros = Robot(load(tmp_path, files, monkeypatch).files.tree).ros
    assert [process.name for process in ros.processes] == ["b of service 'base'", "b of run.sh"]
    (of_service, of_script) = ros.processes
    assert of_service.environment.text("ROS_HOME") == "/y"
    assert [each.text for each in of_service.environment.chain("ROS_DOMAIN_ID")] == ["5", "6"]
    assert [each.text for each in of_script.environment.chain("ROS_DOMAIN_ID")] == ["7", "6"]
    assert of_script.environment.defines("ROS_HOME") is None


def test_a_node_of_several_launch_files_counts_once(tmp_path, monkeypatch):
    part = "<launch><node pkg='a' exec='b'><env name='ROS_DOMAIN_ID' value='5'/></node></launch>"
    entry = "<launch><include file='$(dirname)/part.launch.xml'/></launch>"
    files = {"part.launch.xml": part, "robot.launch.xml": entry, "test_bench.launch.xml": entry}
    ros = Robot(load(tmp_path, files, monkeypatch).files.tree).ros
    assert [process.name for process in ros.processes] == ["b of robot.launch.xml"]


@pytest.mark.parametrize(
    ("variable", "expected"),
    [
        ("RMW_IMPLEMENTATION=rmw_fastrtps_cpp", True),
        ('"CYCLONEDDS_URI=<Domain/>"', True),
        ("CYCLONEDDS_URI=file:///etc/dds.xml", False),
        ("SPEED=1", False),
    ],
)
def test_a_middleware_in_the_environment_is_of_ros(tmp_path, monkeypatch, variable, expected):
    units = load(tmp_path, {"a.service": f"[Service]\nEnvironment={variable}\nExecStart=/opt/drive\n"}, monkeypatch)
    assert units.files.is_ros is expected


def test_processes_are_counted_once_when_launch_gets_arguments(tmp_path, monkeypatch):
    units = load(
        tmp_path,
        {
            "a.service": "[Service]\nExecStart=/bin/bash -c 'ros2 launch a.launch.xml speed:=2'\n",
            "a.launch.xml": "<launch><arg name='speed' default='1'/><node pkg='a' exec='plain'/>"
            "<node pkg='a' exec='own'><env name='ROS_DOMAIN_ID' value='4'/></node></launch>",
        },
        monkeypatch,
    )
    ros = Robot(units.files.tree).ros
    assert [(process.name, ros.started_by(process)) for process in ros.processes] == [
        ("a.service", 1),
        ("own of a.service", 1),
    ]
