"""Which devices the user of a service may not open."""

from __future__ import annotations

from pathlib import Path

import pytest

from bringup_lint.discover.walk import discover
from bringup_lint.robot import Robot

FILES = {
    "etc/os-release": "ID=ubuntu\nVERSION_ID=24.04\n",
    "etc/passwd": "root:x:0:0::/root:/bin/bash\nheron:x:1000:1000::/home/heron:/bin/bash\n",
    "etc/group": "root:x:0:\nheron:x:1000:\ndialout:x:20:other\n",
    "usr/bin/.keep": "",
    "etc/udev/rules.d/99-lidar.rules": 'SUBSYSTEM=="tty", ATTRS{idVendor}=="10c4", SYMLINK+="lidar"\n',
}
UNIT = "[Service]\nUser=heron\n{more}ExecStart=/usr/bin/lidar /dev/lidar\n"


def closed(folder: Path, more: str) -> list[tuple[str, str]]:
    for name, text in {**FILES, "etc/systemd/system/lidar.service": UNIT.format(more=more)}.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    robot = Robot(discover(["/"], root=str(folder)))
    return [(each.use.path, each.group) for each in robot.closed_devices]


@pytest.mark.parametrize("more", ["", "DynamicUser=no\n", "SupplementaryGroups=video\n"])
def test_the_group_of_the_device_is_missing(tmp_path: Path, more: str) -> None:
    assert closed(tmp_path, more) == [("/dev/lidar", "dialout")]


@pytest.mark.parametrize("more", ["DynamicUser=yes\n", "SupplementaryGroups=dialout\n", "Group=dialout\n"])
def test_the_device_may_be_opened_or_nobody_tells(tmp_path: Path, more: str) -> None:
    assert closed(tmp_path, more) == []
