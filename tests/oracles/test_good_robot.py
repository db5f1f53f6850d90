"""What the real programs say about the good robot: its files load, and nobody has a word to say."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.conftest import PROJECT
from tests.oracles import cyclonedds_library
from tests.oracles import fastdds_library
from tests.oracles import udevadm
from tests.oracles.sshd_server import SSHD
from tests.oracles.sshd_server import sshd
from tests.oracles.sshd_server import sshd_folder
from tests.oracles.verify import systemd_version

TREE = PROJECT / "fixtures" / "robots" / "good" / "tree"
DISTRIBUTION = ("sysinit", "basic", "shutdown", "multi-user", "network-online", "time-sync")
"""Targets that the installed distribution brings."""
PROGRAMS = ("usr/bin/bash", "usr/lib/systemd/systemd-networkd-wait-online")

needs_systemd = pytest.mark.skipif(systemd_version() < 250, reason="needs systemd-analyze of 250 or newer")


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
    environment = {"LANG": "C.UTF-8", "PATH": "/usr/bin:/bin"}
    return subprocess.run(command, capture_output=True, text=True, check=False, env=environment)


@needs_systemd
def test_every_unit_is_accepted(root: Path) -> None:
    files = (path for path in (TREE / "etc/systemd/system").glob("*.*") if path.is_file())
    units = sorted(path.name.replace("@", "@tern-drivers") for path in files)
    run = verify(root, *units)
    assert run.stderr == ""
    assert run.returncode == 0


@needs_systemd
def test_verify_would_complain(root: Path) -> None:
    unit = root / "etc/systemd/system/tern-drivers.service"
    unit.write_text(unit.read_text().replace("/usr/local/bin/tern-wait-devices", "/usr/local/bin/lost"))
    assert "lost" in verify(root, unit.name).stderr


def needs(program: str) -> pytest.MarkDecorator:
    return pytest.mark.skipif(shutil.which(program) is None, reason=f"needs {program}")


needs_root = pytest.mark.skipif(os.geteuid() != 0, reason="needs root")


def run(*command: str | Path, **environment: str) -> tuple[int, str]:
    """Exit status and output of a program."""
    done = subprocess.run(
        command,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        check=False,
        timeout=60,
        env=os.environ | environment,
    )
    return done.returncode, done.stdout


@needs("netplan")
def test_netplan_generates(tmp_path: Path) -> None:
    shutil.copytree(TREE / "etc/netplan", tmp_path / "etc/netplan")
    for path in (tmp_path / "etc/netplan").iterdir():
        path.chmod(0o600)
    assert run("netplan", "generate", "--root-dir", tmp_path) == (0, "")
    assert (tmp_path / "run/systemd/network/10-netplan-enp3s0.network").exists()


@pytest.mark.skipif(udevadm.udevadm() is None, reason="needs udevadm of systemd 254 or newer")
def test_udev_rules_verify() -> None:
    assert udevadm.verify((TREE / "etc/udev/rules.d").iterdir()) == {}


@needs("logrotate")
@needs_root
def test_logrotate_reads_it(tmp_path: Path) -> None:
    stanza = shutil.copy(TREE / "etc/logrotate.d/tern", tmp_path / "tern")
    Path(stanza).chmod(0o644)
    os.chown(stanza, 0, 0)
    status, output = run("logrotate", "-d", "-s", tmp_path / "state", stanza)
    assert status == 0
    assert "error" not in output


@needs("ssh-keygen")
@pytest.mark.skipif(SSHD is None, reason="needs sshd")
def test_sshd_reads_it() -> None:
    text = (TREE / "etc/ssh/sshd_config").read_text("utf-8")
    with sshd_folder() as folder:
        tested = sshd(folder, text, "-t")
        assert (tested.returncode, tested.stdout + tested.stderr) == (0, "")
        assert "\nkbdinteractiveauthentication no\n" in sshd(folder, text, "-T").stdout


@pytest.mark.skipif(not cyclonedds_library.is_installed(), reason="needs cyclonedds")
def test_cyclonedds_starts(tmp_path: Path) -> None:
    good = TREE / "etc/tern/cyclonedds.xml"
    damaged = tmp_path / "damaged.xml"
    damaged.write_text(good.read_text("utf-8").replace("MaxAutoParticipantIndex", "MaxAutoIndex"), "utf-8")
    start = "from cyclonedds.domain import DomainParticipant; DomainParticipant(18); print('started')"
    assert run(sys.executable, "-c", start, CYCLONEDDS_URI=f"file://{good}") == (0, "started\n")
    assert run(sys.executable, "-c", start, CYCLONEDDS_URI=f"file://{damaged}")[0] != 0


@pytest.mark.skipif(fastdds_library.library() is None, reason="needs ros-jazzy-rclpy[fastrtps]")
def test_fastdds_starts(tmp_path: Path) -> None:
    good = shutil.copy(TREE / "etc/tern/fastdds.xml", tmp_path / "fastdds.xml")
    damaged = tmp_path / "damaged.xml"
    damaged.write_text(Path(good).read_text("utf-8").replace("userTransports", "ownTransports"), "utf-8")
    status, output = fastdds_library.start_node(Path(good))
    assert (status, output.strip()) == (0, "started")
    assert "Error" in fastdds_library.start_node(damaged)[1]
