"""Which files of a tree belong to one robot, though neither names the other."""

from __future__ import annotations

from pathlib import Path

import pytest

from bringup_lint.discover.walk import discover
from bringup_lint.robot import Robot

UNIT = "[Service]\nExecStart=/bin/true\n"


def robot(folder: Path, *names: str) -> Robot:
    for name in names:
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(UNIT if name.endswith(".service") else "ROS_DOMAIN_ID=7\n")
    return Robot(discover([str(folder)]))


def together(robot: Robot, one: str, other: str) -> bool:
    def find(name: str):
        return next(source for source in robot.sources if source.name.endswith(name))

    return robot.same_robot(find(one), find(other))


@pytest.mark.parametrize(
    ("one", "other", "expected"),
    [
        ("a/etc/robot/ros.env", "a/etc/systemd/system/drive.service", True),
        ("a/etc/robot/ros.env", "b/etc/systemd/system/drive.service", False),
    ],
)
def test_overlays_are_robots(tmp_path: Path, one: str, other: str, expected: bool) -> None:
    assert together(robot(tmp_path, one, other), one, other) is expected


def test_folders_that_are_alike_are_variants(tmp_path: Path) -> None:
    tree = robot(tmp_path, "heron/ros.env", "heron/drive.service", "kite/ros.env", "kite/drive.service")
    assert together(tree, "heron/ros.env", "heron/drive.service")
    assert not together(tree, "heron/ros.env", "kite/drive.service")


def test_folders_by_purpose_are_one_robot(tmp_path: Path) -> None:
    tree = robot(tmp_path, "environment/ros.env", "systemd/drive.service", "README")
    assert together(tree, "environment/ros.env", "systemd/drive.service")


def test_a_path_means_no_file_of_another_robot(tmp_path: Path) -> None:
    tree = robot(tmp_path, "heron/ros.env", "heron/drive.service", "kite/drive.service", "kite/spare.env")
    kite = next(source for source in tree.sources if source.name.endswith("kite/drive.service"))
    heron = next(source for source in tree.sources if source.name.endswith("heron/drive.service"))
    assert tree.find("/etc/robot/ros.env", kite) is None
    assert tree.find("/etc/robot/ros.env", heron) is not None


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ("ros.env", "heron/systemd/drive.service"),
        ("heron/ros.env", "heron/systemd/units/drive.service"),
        ("ros.env", "drive.service"),
    ],
)
def test_a_file_beside_a_folder_is_for_what_the_folder_holds(tmp_path: Path, one: str, other: str) -> None:
    """Also when the folder holds files of the same kind; and whichever of the two files asks."""
    tree = robot(tmp_path, one, other, other.rpartition("/")[0] + "/spare.env")
    assert together(tree, one, other)
    assert together(tree, other, one)


def test_the_relation_has_no_direction(tmp_path: Path) -> None:
    names = [
        "ros.env",
        "heron/ros.env",
        "heron/units/drive.service",
        "kite/ros.env",
        "kite/units/drive.service",
        "board/etc/systemd/system/drive.service",
        "board/etc/robot/ros.env",
    ]
    tree = robot(tmp_path, *names)
    for one in tree.sources:
        for other in tree.sources:
            assert tree.same_robot(one, other) is tree.same_robot(other, one), (one.name, other.name)
