"""Compose files: services with what merge keys, extends and both syntaxes bring."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bringup_lint.model.compose import ComposeFile
from bringup_lint.model.compose import split
from bringup_lint.parsers.compose import parse
from bringup_lint.source import Located
from bringup_lint.source import Source


def read(text: str) -> ComposeFile:
    return parse(Source("compose.yaml", text, kind="compose"))


DRIVER = """\
x-env: &env {ROS_DOMAIN_ID: 42, LANG: C}
services:
  base:
    image: ros:jazzy
    network_mode: host
    environment: [RMW_IMPLEMENTATION=rmw_cyclonedds_cpp, DISPLAY]
  driver:
    extends: base
    image: robot/driver:1.2
    environment:
      <<: *env
      LANG: C.UTF-8
    env_file: [robot.env, {path: more.env, required: false}]
    devices: ["/dev/ttyUSB0:/dev/lidar", "${CAMERA:-/dev/video0}:/dev/video0"]
    volumes:
      - ./keys:/keys:ro
      - {type: bind, source: /dev, target: /dev}
      - logs:/var/log
    command: bash -c "source /opt/ros/jazzy/setup.bash && ros2 launch base base.launch.py"
    stop_grace_period: 1m30s
"""


def test_a_service_is_read_whole():
    driver = read(DRIVER).service("driver")
    assert driver.is_on_host_network and driver.image == "robot/driver:1.2"
    assert {name: variable.value for name, variable in driver.environment.items()} == {
        "RMW_IMPLEMENTATION": "rmw_cyclonedds_cpp",
        "DISPLAY": None,
        "LANG": "C.UTF-8",
        "ROS_DOMAIN_ID": "42",
    }
    assert driver.env_files == ["robot.env", "more.env"]
    assert [device.host for device in driver.devices] == ["/dev/ttyUSB0", "${CAMERA:-/dev/video0}"]
    assert [(volume.source, volume.target, volume.read_only) for volume in driver.volumes] == [
        ("./keys", "/keys", True),
        ("/dev", "/dev", False),
        ("logs", "/var/log", False),
    ]
    assert driver.command[:2] == ("bash", "-c")
    assert driver.launches == driver.command[2]
    assert driver.stop_grace == 90
    assert driver.is_ros


def test_values_stand_where_they_are_written():
    driver = read(DRIVER).service("driver")
    assert driver.environment["ROS_DOMAIN_ID"].value.line == 1
    assert driver.devices[0].host.span.text == "/dev/ttyUSB0"
    assert driver.key("network_mode").line == 5


def test_a_circle_of_extends_ends():
    services = read("services: {a: {extends: b, image: x}, b: {extends: a}}").services
    assert [service.image for service in services] == ["x", "x"] or services[1].image is None


def test_launch_in_separate_words():
    service = read("services: {a: {image: x, command: [ros2, launch, base, base.launch.py]}}").service("a")
    assert service.launches == "launch"


@pytest.mark.parametrize(
    ("written", "given"),
    [
        ("bash -c source /a && ros2 launch b c", "bash -c source /a"),
        ("ros2 topic echo /d > /data/d.txt", "ros2 topic echo /d"),
        ("A=1 sleep 5 &", "A=1 sleep 5"),
        ("|\n      ros2 run\n      a b", "ros2 run a b"),
        ('bash -c "a && b"', "bash -c a && b"),
    ],
)
def test_a_command_ends_at_the_first_operator(written: str, given: str) -> None:
    service = read(f"services:\n  a:\n    command: {written}\n").service("a")
    assert " ".join(service.command) == given
    assert service.launches is None


def test_split():
    text = Located("${A:-b:c}:/d:ro", Source("x", "${A:-b:c}:/d:ro").span(0, 15))
    assert split(text) == ["${A:-b:c}", "/d", "ro"]


READ = [
    "environment",
    "env_files",
    "devices",
    "volumes",
    "tmpfs",
    "is_ros",
    "command",
    "build",
    "launches",
    "restarts",
]
BODY = st.dictionaries(
    st.sampled_from(
        [
            "image",
            "build",
            "command",
            "environment",
            "env_file",
            "devices",
            "volumes",
            "extends",
            "user",
            "restart",
        ]
    ),
    st.sampled_from(
        [
            "x",
            "[]",
            "{}",
            "~",
            "[a, b]",
            "{a: b}",
            "[{}]",
            "'a:b:c'",
            "[a:b]",
            "a",
            "b",
            "true",
            "{service: a}",
            "[~]",
        ]
    ),
)


@given(BODY, BODY)
def test_no_text_raises(one, other):
    bodies = ["{" + ", ".join(f"{key}: {value}" for key, value in body.items()) + "}" for body in (one, other)]
    one, other = bodies
    for service in read(f"services: {{a: {one}, b: {other}}}").services:
        for name in READ:
            getattr(service, name)


def test_services_that_extend_very_many_others_stay_unknown() -> None:
    chain = "".join(f"  s{at}: {{extends: s{at + 1}}}\n" for at in range(3_000))
    file = parse(Source("compose.yaml", f"services:\n{chain}  s3000: {{image: robot}}\n"))
    assert file.services[0].image is None
    assert file.services[2_990].image == "robot"
