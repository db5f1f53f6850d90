"""What a file is for, by the configuration, its path, and the names of what is in it."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bringup_lint.config import PURPOSES
from bringup_lint.discover.walk import discover
from bringup_lint.graph.purpose import PATHS
from bringup_lint.graph.purpose import Purpose
from bringup_lint.graph.purpose import by_path
from bringup_lint.registry import Registry
from bringup_lint.robot import Robot
from bringup_lint.source import Source
from tests.conftest import PROJECT
from tests.lint import lint

COMPOSE = """\
services:
  drive:
    image: lab/drive:1.0
    privileged: true
"""


WORDS = ("ci", ".github", "old", "test", "tests", "_test", "sim", "gz", "demo", "docs", "docker", "pc", "dev", "train")
PARTS = (*WORDS, "/", "_", "-", ".", "robot", ".bak", ".devcontainer/", "Dockerfile")


@given(st.lists(st.sampled_from(PARTS), max_size=8).map("".join))
def test_a_path_is_for_the_first_pattern_that_it_matches(path: str) -> None:
    assert by_path(path) == next((purpose for purpose, pattern in PATHS if pattern.search(path)), Purpose.ROBOT)


@pytest.mark.parametrize(
    ("path", "expected"),
    [
        ("deploy/robot.service", Purpose.ROBOT),
        (".devcontainer/docker-compose.yml", Purpose.DEVELOPMENT),
        (".devcontainer/release/release.Dockerfile", Purpose.ROBOT),
        (".devcontainer/base/Dockerfile", Purpose.DEVELOPMENT),
        ("docker/pc/compose.yaml", Purpose.DEVELOPMENT),
        ("onboard/pc/compose.yaml", Purpose.ROBOT),
        ("docker-compose.dev.yml", Purpose.DEVELOPMENT),
        ("device/robot.service", Purpose.ROBOT),
        ("compose.simulation.yaml", Purpose.SIMULATION),
        ("launch/sim_time.launch.py", Purpose.SIMULATION),
        ("launch/simple.launch.py", Purpose.ROBOT),
        ("isaac_ros_visual_slam/launch/slam.launch.py", Purpose.ROBOT),
        ("test/Dockerfile", Purpose.TEST),
        ("launch/test_motors.launch.py", Purpose.TEST),
        ("launch/latest.launch.py", Purpose.ROBOT),
        (".github/docker/Dockerfile", Purpose.CI),
        ("docker/Dockerfile.ci", Purpose.CI),
        ("examples/compose.yaml", Purpose.EXAMPLE),
        ("docs/setup/compose.yaml", Purpose.EXAMPLE),
        ("src/python_package_template/launch/node.launch.py", Purpose.EXAMPLE),
        ("roles/base/templates/rover.service", Purpose.ROBOT),
        ("dock/compose.yaml", Purpose.ROBOT),
        ("parser/testfiles-negative/Dockerfile", Purpose.TEST),
        ("test-install.sh", Purpose.TEST),
        ("docker_old/compose.yaml", Purpose.ARCHIVE),
        ("Notes/OldDocs&Files/setup.sh", Purpose.ARCHIVE),
        ("deploy/robot.service.bak", Purpose.ARCHIVE),
        ("backup.service", Purpose.ROBOT),
        ("xil_yard/compose.yaml", Purpose.SIMULATION),
        ("docker/train_detector/compose.yaml", Purpose.DEVELOPMENT),
        ("docker/constrained/compose.yaml", Purpose.ROBOT),
        ("deploy/wsl_docker/compose.yaml", Purpose.DEVELOPMENT),
        ("deploy/compose.mitm.yaml", Purpose.TEST),
        ("self_hosted_runner/compose.yaml", Purpose.CI),
        ("task_runner/compose.yaml", Purpose.ROBOT),
    ],
)
def test_paths_tell_the_purpose(path: str, expected: Purpose) -> None:
    assert by_path(path) is expected


def test_a_folder_of_an_older_version_is_an_archive(tmp_path: Path) -> None:
    for version in ("1.9.0", "1.10.0"):
        unit = tmp_path / version / "systemd" / "robot.service"
        unit.parent.mkdir(parents=True)
        unit.write_text("[Service]\nExecStart=/bin/true\n")
    robot = Robot(discover([str(tmp_path)]))
    purposes = {source.name.split("/")[-3]: robot.purpose(source) for source in robot.sources}
    assert purposes == {"1.9.0": Purpose.ARCHIVE, "1.10.0": Purpose.ROBOT}


def test_where_a_checkout_is_says_nothing(tmp_path: Path) -> None:
    unit = tmp_path / "test" / "old" / "deploy" / "robot.service"
    unit.parent.mkdir(parents=True)
    unit.write_text("[Service]\nExecStart=/bin/true\n")
    robot = Robot(discover([str(tmp_path / "test" / "old")]))
    assert robot.purpose(robot.sources[0]) is Purpose.ROBOT


def test_the_configuration_decides_first(tmp_path: Path) -> None:
    (tmp_path / "docker" / "lab").mkdir(parents=True)
    (tmp_path / "docker" / "lab" / "compose.yaml").write_text(COMPOSE)
    shown = lint("--select", "compose/privileged", "--output-format", "concise", ".", cwd=tmp_path).stdout
    assert "compose/privileged" in shown
    (tmp_path / "bringup-lint.toml").write_text('[purpose]\n"docker/lab" = "ci"\n')
    assert lint("--select", "compose/privileged", "--output-format", "concise", ".", cwd=tmp_path).stdout == ""


def test_what_tests_read_is_wrong_on_purpose(tmp_path: Path) -> None:
    unit = tmp_path / "test" / "units" / "robot.service"
    unit.parent.mkdir(parents=True)
    unit.write_text("[Service]\nExecStart=/bin/true\nRestrt=always\n")
    arguments = ("--select", "systemd/unknown-key", "--output-format", "concise", ".")
    assert "info[systemd/unknown-key]" in lint(*arguments, cwd=tmp_path).stdout
    (tmp_path / "bringup-lint.toml").write_text('[purpose]\n"test" = "robot"\n')
    assert "error[systemd/unknown-key]" in lint(*arguments, cwd=tmp_path).stdout


def test_a_purpose_that_does_not_exist_is_a_usage_error(tmp_path: Path) -> None:
    (tmp_path / "bringup-lint.toml").write_text('[purpose]\n"docker" = "lab"\n')
    run = lint(".", cwd=tmp_path)
    assert run.code == 2
    assert "must be one of robot, development, simulation, test, ci, example, archive, not 'lab'" in run.stderr


def test_a_service_says_by_its_name_that_it_simulates(tmp_path: Path) -> None:
    (tmp_path / "compose.yaml").write_text(COMPOSE.replace("drive:\n", "gazebo:\n", 1))
    run = lint("--output-format", "concise", ".", cwd=tmp_path)
    assert "compose/privileged" not in run.stdout


def test_a_dockerfile_is_for_what_builds_it(tmp_path: Path) -> None:
    (tmp_path / "Dockerfile").write_text('FROM ros:jazzy\nCMD ["ros2", "run", "a", "b"]\n')
    assert "docker/root-user" in lint("--output-format", "concise", ".", cwd=tmp_path).stdout
    (tmp_path / ".devcontainer").mkdir()
    (tmp_path / ".devcontainer" / "compose.yaml").write_text("services:\n  shell:\n    build: ..\n    user: '1000'\n")
    assert "docker/root-user" not in lint("--output-format", "concise", ".", cwd=tmp_path).stdout


def test_the_configuration_knows_every_purpose() -> None:
    assert tuple(purpose.value for purpose in Purpose) == PURPOSES


def test_families_name_rules_that_exist() -> None:
    for family in Registry.of().families:
        assert family.deployment <= {path.stem for path in family.rule_paths}
        assert bool(family.purposes) == bool(family.deployment)


def test_the_page_lists_what_each_family_does(update_expected: bool) -> None:
    page = PROJECT / "docs" / "purposes.md"
    head, mark, _ = page.read_text("utf-8").partition("<!-- table -->\n")
    rows = ["| family | silent | information only | rules that judge deployment |", "|---|---|---|---|"]
    for family in Registry.of().families:
        if family.purposes:
            silent = [purpose.value for purpose, severity in family.purposes.items() if severity is None]
            lowered = [purpose.value for purpose, severity in family.purposes.items() if severity is not None]
            rules = ", ".join(sorted(stem.replace("_", "-") for stem in family.deployment))
            rows.append(f"| {family.name} | {', '.join(silent)} | {', '.join(lowered)} | {rules} |")
    expected = head + mark + "\n" + "\n".join(rows) + "\n"
    if update_expected:
        page.write_text(expected, "utf-8")
    assert page.read_text("utf-8") == expected


def test_a_file_that_is_read_and_not_walked_has_one(tmp_path: Path) -> None:
    """A configuration that a command names, in a folder that is called after a version."""
    (tmp_path / "robot.service").write_text("[Service]\nExecStart=/usr/sbin/ser2net\n")
    robot = Robot(discover([str(tmp_path)]))
    source = Source(str(tmp_path / "vendor/1.2.3/ser2net.yaml"), "")
    assert robot.files.purpose(source) is Purpose.ROBOT


@pytest.mark.parametrize(
    ("command", "restart", "expected"),
    [
        ("ros2 launch rover rover.launch.py", "always", Purpose.ROBOT),
        ("ros2 launch rover rover.launch.py", '"no"', Purpose.DEVELOPMENT),
        ("sleep infinity", "unless-stopped", Purpose.DEVELOPMENT),
    ],
)
def test_nobody_develops_in_a_container_that_starts_the_robot_at_boot(
    tmp_path: Path, command: str, restart: str, expected: Purpose
) -> None:
    folder = tmp_path / ".devcontainer" / "rover"
    folder.mkdir(parents=True)
    (folder / "compose.yaml").write_text(f"{COMPOSE}    command: {command}\n    restart: {restart}\n", "utf-8")
    (tmp_path / "Dockerfile").write_text("FROM scratch\n", "utf-8")
    robot = Robot(discover([str(tmp_path)]))
    assert [robot.purpose(source) for source in robot.of_kind("compose")] == [expected]
