"""What the tree says of the robot's system."""

from __future__ import annotations

import pytest

from bringup_lint.graph.target import find_target
from bringup_lint.source import Source


@pytest.mark.parametrize(
    ("name", "version", "systemd"), [("ubuntu", "22.04", 249), ("ubuntu", "24.04", 255), ("debian", "12", 252)]
)
def test_systemd_of_the_system_in_the_tree(name: str, version: str, systemd: int) -> None:
    release = Source("etc/os-release", f'PRETTY_NAME="Robot"\nID={name}\nVERSION_ID="{version}"\n', kind="os-release")
    target = find_target([Source("a.service", "", kind="systemd-unit"), release], None, None)
    assert (target.systemd, target.systemd_known) == (systemd, True)
    assert target.systemd_why == "the systemd of Robot"
