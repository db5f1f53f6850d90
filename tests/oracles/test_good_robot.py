"""The good robot loads in the real systemd: ``systemd-analyze verify --root`` has nothing to say about its units."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

from tests.conftest import PROJECT
from tests.oracles.verify import systemd_version

TREE = PROJECT / "fixtures" / "robots" / "good" / "tree"
DISTRIBUTION = ("sysinit", "basic", "shutdown", "multi-user", "network-online", "time-sync")
"""Targets that the installed distribution brings."""
PROGRAMS = ("usr/bin/bash", "usr/lib/systemd/systemd-networkd-wait-online")

pytestmark = pytest.mark.skipif(systemd_version() < 250, reason="systemd-analyze of 250 or newer is not installed")


@pytest.fixture
def root(tmp_path: Path) -> Path:
    """The robot's own files together with what its distribution would add."""
    root = tmp_path / "root"
    shutil.copytree(TREE, root, symlinks=True)
    vendor = root / "usr" / "lib" / "systemd" / "system"
    vendor.mkdir(parents=True)
    for name in DISTRIBUTION:
        (vendor / f"{name}.target").write_text("[Unit]\nDefaultDependencies=no\n")
    for name in PROGRAMS:
        program = root / name
        program.parent.mkdir(parents=True, exist_ok=True)
        program.write_text("#!/bin/sh\n")
        program.chmod(0o755)
    (root / "bin").symlink_to("usr/bin")
    (root / "lib").symlink_to("usr/lib")
    return root


def verify(root: Path, *units: str) -> subprocess.CompletedProcess[str]:
    command = ["systemd-analyze", "verify", "--man=no", "--recursive-errors=yes", f"--root={root}", *units]
    return subprocess.run(command, capture_output=True, text=True, env={"LANG": "C.UTF-8", "PATH": "/usr/bin:/bin"})


def test_every_unit_is_accepted(root: Path) -> None:
    units = sorted(path.name.replace("@", "@tern-drivers") for path in (TREE / "etc/systemd/system").glob("*.*") if path.is_file())
    run = verify(root, *units)
    assert run.stderr == ""
    assert run.returncode == 0


def test_verify_would_complain(root: Path) -> None:
    unit = root / "etc/systemd/system/tern-drivers.service"
    unit.write_text(unit.read_text().replace("ExecStartPre=/usr/local/bin/tern-wait-devices", "ExecStartPre=/usr/local/bin/lost"))
    assert "lost" in verify(root, unit.name).stderr
