"""``bringup-lint live`` against real nodes on the loopback, with rclpy and Fast DDS of the wheels."""

from __future__ import annotations

import importlib.util
import os
import random
from itertools import count
from pathlib import Path

import pytest

from bringup_lint.live import ports
from tests.lint import Run
from tests.lint import lint
from tests.oracles.live_nodes import running
from tests.oracles.live_nodes import watching

pytestmark = pytest.mark.skipif(importlib.util.find_spec("rclpy") is None, reason="needs ros-jazzy-rclpy")

LAUNCH = """from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='otter_lidar', executable='driver', name='driver', namespace='lidar'),
        Node(package='otter_slam', executable='slam', name='slam'),
        Node(package='otter_base', executable='base', name='base', arguments=['--ros-args', '--enclave', '/base']),
        Node(package='nav2_amcl', executable='amcl', name='amcl'),
        Node(package='otter_teleop', executable='teleop', name='teleop'),
        {more}
    ])
"""
LIDAR = {"name": "driver", "namespace": "/lidar", "publishes": {"/scan": "BEST_EFFORT"}}
SLAM = {"name": "slam", "subscribes": {"/scan": "BEST_EFFORT"}}
BASE = {"name": "base"}
AMCL = {"name": "amcl"}
TELEOP = {"name": "teleop"}
GOOD = (LIDAR, SLAM, BASE, AMCL, TELEOP)
BAD = (
    {**LIDAR, "publishes": {"/scan": "BEST_EFFORT", "/odometry": "RELIABLE"}},
    {**LIDAR, "publishes": {}},
    {**SLAM, "subscribes": {"/scan": "RELIABLE", "/odometri": "RELIABLE"}, "publishes": {"/cmd_vel": "RELIABLE"}},
    BASE,
    {**AMCL, "lifecycle": True},
    {**TELEOP, "publishes": {"/cmd_vel": "RELIABLE"}},
    {"name": "stranger"},
)
MESSAGES = {
    "node-missing": "/planner is not running on domain {domain}",
    "node-unexpected": "/stranger runs on domain {domain}, but no file starts it",
    "node-duplicate": "2 nodes with the name /lidar/driver are running",
    "topic-typo": "Nobody publishes /odometri, which /slam waits for; /lidar/driver publishes /odometry",
    "qos-incompatible": "/slam gets nothing on /scan: it requests reliable, but /lidar/driver offers best effort",
    "cmd-vel-publishers": "2 nodes publish /cmd_vel (/slam, /teleop)",
    "enclave-unsecured": "/base runs in the enclave /, not in /base",
    "lifecycle-not-active": "/amcl is unconfigured, not active",
}


TENS = count(random.randrange(12))


@pytest.fixture
def domain() -> int:
    return some_domain()


def some_domain() -> int:
    """One that no other test takes, nor another worker of a parallel run."""
    worker = int(os.environ.get("PYTEST_XDIST_WORKER", "gw0").removeprefix("gw")) % 10
    return 110 + next(TENS) % 12 * 10 + worker


@pytest.fixture(autouse=True)
def shell(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    set_shell(monkeypatch, tmp_path)


def set_shell(monkeypatch: pytest.MonkeyPatch, folder: Path) -> None:
    """A shell without ROS variables, on the loopback only, that does not see the ports of other tests."""
    for name in [
        name for name in os.environ if name.startswith(("ROS_", "RMW_", "RCUTILS_", "FASTRTPS_", "CYCLONEDDS_"))
    ]:
        monkeypatch.delenv(name)
    monkeypatch.setenv("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST")
    monkeypatch.setenv("ROS_LOG_DIR", str(folder / "log"))
    monkeypatch.setattr(ports, "TABLES", ())


def on(domain: int) -> dict[str, str]:
    return {**os.environ, "ROS_DOMAIN_ID": str(domain)}


def tree(folder: Path, domain: int, more: str = "") -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "otter.launch.py").write_text(LAUNCH.format(more=more))
    (folder / "ros.env").write_text(f"ROS_DOMAIN_ID={domain}\n")
    return folder


TWICE = ("--wait", "2")
"""Long enough where a second look follows."""


def live(folder: Path, *options: str) -> Run:
    return lint("live", "--output-format", "concise", *options, ".", cwd=folder)


@pytest.fixture(scope="module")
def bad_robot(tmp_path_factory: pytest.TempPathFactory) -> tuple[int, Run]:
    """What is said about a robot with all that can be wrong within one domain."""
    domain = some_domain()
    folder = tmp_path_factory.mktemp("robot")
    more = "Node(package='otter_plan', executable='plan', name='planner'),"
    with pytest.MonkeyPatch.context() as patch:
        set_shell(patch, folder)
        with running(*BAD, environment=on(domain)):
            return domain, live(tree(folder / "tree", domain, more), *TWICE)


@pytest.mark.parametrize("rule", MESSAGES)
def test_each_rule_finds_its_defect(rule: str, bad_robot: tuple[int, Run]) -> None:
    domain, run = bad_robot
    lines = [line for line in run.stdout.splitlines() if f"[live/{rule}]" in line]
    assert len(lines) == 1, (run.stdout, run.stderr)
    assert MESSAGES[rule].format(domain=domain) in lines[0]
    assert run.code == 1


def test_it_says_what_it_looks_at(bad_robot: tuple[int, Run]) -> None:
    domain, run = bad_robot
    assert run.stderr.splitlines()[0] == f"Looking at domain {domain} (ros.env:1) ..."


PARAMETERS = """/base:
  ros__parameters:
    max_speed: 0.1
    wheels: 4
    brake: true
    frame: base_link
    not_declared: 1
"""


def test_values_of_running_nodes(tmp_path: Path, domain: int) -> None:
    folder = tree(tmp_path / "tree", domain)
    launch = folder / "otter.launch.py"
    start = f"name='base', parameters=['{folder / 'base.yaml'}'],"
    launch.write_text(launch.read_text().replace("name='base', arguments=['--ros-args', '--enclave', '/base']", start))
    (folder / "base.yaml").write_text(PARAMETERS)
    has = {"max_speed": 0.1, "wheels": 6, "brake": True, "frame": "odom"}
    with running(*GOOD[:2], {**BASE, "parameters": has}, *GOOD[3:], environment=on(domain)):
        run = live(folder, "--select", "live/param-differs", "--save", "seen.yaml")
    assert "name: not_declared" not in (folder / "seen.yaml").read_text()
    assert "odom" not in (folder / "seen.yaml").read_text(), "a text may be a secret"
    (line,) = run.stdout.splitlines()
    assert line == "base.yaml:4:13: warning[live/param-differs] /base runs with wheels = 6, but base.yaml says 4"


def test_a_robot_that_is_as_its_files_say_gives_nothing(tmp_path: Path, domain: int) -> None:
    folder = tree(tmp_path / "tree", domain)
    (folder / "otter.launch.py").write_text((folder / "otter.launch.py").read_text().replace("'/base'", "'/'"))
    with running(*GOOD, environment=on(domain)):
        run = live(folder, "--min-severity", "info")
    assert (run.code, run.stdout) == (0, ""), run.stderr


def test_nodes_on_another_domain_than_the_files_say(
    tmp_path: Path, domain: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tree(tmp_path / "tree", domain - 100)
    monkeypatch.setenv("ROS_DOMAIN_ID", str(domain))
    with running(*GOOD, environment=on(domain)):
        run = live(folder, *TWICE, "--select", "live/domain-mismatch")
    expected = f"ros.env says domain {domain - 100}, where no node of the robot runs; 5 nodes run on domain {domain}"
    assert expected in run.stdout, (run.stdout, run.stderr)
    assert f"Looking at domain {domain} (ROS_DOMAIN_ID of this shell)" in run.stderr


def test_nodes_are_looked_for_on_the_domains_that_files_mention(tmp_path: Path, domain: int) -> None:
    folder = tree(tmp_path / "tree", domain - 100)
    (folder / "development").mkdir()
    (folder / "development/ros.env").write_text(f"ROS_DOMAIN_ID={domain}\n")
    with running(*GOOD, environment=on(domain)):
        run = live(folder, *TWICE)
    lines = [line for line in run.stdout.splitlines() if line.startswith("ros.env:1:15:")]
    assert len(lines) == 1, (run.stdout, run.stderr)
    assert lines[0].endswith(f"where no node of the robot runs; 5 nodes run on domain {domain}")
    assert "node-missing" not in run.stdout


def test_nodes_on_a_domain_that_no_file_mentions(tmp_path: Path, domain: int, monkeypatch: pytest.MonkeyPatch) -> None:
    folder = tree(tmp_path / "tree", domain - 100)
    with running(*GOOD, environment=on(domain)):
        monkeypatch.setattr(ports, "TABLES", ("/proc/net/udp",))
        run = live(folder, *TWICE)
    assert f"Domain {domain} shows 5: /amcl, /base, /lidar/driver, ... Look there with" in run.stderr
    assert "where no node of the robot runs; " in run.stdout, (run.stdout, run.stderr)


def test_one_node_on_another_domain(tmp_path: Path, domain: int) -> None:
    folder = tree(tmp_path / "tree", domain)
    (folder / "development").mkdir()
    (folder / "development/ros.env").write_text(f"ROS_DOMAIN_ID={domain - 100}\n")
    others = [node for node in GOOD if node is not SLAM]
    with running(*others, environment=on(domain)), running(SLAM, environment=on(domain - 100)):
        run = live(folder, *TWICE, "--select", "live/domain-mismatch,live/node-missing")
    assert f"/slam runs on domain {domain - 100}, but ros.env says {domain}" in run.stdout, (
        run.stdout,
        run.stderr,
    )
    assert run.stdout.count("\n") == 1


def test_files_that_ask_for_security_and_nodes_without(tmp_path: Path, domain: int) -> None:
    folder = tree(tmp_path / "tree", domain)
    (folder / "ros.env").write_text(
        f"ROS_DOMAIN_ID={domain}\nROS_SECURITY_ENABLE=true\nROS_SECURITY_STRATEGY=Enforce\n"
    )
    with running(*GOOD, environment=on(domain), arguments=("--ros-args", "--enclave", "/base")):
        run = live(folder, "--select", "live/enclave-unsecured")
    assert "5 nodes of domain" in run.stdout, (run.stdout, run.stderr)
    assert "runs in the enclave" not in run.stdout


def test_it_publishes_nothing_and_offers_nothing(tmp_path: Path, domain: int) -> None:
    folder = tree(tmp_path / "tree", domain)
    nodes = [{**node, "lifecycle": node is AMCL} for node in GOOD]
    with running(*nodes, environment=on(domain)), watching("_bringup_lint", 6, on(domain)) as answers:
        run = live(folder)
    assert "/amcl is unconfigured" in run.stdout, run.stderr
    assert answers == [
        {
            "seen": ["_bringup_lint"],
            "publishers": [],
            "subscriptions": [],
            "services": [],
            "clients": answers[0]["clients"],
        }
    ]
    assert set(answers[0]["clients"]) <= {"/amcl/get_state"}


def test_an_enclave_without_its_keystore_is_told_in_one_line(
    tmp_path: Path, domain: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ROS_SECURITY_ENABLE", "true")
    monkeypatch.setenv("ROS_SECURITY_STRATEGY", "Enforce")
    monkeypatch.setenv("ROS_SECURITY_KEYSTORE", str(tmp_path / "keys"))
    run = live(tree(tmp_path / "tree", domain), "--enclave", "/lint")
    assert run.code == 2
    assert "SECURITY ERROR" in run.stderr.splitlines()[-1]
    assert len(run.stderr.splitlines()) == 2


def test_a_middleware_that_is_not_installed_is_told_in_one_line(
    tmp_path: Path, domain: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "rmw_gurumdds_cpp")
    run = live(tree(tmp_path / "tree", domain))
    assert run.code == 2
    assert run.stderr.splitlines()[-1].endswith(
        "rmw_gurumdds_cpp is not installed; RMW_IMPLEMENTATION=rmw_fastrtps_cpp looks with the one that is"
    )
    assert "Traceback" not in run.stderr
