"""Where a file goes that is installed to a path: the path itself, or below it."""

from __future__ import annotations

import pytest

from bringup_lint.graph.installed.paths import destination


@pytest.mark.parametrize(
    ("path", "name", "place"),
    [
        ("/usr/local/lib/robot", "start.sh", "/usr/local/lib/robot/start.sh"),
        ("/usr/local/bin/start", "start", "/usr/local/bin/start"),
        ("/etc/robot/ros.env", "ros.env.example", "/etc/robot/ros.env"),
        ("/etc/udev/rules.d", "99-robot.rules", "/etc/udev/rules.d/99-robot.rules"),
        ("/opt/robot/", "start", "/opt/robot/start"),
    ],
)
def test_place_of_an_installed_file(path: str, name: str, place: str) -> None:
    assert destination(path, name, several=False) == place


def test_several_files_go_into_a_folder() -> None:
    assert destination("/opt/robot", "start", several=True) == "/opt/robot/start"
