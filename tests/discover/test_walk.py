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
    write(tmp_path, marker, "a.service", f"old/{marker}", "old/b.service")
    assert walked(tmp_path) == [marker, "a.service"]
    assert [Path(source.name).name for source in discover([str(tmp_path)]).sources] == ["a.service"]


def test_a_marker_counts_by_its_whole_name(tmp_path: Path) -> None:
    write(tmp_path, "src/COLCON_IGNORE.md", "src/a.service")
    assert "src/a.service" in walked(tmp_path)


def test_caches_and_version_control_are_not_entered(tmp_path: Path) -> None:
    write(tmp_path, ".git/a.service", "__pycache__/a.service", "node_modules/a.service", "a.service")
    assert walked(tmp_path) == ["a.service"]
