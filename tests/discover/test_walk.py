"""Which folders are entered."""

from __future__ import annotations

from pathlib import Path

import pytest

from bringup_lint.discover.walk import discover
from bringup_lint.discover.walk import walk


def write(folder: Path, *names: str) -> None:
    for name in names:
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("")


def walked(folder: Path) -> list[str]:
    return [str(Path(path).relative_to(folder)) for path in walk(str(folder))]


@pytest.mark.parametrize("marker", ["COLCON_IGNORE", "AMENT_IGNORE"])
def test_a_folder_that_colcon_leaves_out_is_not_entered(tmp_path: Path, marker: str) -> None:
    write(tmp_path, f"install/{marker}", "install/share/a.service", "src/robot/a.service", "src/robot/deep/b.service")
    assert walked(tmp_path) == ["src/robot/a.service", "src/robot/deep/b.service"]


@pytest.mark.parametrize("marker", ["COLCON_IGNORE", "AMENT_IGNORE"])
def test_a_folder_that_is_named_is_entered_all_the_same(tmp_path: Path, marker: str) -> None:
    """Who names a package that is not built asks for it: its own marker does not count, one further down does."""
    write(tmp_path, marker, "a.service", f"old/{marker}", "old/package.xml", "old/b.service")
    assert walked(tmp_path) == [marker, "a.service"]
    assert [Path(source.name).name for source in discover([str(tmp_path)]).sources] == ["a.service"]


@pytest.mark.parametrize("marker", ["COLCON_IGNORE", "AMENT_IGNORE"])
def test_what_is_deployed_from_a_folder_without_packages_is_read(tmp_path: Path, marker: str) -> None:
    """The marker only keeps colcon from looking for packages: images, units and playbooks there are used."""
    write(tmp_path, f"docker/{marker}", "docker/robot/b.service", "docker/build/a.service", "docker/ws/package.xml")
    write(tmp_path, "docker/robot/robot.launch.py", "docker/ws/c.service", "robot.launch.py")
    names = [Path(source.name).name for source in discover([str(tmp_path)]).sources]
    assert sorted(names) == ["a.service", "b.service", "robot.launch.py"]


@pytest.mark.parametrize("made", ["out/.built_by", "out/.colcon_install_layout", "out/latest_build", "log-old/a"])
def test_what_colcon_made_is_not_entered(tmp_path: Path, made: str) -> None:
    folder = made.partition("/")[0]
    write(tmp_path, made, f"{folder}/COLCON_IGNORE", f"{folder}/a.service")
    assert not discover([str(tmp_path)]).sources


def test_a_marker_counts_by_its_whole_name(tmp_path: Path) -> None:
    write(tmp_path, "src/COLCON_IGNORE.md", "src/a.service")
    assert "src/a.service" in walked(tmp_path)


def test_caches_and_version_control_are_not_entered(tmp_path: Path) -> None:
    write(tmp_path, ".git/a.service", "__pycache__/a.service", "node_modules/a.service", "a.service")
    assert walked(tmp_path) == ["a.service"]


def test_folders_too_deep_to_read_are_said(tmp_path: Path) -> None:
    deep = tmp_path.joinpath(*["d"] * 70)
    deep.mkdir(parents=True)
    (deep / "a.service").write_text("[Service]\n")
    tree = discover((str(tmp_path),))
    (problem,) = tree.problems
    assert (problem.code, problem.detail) == ("unreadable", "it is more than 60 folders deep")
    assert problem.span.path.endswith("/d")
