"""Copies of what others wrote: what the own files of a robot lead to, and what not."""

from __future__ import annotations

from pathlib import Path

import pytest

from bringup_lint.discover.walk import discover
from bringup_lint.graph.copies import Copies
from bringup_lint.robot import Robot
from tests.lint import lint

MANIFEST = """\
<package format="3">
  <name>{name}</name>
  <maintainer email="{mail}">{person}</maintainer>
  {more}
  <buildtool_depend>ament_cmake</buildtool_depend>
</package>
"""
OURS = ("Ada Marsh", "ada@otter.org")
THEIRS = ("Bo Reed", "bo@reed.net")


def manifest(name: str, who: tuple[str, str] = OURS, more: str = "") -> str:
    return MANIFEST.format(name=name, person=who[0], mail=who[1], more=more)


def tree(folder: Path, files: dict[str, str]) -> Robot:
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return Robot(discover([str(folder)]))


def copies(folder: Path, files: dict[str, str]) -> list[str]:
    """The names of the packages that are copies."""
    return sorted(str(each.name) for each in Copies(tree(folder, files).files).found.values())


def unreached(folder: Path, files: dict[str, str]) -> list[str]:
    """The files to which nothing leads."""
    robot = tree(folder, files)
    return sorted(
        Path(source.absolute).relative_to(folder).as_posix() for source in robot.sources if not robot.leads_to(source)
    )


OWN = {f"src/{name}/package.xml": manifest(name) for name in ("otter_base", "otter_arm")}
URL = '<url type="repository">https://github.com/reed/{}.git</url>'


@pytest.mark.parametrize(
    ("files", "expected"),
    [
        ({"src/weir/package.xml": manifest("weir", THEIRS)}, []),
        ({"src/weir/package.xml": manifest("weir", THEIRS), "src/weir/CHANGELOG.rst": ""}, ["weir"]),
        ({"src/weir/package.xml": manifest("weir"), "src/weir/CHANGELOG.rst": ""}, []),
        ({"src/weir/package.xml": manifest("weir", ("bo", "pi@todo.todo")), "src/weir/CHANGELOG.rst": ""}, []),
        ({"src/otter_io/package.xml": manifest("otter_io", THEIRS), "src/otter_io/CHANGELOG.rst": ""}, []),
        ({"src/third_party/weir/package.xml": manifest("weir", THEIRS)}, ["weir"]),
        ({"src/rplidar_ros/package.xml": manifest("rplidar_ros", ("pi", "pi@todo.todo"))}, ["rplidar_ros"]),
        ({"src/weir/package.xml": manifest("weir", THEIRS, URL.format("weir-ros2"))}, ["weir"]),
        ({"src/weir/package.xml": manifest("weir", THEIRS, URL.format("otter"))}, []),
        ({"src/weir/package.xml": manifest("weir", THEIRS, "<url>https://reed.net/weir</url>")}, []),
        ({"src/weir/package.xml": manifest("weir", ("Cy Fen", "cy@otter.org")), "src/weir/.gitrepo": ""}, []),
        ({"src/weir/package.xml": manifest("weir", THEIRS), "src/weir/.gitrepo": ""}, ["weir"]),
        (
            {"src/w/a/package.xml": manifest("weir", THEIRS), "src/w/LICENSE": "", "src/w/README.md": ""},
            ["weir"],
        ),
        (
            {
                "src/lib/w/a/package.xml": manifest("weir", THEIRS),
                "src/lib/w/b/package.xml": manifest("flume", ("pi", "pi@todo.todo")),
                "src/lib/b/package.xml": manifest("sluice", ("pi", "pi@todo.todo")),
                "src/lib/w/.gitrepo": "",
            },
            ["flume", "weir"],
        ),
        ({"src/weir/package.xml": manifest("weir", THEIRS), "src/weir/LICENSE": "", "src/weir/README.md": ""}, []),
    ],
)
def test_what_shows_that_others_wrote_a_package(tmp_path: Path, files: dict[str, str], expected: list[str]) -> None:
    assert copies(tmp_path, {**OWN, **files}) == expected


def test_a_repository_is_the_home_of_what_is_all_of_one_kind(tmp_path: Path) -> None:
    files = {f"{name}/package.xml": manifest(name, THEIRS) for name in ("joy", "spacenav")}
    assert copies(tmp_path, files) == []
    assert copies(tmp_path, {"joy/CHANGELOG.rst": "", "third_party/x/package.xml": manifest("x")}) == ["x"]


def test_packages_that_all_have_a_mark_are_at_home(tmp_path: Path) -> None:
    files = {f"{folder}/package.xml": manifest(folder[-1], THEIRS) for folder in ("lib/a", "deps/b")}
    assert copies(tmp_path, files) == []


def test_a_folder_that_holds_own_packages_is_no_name_of_a_copy(tmp_path: Path) -> None:
    script = "#!/bin/sh\nsudo cp reeds/scan.rules /etc/udev/rules.d\n"
    files = {"src/reeds/weir/package.xml": manifest("weir", THEIRS), "src/reeds/weir/CHANGELOG.rst": "", **OWN}
    files |= {"src/reeds/otter_cam/package.xml": manifest("otter_cam"), "src/reeds/weir/scan.rules": RULES}
    assert unreached(tmp_path, {**files, "setup.sh": script}) == ["src/reeds/weir/scan.rules"]


LAUNCH = (
    "from launch import LaunchDescription\n\n\ndef generate_launch_description():\n    return LaunchDescription([])\n"
)
RULES = 'KERNEL=="ttyUSB*", MODE="0666", SYMLINK+="weir scan"\n'
WEIR = {
    "src/third_party/weir/package.xml": manifest("weir", THEIRS, "<exec_depend>flume</exec_depend>"),
    "src/third_party/weir/CMakeLists.txt": "install(DIRECTORY launch DESTINATION share/weir)\n",
    "src/third_party/weir/README.md": "Run ros2 launch weir view.launch.py of weir.\n",
    "src/third_party/weir/launch/weir.launch.py": LAUNCH,
    "src/third_party/weir/launch/view.launch.py": LAUNCH + "# weir.launch.py\n",
    "src/third_party/weir/udev/99-weir.rules": RULES,
    "src/third_party/weir/src/weir.cpp": "#include <rclcpp/rclcpp.hpp>\nint main() { rclcpp::spin(nullptr); }\n",
    "src/third_party/flume/package.xml": manifest("flume", THEIRS),
    "src/third_party/flume/src/flume.cpp": "#include <rclcpp/rclcpp.hpp>\nint main() { rclcpp::spin(nullptr); }\n",
}
NODES = {"third_party/weir/src/weir.cpp", "third_party/flume/src/flume.cpp"}
FILES = {"launch/weir.launch.py", "launch/view.launch.py", "udev/99-weir.rules"}


@pytest.mark.parametrize(
    ("text", "left"),
    [
        ("", {*FILES, "src/weir.cpp", "flume"}),
        ("weir", FILES),
        ("weir.launch.py", {*FILES, "src/weir.cpp", "flume"}),
        ("ros2 launch weir weir.launch.py", FILES - {"launch/weir.launch.py"}),
        ("ros2 launch weir view.launch.py", {"udev/99-weir.rules"}),
        ("cp src/third_party/weir/udev/*.rules /etc", FILES - {"udev/99-weir.rules"}),
        ("weir {model}.launch.py", {"udev/99-weir.rules"}),
        ("weir view_ view_x", FILES),
        ("weir /dev/scan", FILES - {"udev/99-weir.rules"}),
        ("weir 99-", FILES),
        ("weir 99-we", FILES),
    ],
)
def test_what_own_files_lead_to(tmp_path: Path, text: str, left: set[str]) -> None:
    expected = {
        "src/third_party/flume/src/flume.cpp" if each == "flume" else f"src/third_party/weir/{each}" for each in left
    }
    assert set(unreached(tmp_path, {**OWN, **WEIR, "README.md": text})) == expected
    (tmp_path / "README.md").write_text("")
    script = {"start.sh": f"#!/bin/bash\n: {text}\n"}
    assert set(unreached(tmp_path, script)) == expected


def test_a_repository_of_others_names_its_own_files_in_vain(tmp_path: Path) -> None:
    files = {**OWN, **WEIR, "src/third_party/weir/demo/show.sh": "#!/bin/bash\nros2 launch weir view.launch.py\n"}
    beside = {
        "src/third_party/more/a/package.xml": manifest("a", THEIRS),
        "src/third_party/more/tools/run.sh": "#!/bin/sh\nweir\n",
    }
    assert "src/third_party/weir/launch/view.launch.py" in unreached(tmp_path, {**files, **beside})


def test_what_nothing_leads_to_is_information(tmp_path: Path) -> None:
    tree(tmp_path, {**OWN, **WEIR})
    arguments = ("--select", "udev/mode-world-writable", "--output-format", "concise", ".")
    assert "info[udev/mode-world-writable]" in lint(*arguments, cwd=tmp_path).stdout
    (tmp_path / "bringup-lint.toml").write_text('[purpose]\n"src/third_party/weir" = "robot"\n')
    assert "warning[udev/mode-world-writable]" in lint(*arguments, cwd=tmp_path).stdout


def test_a_secret_is_one_wherever_it_lies(tmp_path: Path) -> None:
    robot = "services:\n  arm:\n    image: otter/arm:1\n    environment:\n      DB_PASSWORD: Xq7-plover-Trout\n"
    tree(tmp_path, {"old/compose.yaml": robot})
    assert "error[secrets/plain-secret]" in lint("--output-format", "concise", ".", cwd=tmp_path).stdout
