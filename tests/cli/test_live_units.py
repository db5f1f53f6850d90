"""The units of the robot in ``live``: a systemctl of our own answers, which nothing but the path tells apart."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from bringup_lint.live import systemd
from bringup_lint.live.text import graph_text
from bringup_lint.parsers.observed import parse
from bringup_lint.source import Source

ANSWER = """Id=a.service
LoadState=loaded
ActiveState=failed
Result=exit-code
NeedDaemonReload=yes
FragmentPath=/etc/systemd/system/a.service

Id=b.service
LoadState=not-found
ActiveState=inactive
Result=success
NeedDaemonReload=no
FragmentPath=
"""
SEEN = {"domain": 0, "rmw": "rmw_fastrtps_cpp", "nodes": [], "endpoints": [], "states": {}}


@pytest.fixture
def systemctl(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The arguments of the last call go to ``asked``."""
    program = tmp_path / "systemctl"
    program.write_text(f"#!/bin/sh\nprintf '%s\\n' \"$@\" > {tmp_path}/asked\ncat <<'END'\n{ANSWER}END\n")
    program.chmod(0o755)
    monkeypatch.setenv("PATH", f"{tmp_path}:/usr/bin:/bin")
    monkeypatch.setattr(systemd, "RUNNING", str(tmp_path))
    return tmp_path


def test_only_units_that_systemd_knows(systemctl: Path) -> None:
    (unit,) = systemd.units(["b.service", "a.service", "a.service"])
    assert unit["unit"] == "a.service"
    assert (systemctl / "asked").read_text().splitlines()[-3:] == ["--", "a.service", "b.service"]


def test_instances_are_asked_for_where_the_tree_has_a_template(systemctl: Path) -> None:
    systemd.units(["lidar@.service", "lidar@front.service"])
    assert (systemctl / "asked").read_text().splitlines()[-2:] == ["lidar@*.service", "lidar@front.service"]


def test_it_only_asks(systemctl: Path) -> None:
    systemd.units(["a.service"])
    assert (systemctl / "asked").read_text().splitlines()[0] == "show"


def test_what_is_written_is_read(systemctl: Path) -> None:
    text = graph_text(SEEN, [], "", False, systemd.units(["a.service"]))
    (unit,) = parse(Source("graph.yaml", text)).units
    assert [str(value) for value in unit] == [
        *("a.service", "loaded", "failed", "exit-code", "yes", "/etc/systemd/system/a.service"),
    ]


def test_no_systemd_no_units(systemctl: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert systemd.units([]) == []
    (systemctl / "systemctl").write_text("#!/bin/sh\nsleep 30\n")
    monkeypatch.setattr(systemd, "PATIENCE", 0.1)
    assert systemd.units(["a.service"]) == []
    monkeypatch.setattr(systemd, "RUNNING", str(systemctl / "nothing"))
    assert systemd.units(["a.service"]) == []
    monkeypatch.setattr(shutil, "which", lambda name: None)
    assert systemd.units(["a.service"]) == []
