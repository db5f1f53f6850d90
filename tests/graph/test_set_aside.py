"""What a tree keeps and uses no more, and what it uses somewhere."""

from __future__ import annotations

from pathlib import Path

import pytest

from bringup_lint.discover.tree import Tree
from bringup_lint.discover.walk import discover
from bringup_lint.robot import Robot
from bringup_lint.source import Source
from tests.lint import lint

UNIT = "[Service]\nExecStart=/usr/bin/%s\n"
UNITS = {f"units/{name}.service": UNIT % name for name in ("drive", "lidar", "weir")}
INSTALLS = {
    "install.sh": "#!/bin/sh\ncp units/drive.service /etc/systemd/system\ncp units/lidar.service /etc/systemd/system\n"
}
PLAY = "- hosts: all\n  roles:\n    - %s\n    - role: lidar\n"
TASK = "- name: install a package\n  apt:\n    name: chrony\n"
ROLES = {f"ansible/roles/{name}/tasks/main.yml": TASK for name in ("drive", "lidar", "weir")}
WEIR = "ansible/roles/weir/tasks/main.yml"
IMAGE = "FROM ros:humble\nCOPY scripts/install-a.sh scripts/install-b.sh /opt/\nRUN /opt/install-a.sh\n"
SCRIPT = "#!/bin/sh\napt-get install -y chrony\n"
SCRIPTS = {f"docker/scripts/{name}.sh": SCRIPT for name in ("install-a", "install-b", "install-c", "monitor")}
BUILT = {
    "docker/Dockerfile.drive": "FROM ros:humble\n",
    "docker/Dockerfile.weir": "FROM ros:foxy\n",
    "compose.yaml": "services:\n  drive:\n    build: {context: docker, dockerfile: Dockerfile.drive}\n",
}
STACK = (
    "services:\n  drive:\n    build: .\n    volumes: [./src:/ws/src]\n    command: ros2 launch drive drive.launch.py\n"
)
COPIED = {
    "Dockerfile": "FROM ros:humble\n",
    "compose.yaml": STACK,
    "src/Dockerfile": "FROM ros:humble\n",
    "src/compose.yaml": STACK,
}
BASHRC = "source /opt/ros/humble/setup.bash\nexport RMW_IMPLEMENTATION=rmw_cyclonedds_cpp\nexport ROS_DOMAIN_ID=%s\n"
PAGES = {"bashrc": BASHRC % 4, "Documentation/Operation/bashrc": BASHRC % 5}


def robot_of(folder: Path, files: dict[str, str]) -> Robot:
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return Robot(discover([str(folder)]))


def set_aside(folder: Path, files: dict[str, str]) -> list[str]:
    """The files that are set aside."""
    robot = robot_of(folder, files)
    found = (each for each in robot.sources if not robot.leads_to(each))
    return sorted(Path(each.absolute).relative_to(folder).as_posix() for each in found)


@pytest.mark.parametrize(
    ("files", "expected"),
    [
        ({**UNITS, **INSTALLS}, ["units/weir.service"]),
        ({**UNITS, **INSTALLS, "README.md": "├── weir.service\n"}, ["units/weir.service"]),
        ({**UNITS, **INSTALLS, "a.sh": "# cp units/weir.service /etc\n"}, ["units/weir.service"]),
        (UNITS, []),
        ({f"etc/systemd/system/{Path(name).name}": text for name, text in UNITS.items()} | INSTALLS, []),
        ({**UNITS, **INSTALLS, "units/weir.conf.in": UNIT % "weir"}, ["units/weir.service"]),
        ({**UNITS, **INSTALLS, "README.md": "Then install weir.service by hand.\n"}, []),
        ({**UNITS, **INSTALLS, "a.sh": "systemctl enable weir\n"}, []),
        ({**UNITS, **INSTALLS, "a.py": "for name in ('weir',):\n    enable(f'{name}.service')\n"}, []),
        ({**UNITS, **INSTALLS, "a.py": "weir = 4\n"}, ["units/weir.service"]),
        ({**UNITS, **INSTALLS, "a.sh": "cp -r units /opt\n"}, []),
        ({**UNITS, **INSTALLS, "a.sh": "cp units/* /opt\n"}, []),
        ({**UNITS, **INSTALLS, "a.sh": "cp units/weir.* /etc/systemd/system\n"}, []),
        ({**UNITS, **INSTALLS, "a.sh": "case $1 in\n  *) cp units/weir.service /etc ;;\nesac\n"}, []),
        ({**UNITS, **INSTALLS, "a.sh": "for each in drive weir; do systemctl start $each; done\n"}, []),
        ({**UNITS, **INSTALLS, "a.sh": "SRC=/opt/units\ncp $SRC/*.service /etc/systemd/system\n"}, []),
        ({**UNITS, **INSTALLS, "README.md": "* `weir.service`: copy it by hand\n"}, []),
        ({**UNITS, **INSTALLS, "debian/rules": "a:\n\tdh_installsystemd --name=weir\n"}, []),
        (
            {**UNITS, **INSTALLS, "units/otter@.service": UNIT % "a", "a.sh": "cp units/weir.* .\n"},
            ["units/otter@.service"],
        ),
        (
            {
                **UNITS,
                **INSTALLS,
                "units/otter@.service": UNIT % "a",
                "a.sh": "cp units/weir.* .\nsystemctl enable otter@front\n",
            },
            [],
        ),
        ({**UNITS, **INSTALLS, "a.sh": "echo units of the robot\n"}, ["units/weir.service"]),
        ({**UNITS, **INSTALLS, "units/install.sh": "cp ./*.service /etc/systemd/system\n"}, []),
        (
            {**UNITS, **INSTALLS, "a.sh": "for each in *.service.m4; do\n  m4 $each > units/$each\ndone\n"},
            ["units/weir.service"],
        ),
        ({**UNITS, "install.sh": "cp units/drive.service /etc/systemd/system/\n"}, []),
        ({**UNITS, **INSTALLS, "units/notes.j2": UNIT % "a"}, ["units/weir.service"]),
        ({Path(name).name: text for name, text in {**UNITS, **INSTALLS}.items()}, ["weir.service"]),
        ({**ROLES, "ansible/site.yml": PLAY % "drive"}, [WEIR]),
        ({**ROLES, "ansible/site.yml": PLAY % "drive", "ansible/roles/drive/files/a.sh": SCRIPT}, [WEIR]),
        ({**ROLES, "ansible/site.yml": PLAY % "weir"}, ["ansible/roles/drive/tasks/main.yml"]),
        ({**ROLES, "ansible/site.yml": PLAY % '"{{ chosen }}"'}, []),
        ({**ROLES, "ansible/site.yml": PLAY % "drive", "a.sh": "sh ansible/roles/weir/files/a.sh\n"}, []),
        (
            {
                **ROLES,
                "ansible/site.yml": PLAY % "drive",
                "ansible/roles/drive/meta/main.yml": "dependencies:\n  - role: weir\n",
            },
            [],
        ),
        ({**ROLES, "ansible/site.yml": "- hosts: all\n  roles:\n    - drive\n"}, []),
        ({**ROLES, "ansible/site.yml": PLAY % "drive", "a.sh": "ansible all -m include_role -a name=weir\n"}, []),
        ({**ROLES, "ansible/site.yml": PLAY % "drive", "a.yml": "- hosts: all\n  roles:\n    - otter.gate.weir\n"}, []),
        ({**SCRIPTS, "docker/Dockerfile": IMAGE}, ["docker/scripts/install-c.sh"]),
        ({**SCRIPTS, "docker/Dockerfile": IMAGE, "README.md": "Run install-c.sh for a camera.\n"}, []),
        ({**SCRIPTS, "docker/Dockerfile": "FROM ros:humble\nCOPY scripts /opt\n"}, []),
        ({**SCRIPTS, "docker/scripts/Dockerfile": IMAGE}, []),
        (COPIED, ["src/Dockerfile", "src/compose.yaml"]),
        ({**COPIED, "README.md": "docker compose -f src/compose.yaml up\n"}, []),
        ({**COPIED, "a.service": "[Service]\nWorkingDirectory=/opt/otter/src\nExecStart=docker compose up\n"}, []),
        ({**COPIED, "README.md": "cd src && docker compose up\n"}, []),
        ({**COPIED, "Makefile": "up:\n\tmake -C src up\n"}, []),
        ({**COPIED, "src/run.sh": "docker compose up\n"}, []),
        ({**COPIED, "install.sh": "install src/* /opt/otter\n"}, []),
        ({**COPIED, "install.sh": "cd src/tools\n"}, ["src/Dockerfile", "src/compose.yaml"]),
        ({**COPIED, "src/src/a.py": ""}, []),
        ({**COPIED, "compose.yaml": STACK.replace("drive", "weir")}, []),
        ({**COPIED, "build.sh": "docker build -t drive src\n"}, ["src/compose.yaml"]),
        (BUILT, ["docker/Dockerfile.weir"]),
        ({**BUILT, "a.sh": "docker build -f docker/Dockerfile.weir .\n"}, []),
        ({**BUILT, "README.md": "docker build -f docker/Dockerfile.weir .\n"}, []),
        ({**BUILT, "a.sh": "docker build -f docker/Dockerfile.$1 .\n"}, []),
        ({**BUILT, "docker/Dockerfile": "FROM ros:foxy\n"}, ["docker/Dockerfile", "docker/Dockerfile.weir"]),
        (
            {**BUILT, "docker/Dockerfile": "FROM ros:foxy\n", "README.md": "docker build docker\n"},
            ["docker/Dockerfile.weir"],
        ),
        (
            {
                "Dockerfile": "FROM ros:foxy\n",
                "b.Dockerfile": "FROM ros:humble\n",
                "compose.yaml": "services:\n  a: {build: {dockerfile: b.Dockerfile}}\n",
            },
            [],
        ),
        (PAGES, ["Documentation/Operation/bashrc"]),
        ({**PAGES, "a.sh": "cp Documentation/Operation/bashrc ~/.bashrc\n"}, []),
        ({**PAGES, "bashrc": "export ROS_LOCALHOST_ONLY=1\n"}, []),
        ({"docs/bashrc": "export ROS_DOMAIN_ID=5\n"}, []),
        (
            {"legacy/drive.service": UNIT % "a", "a.sh": "exit\n", "README.md": "See legacy/drive.service.\n"},
            ["legacy/drive.service"],
        ),
        ({"legacy/drive.service": UNIT % "a", "install.sh": "cp legacy/drive.service /etc/systemd/system\n"}, []),
        ({"1.0.0/drive.service": UNIT % "a", "3.0.0/drive.service": UNIT % "a"}, ["1.0.0/drive.service"]),
    ],
)
def test_what_is_set_aside(tmp_path: Path, files: dict[str, str], expected: list[str]) -> None:
    assert set_aside(tmp_path, files) == expected


def test_what_is_found_there_is_information(tmp_path: Path) -> None:
    robot_of(tmp_path, {**UNITS, **INSTALLS, "units/weir.service": "[Service]\nExecStart=weir\nRestart=sometimes\n"})
    arguments = ("--select", "systemd/invalid-value", "--output-format", "concise", ".")
    assert "info[systemd/invalid-value]" in lint(*arguments, cwd=tmp_path).stdout
    (tmp_path / "bringup-lint.toml").write_text('[purpose]\n"units" = "robot"\n')
    assert "info[systemd/invalid-value]" not in lint(*arguments, cwd=tmp_path).stdout


def test_a_tree_of_very_many_files_is_not_looked_through(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("bringup_lint.graph.set_aside._MOST", 3)
    assert set_aside(tmp_path, {**UNITS, **INSTALLS}) == []


def test_an_archive_that_the_run_is_for_is_judged(tmp_path: Path) -> None:
    robot_of(tmp_path, {"old/drive.service": UNIT % "drive", "new/drive.service": UNIT % "drive"})
    for asked, expected in ((tmp_path, False), (tmp_path / "old", True)):
        robot = Robot(discover([str(asked)]))
        found = next(each for each in robot.sources if each.absolute.endswith("old/drive.service"))
        assert robot.leads_to(found) is expected


def test_a_text_beside_no_file_is_judged() -> None:
    robot = Robot(Tree(sources=[Source("drive.service", UNIT % "drive", kind="systemd-unit")]))
    assert robot.leads_to(robot.sources[0])
