"""Who the processes of a unit run as."""

from __future__ import annotations

from pathlib import Path

import pytest

from bringup_lint.graph.systemd.identity import Home
from bringup_lint.graph.systemd.identity import HomeOrigin
from bringup_lint.graph.systemd.units import Units
from tests.graph.systemd.test_units import load
from tests.graph.systemd.test_units import only

SERVICE = "[Service]\nExecStart=/bin/true\n"


@pytest.mark.parametrize(
    ("lines", "name", "is_root"),
    [
        ("", "root", True),
        ("User=root\n", "root", True),
        ("User=0\n", "0", True),
        ("User=%u\n", "root", True),
        ("User=%U\n", "0", True),
        ("User=rover\nUser=\n", "root", True),
        ("User=rover\n", "rover", False),
        ("User=1000\n", "1000", False),
        ("User=%p\n", "a", False),
        ("User=%h\n", None, None),
        ("User={{ user }}\n", None, None),
        ("DynamicUser=yes\n", None, False),
        ("DynamicUser=1\nUser=drive\n", "drive", False),
        ("DynamicUser=no\n", "root", True),
        ("DynamicUser=yes\nDynamicUser=off\n", "root", True),
        ("DynamicUser=perhaps\n", "root", True),
        ("DynamicUser={{ dynamic }}\n", "root", None),
    ],
)
def test_the_user_of_a_service(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, lines: str, name: str | None, is_root: bool | None
) -> None:
    units = load(tmp_path, {"a.service": SERVICE + lines}, monkeypatch)
    identity = only(units, "a.service").identity
    assert (identity.name, identity.is_root) == (name, is_root)


def test_an_instance_names_its_user_and_a_template_does_not(tmp_path, monkeypatch):
    files = {"a@rover.service": SERVICE + "User=%i\n", "b@.service": SERVICE + "User=%i\n"}
    units = load(tmp_path, files, monkeypatch)
    assert only(units, "a@rover.service").identity.name == "rover"
    assert only(units, "b@.service").identity.is_root is None


def test_a_dropin_alone_says_who_the_user_is_only_when_it_names_one(tmp_path, monkeypatch):
    files = {
        "ssh.service.d/user.conf": "[Service]\nUser=rover\n",
        "cron.service.d/nice.conf": "[Service]\nNice=5\n",
    }
    units = load(tmp_path, files, monkeypatch)
    assert only(units, "ssh.service").identity.is_root is False
    assert only(units, "cron.service").identity.is_root is None


def test_a_user_manager_runs_nothing_as_root(tmp_path, monkeypatch):
    units = load(tmp_path, {"etc/systemd/user/a.service": SERVICE + "User=root\n"}, monkeypatch, root=True)
    identity = only(units, "a.service", "user").identity
    assert (identity.name, identity.is_root, identity.home(units.users)) == (None, False, None)


def robot_with_users(folder: Path, monkeypatch: pytest.MonkeyPatch, lines: str) -> Units:
    files = {
        "etc/systemd/system/a.service": SERVICE + lines,
        "etc/passwd": "root:x:0:0::/root:/bin/sh\nrover:x:1000:1000::/srv/rover/:/bin/sh\nd:x:990:990::/nonexistent:\n",
        "etc/group": "rover:x:1000:\ndialout:x:20:rover,pilot\nvideo:x:44:d\n",
    }
    return load(folder, files, monkeypatch, root=True)


@pytest.mark.parametrize(
    ("lines", "home"),
    [
        ("User=rover\n", Home("/srv/rover", HomeOrigin.PASSWD)),
        ("User=1000\n", Home("/srv/rover", HomeOrigin.PASSWD)),
        ("User=d\n", Home(None, HomeOrigin.PASSWD)),
        ("User=pilot\n", Home("/home/pilot", HomeOrigin.CONVENTION)),
        ("User=4711\n", None),
        ("User=0\n", Home("/root", HomeOrigin.ROOT)),
        ("DynamicUser=yes\n", Home(None, HomeOrigin.DYNAMIC)),
    ],
)
def test_the_home_of_the_user(tmp_path, monkeypatch, lines, home):
    units = robot_with_users(tmp_path, monkeypatch, lines)
    assert only(units, "a.service").identity.home(units.users) == home


def test_groups_are_those_of_the_unit_and_of_the_user(tmp_path, monkeypatch):
    units = robot_with_users(tmp_path, monkeypatch, "User=1000\nSupplementaryGroups=video audio\n")
    groups = only(units, "a.service").identity.groups(units.users)
    assert groups == {"rover", "dialout", "video", "audio"}
