"""``init`` writes the settings that a tree needs, each with its evidence, and none without effect."""

from __future__ import annotations

import subprocess
from collections import Counter
from pathlib import Path

import pytest

from bringup_lint.config import read
from tests.lint import lint

UNIT = "[Unit]\nDescription=One\n[Service]\nExecStart=/bin/true\n"
WORKFLOW = "jobs:\n  test:\n    with:\n      required-ros-distributions: {}\n"
PACKAGE = """<package format="3"><name>otter_gazebo</name><exec_depend>ros_gz_bridge</exec_depend></package>\n"""


def tree(top: Path, files: dict[str, str]) -> Path:
    for name, text in files.items():
        (top / name).parent.mkdir(parents=True, exist_ok=True)
        (top / name).write_text(text)
    return top


def settings(top: Path) -> list[str]:
    """The lines of the configuration that are no comments, without what follows the value."""
    text = lint("init", "--print", cwd=top).stdout
    lines = [line.partition("  # ")[0] for line in text.splitlines()]
    return [line for line in lines if line and not line.startswith("#")]


def test_a_tree_that_needs_nothing(tmp_path: Path) -> None:
    run = lint("init", cwd=tmp_path)
    assert (run.code, run.stdout) == (0, "")
    assert run.stderr == "Wrote bringup-lint.toml: nothing in this tree calls for a setting.\n"
    assert settings(tmp_path) == []
    assert lint(cwd=tmp_path).code == 0


def test_a_file_is_left_alone(tmp_path: Path) -> None:
    (tmp_path / "bringup-lint.toml").write_text("exclude = []\n")
    assert lint("init", cwd=tmp_path) == (2, "", "bringup-lint: bringup-lint.toml: is there already\n")
    assert (tmp_path / "bringup-lint.toml").read_text() == "exclude = []\n"


@pytest.mark.parametrize(
    ("files", "expected"),
    [
        ({"Dockerfile": "FROM ros:humble\n"}, "humble"),
        ({".github/workflows/ci.yml": WORKFLOW.format("jazzy")}, "jazzy"),
        ({".github/workflows/ci.yml": WORKFLOW.format("jazzy"), "Dockerfile": "FROM ros:humble\n"}, "humble"),
    ],
)
def test_the_distribution_that_is_named(tmp_path: Path, files: dict[str, str], expected: str) -> None:
    assert settings(tree(tmp_path, files)) == [f'target-ros = "{expected}"']


@pytest.mark.parametrize(
    "files",
    [
        {"Dockerfile": "FROM ros:humble\n", "arm/Dockerfile": "FROM ros:jazzy\n"},
        {"Dockerfile": "FROM ros:humble\n", "test/Dockerfile": "FROM ros:jazzy\n"},
        {"Dockerfile": "FROM ros:foxy\n", "dev/Dockerfile": "FROM ros:humble\n", "docs/a.sh": "ls /opt/ros/humble\n"},
        {".github/workflows/ci.yml": WORKFLOW.format("foxy") + "    matrix:\n      - foxy\n      - humble\n"},
        {".gitlab-ci.yml": "image: ros:jazzy\n---\nimage: ros:humble\n"},
    ],
)
def test_two_distributions_say_nothing(tmp_path: Path, files: dict[str, str]) -> None:
    assert settings(tree(tmp_path, files)) == []


def test_what_is_not_the_robots_own_is_left_out(tmp_path: Path) -> None:
    files = ("third_party/one/a.service", "deep/fixtures/a.service", "made/a.service", "lib/driver/a.service")
    tree(tmp_path, {name: UNIT for name in files})
    tree(tmp_path, {".gitignore": "/made/\n", ".gitmodules": '[submodule "driver"]\n\tpath = lib/driver\n'})
    tree(tmp_path, {"vendor/notes.txt": "no file of a known kind"})
    subprocess.run(["git", "init", "-q"], cwd=tmp_path, check=True)
    subprocess.run(["git", "add", ".gitignore"], cwd=tmp_path, check=True)
    lint("init", cwd=tmp_path)
    assert read(str(tmp_path / "bringup-lint.toml")).exclude == (
        "/deep/fixtures/",
        "/lib/driver/",
        "/made/",
        "/third_party/",
    )
    assert "Nothing to check" in lint(cwd=tmp_path).stdout


def test_what_git_tracks_is_the_robots_own(tmp_path: Path) -> None:
    tree(tmp_path, {"deploy/a.service": UNIT, ".gitignore": "deploy/\n"})
    subprocess.run(["git", "init", "-q"], cwd=tmp_path, check=True)
    assert "exclude = [" not in settings(tmp_path)
    subprocess.run(["git", "add", "-f", "."], cwd=tmp_path, check=True)
    assert "exclude = [" not in settings(tmp_path)


def test_an_external_tree_of_buildroot_is_the_robots_own(tmp_path: Path) -> None:
    tree(tmp_path, {"os/external/external.desc": "name: OTTER\n", "os/external/package/a.service": UNIT})
    assert [line for line in settings(tmp_path) if "external/" in line and "deploy" not in line] == [
        '"os/external/package" = "/etc/systemd/system"'
    ]


def test_what_is_taken_away_is_said(tmp_path: Path) -> None:
    """A draft keeps what is wrong in itself; what it lacks for a robot is taken away."""
    wrong = "[Service]\nExecStart=/bin/true {0}\nRestart=some-{0}\n"
    unwatched = "[Service]\nExecStart=/opt/ros/jazzy/bin/ros2 launch {0} up.launch.py\n"
    for folder in ("vendor", "graveyard", "robot"):
        tree(
            tmp_path,
            {f"{folder}/{folder}{n}.service": text.format(folder) for n, text in enumerate((wrong, unwatched))},
        )
    before = found_in(tmp_path)
    run = lint("init", cwd=tmp_path)
    lost = before - found_in(tmp_path)
    assert lost == Counter({("vendor", "error"): 2, ("vendor", "warning"): 2, ("graveyard", "warning"): 2})
    lines = (tmp_path / "bringup-lint.toml").read_text().splitlines()
    taken = {line.split('"')[1]: line.partition("; takes away ")[2] for line in lines if "takes away" in line}
    assert taken == {"/vendor/": "2 errors and 2 warnings", "graveyard/": "2 warnings"}
    assert run.stderr.splitlines()[1:] == ["It takes away 2 errors and 4 warnings: the comments say where."]


def found_in(top: Path) -> Counter[tuple[str, str]]:
    """How many findings of each severity there are in each folder."""
    lines = lint("-q", "--output-format", "concise", cwd=top).stdout.splitlines()
    return Counter((line.split("/")[0], line.split(": ")[1].split("[")[0]) for line in lines)


def test_where_files_go_on_the_robot(tmp_path: Path) -> None:
    unit = UNIT + "EnvironmentFile=/etc/otter/ros.env\n"
    tree(tmp_path, {"deploy/units/a.service": unit, "deploy/units/a.service.d/b.conf": "[Service]\nUser=o\n"})
    tree(tmp_path, {"deploy/units/README.md": "text", "conf/ros.env": "A=1\n", "conf/other.yaml": "a: 1\n"})
    tree(tmp_path, {"udev/60-a.rules": 'KERNEL=="a", MODE="0660"\n', "more/60-a.rules": 'KERNEL=="a", MODE="0660"\n'})
    lint("init", cwd=tmp_path)
    assert read(str(tmp_path / "bringup-lint.toml")).deploy == {
        "deploy/units": "/etc/systemd/system",
        "conf/ros.env": "/etc/otter/ros.env",
    }


def test_an_overlay_needs_no_map(tmp_path: Path) -> None:
    assert settings(tree(tmp_path, {"board/etc/systemd/system/a.service": UNIT})) == []


def test_what_folders_are_for(tmp_path: Path) -> None:
    tree(tmp_path, {"sandbox/deep/scratch/a.service": UNIT, "test/scratch/a.service": UNIT})
    tree(tmp_path, {"otter_world/package.xml": PACKAGE, "otter_world/launch/w.launch.py": "import launch\n"})
    lint("init", cwd=tmp_path)
    config = read(str(tmp_path / "bringup-lint.toml"))
    assert config.purpose == {"otter_world/": "simulation", "sandbox/": "development"}
    assert config.deploy == {}


@pytest.mark.parametrize(
    "folder", ["ansible/roles/arm/templates", "ansible/roles/skeleton", "templates", "ansible/skeleton"]
)
def test_what_is_deployed_is_no_example(tmp_path: Path, folder: str) -> None:
    tree(tmp_path, {f"{folder}/a.service": UNIT, "ansible/site.yml": "- hosts: all\n  roles: [arm]\n"})
    assert "[purpose]" not in settings(tmp_path)


@pytest.mark.parametrize("folder", ["project_template", "templates_package", "cookiecutter-node", "skeleton"])
def test_a_template_of_a_project_is_an_example(tmp_path: Path, folder: str) -> None:
    tree(tmp_path, {f"{folder}/a.service": UNIT})
    assert f'"{folder}/" = "example"' in settings(tmp_path)


def test_names_of_files_stay_in_their_comment(tmp_path: Path) -> None:
    tree(tmp_path, {'vendor/a"\n[x]\n/a.service': UNIT, 'b"\n[y]/fixtures/a.service': UNIT})
    lint("init", cwd=tmp_path)
    assert read(str(tmp_path / "bringup-lint.toml")).exclude == ('/b"\n\\[y\\]/fixtures/', "/vendor/")


def test_names_that_toml_cannot_hold_as_they_are(tmp_path: Path) -> None:
    tree(tmp_path, {"vendor/x\x7f/a.service": UNIT, "x\x7fdel/fixtures/a.service": UNIT})
    undecodable = tmp_path / "bad\udcff" / "fixtures"
    undecodable.mkdir(parents=True)
    (undecodable / "a.service").write_text(UNIT)
    assert lint("init", cwd=tmp_path).code == 0
    assert read(str(tmp_path / "bringup-lint.toml")).exclude == ("/vendor/", "/x\x7fdel/fixtures/")
