"""What a file is: each kind claims its own files only."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from bringup_lint.discover.kinds import HEAD_SIZE
from bringup_lint.discover.kinds import kind_of
from bringup_lint.discover.kinds import kinds
from tests.conftest import PROJECT


def claims(path: Path) -> list[str]:
    """The names of all kinds that claim a file."""

    def head() -> str:
        with path.open("rb") as file:
            return file.read(HEAD_SIZE).decode("utf-8", "replace")

    return [kind.name for kind in kinds() if kind.claims(path.as_posix(), head)]


def fixtures() -> Iterator[Path]:
    return (path for path in (PROJECT / "fixtures").rglob("*") if path.is_file() and not path.is_symlink())


@pytest.mark.slow
def test_no_file_is_claimed_twice() -> None:
    found = {str(path.relative_to(PROJECT)): claims(path) for path in fixtures()}
    assert {path: names for path, names in found.items() if len(names) > 1} == {}
    assert any(found.values())


@pytest.mark.parametrize(
    ("path", "kind"),
    [
        ("etc/fstab", "fstab"),
        ("board/fstab.jetson", "fstab"),
        ("robot.fstab", "fstab"),
        ("parsers/fstab.py", ""),
        ("src/fstab.c", ""),
        ("docs/fstab.md", ""),
        ("etc/fstab.bak", ""),
    ],
)
def test_an_fstab_is_a_table(path: str, kind: str) -> None:
    text = "/dev/mmcblk0p1 / ext4 defaults 0 1\n"
    assert kind_of(path, lambda: text) == kind


@pytest.mark.parametrize(
    ("path", "kind"),
    [
        ("etc/stack/compose.yaml.default", "compose"),
        ("docker-compose.yml.example", "compose"),
        ("docker-compose.yml.bak", ""),
    ],
)
def test_a_sample_is_of_the_kind_of_its_copy(path: str, kind: str) -> None:
    assert kind_of(path, lambda: "services:\n  nav:\n    image: ros:jazzy\n") == kind


@pytest.mark.parametrize(
    ("path", "text", "kind"),
    [
        ("roles/rover/templates/start.sh.j2", "{{ ansible_managed }}\n", "shell-script"),
        ("roles/rover/templates/start.j2", "#!/bin/bash\n", "shell-script"),
        ("roles/rover/templates/start.j2", "#jinja2: trim_blocks: False\n#!/bin/bash\n", "shell-script"),
        ("roles/rover/templates/start.j2", "#!/usr/bin/fish\n", ""),
        ("ansible/roles/rover/files/start", "#!/bin/sh\n", "shell-script"),
        ("roles/rover/files/start", "#!/bin/sh\n", "shell-script"),
        ("start.sh.example", "#!/bin/sh\n", ""),
    ],
)
def test_script_by_its_final_name(path: str, text: str, kind: str) -> None:
    assert kind_of(path, lambda: text) == kind


@pytest.mark.parametrize(
    ("path", "text", "kind"),
    [
        ("rover_base/debian/udev", 'SUBSYSTEM=="tty", MODE="0660"\n', "udev-rules"),
        ("debian/rover-base.udev", 'SUBSYSTEM=="tty", MODE="0660"\n', "udev-rules"),
        ("debian/udev", "see the package of the driver\n", ""),
        ("scripts/udev.udev", 'SUBSYSTEM=="tty", MODE="0660"\n', ""),
    ],
)
def test_rules_of_a_debian_package(path: str, text: str, kind: str) -> None:
    assert kind_of(path, lambda: text) == kind


@pytest.mark.parametrize(
    ("path", "text", "kind"),
    [
        ("setup/.bashrc", "alias up='ros2 launch rover up.launch.py'\n", "shell-script"),
        ("docker/ros.bashrc", "source /opt/ros/jazzy/setup.bash\n", "shell-script"),
        ("home/.bash_aliases", "alias s='source install/setup.bash'\n", "shell-script"),
        ("robot/start-rover", "#!/bin/bash\nros2 launch rover up.launch.py\n", "shell-script"),
        ("robot/start-rover", "#!/usr/bin/env python3\n", ""),
        ("android/gradlew", "#!/bin/sh\n", ""),
        (".githooks/pre-push", "#!/bin/sh\n", ""),
        ("notes/bashrc.md", "#!/bin/bash\n", ""),
    ],
)
def test_a_script_needs_no_ending(path: str, text: str, kind: str) -> None:
    assert kind_of(path, lambda: text) == kind


@pytest.mark.parametrize(
    ("path", "text", "kind"),
    [
        ("docker/rover-amd64", "# the laptop\nARG DISTRO=jazzy\n\nFROM ros:${DISTRO}\n", "dockerfile"),
        ("GenericDockerfile", "FROM busybox\n", "dockerfile"),
        ("docker/notes", "From the robot's makers\n", ""),
        ("scripts/rover-amd64", "FROM ros:jazzy\n", ""),
    ],
)
def test_an_image_needs_no_usual_name(path: str, text: str, kind: str) -> None:
    assert kind_of(path, lambda: text) == kind


@pytest.mark.parametrize(
    ("path", "text", "kind"),
    [
        ("requirements.txt", "numpy\n", "pip-requirements"),
        ("setup/robot-pip-requirements.txt", "numpy==1.26\n", "pip-requirements"),
        ("requirements/robot.in", "numpy\n", "pip-requirements"),
        ("docs/requirements.txt", "The robot needs power.\n", ""),
        ("requirements.md", "numpy\n", ""),
    ],
)
def test_requirements_are_a_list(path: str, text: str, kind: str) -> None:
    assert kind_of(path, lambda: text) == kind
