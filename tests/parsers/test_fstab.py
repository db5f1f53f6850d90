"""fstab: fields, escapes, and what libmount says to the same lines."""

import shutil
import subprocess

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bringup_lint.model.fstab import Fstab
from bringup_lint.parsers.fstab import parse
from bringup_lint.source import Source

LINES = [
    "/dev/sda1 /data",
    "/dev/sda1 /data ext4",
    "/dev/sda1 /data ext4 defaults",
    "/dev/sda1 /data ext4 defaults 0 2",
    "/dev/sda1 /data ext4 defaults 0 2 # maps",
    "/dev/sda1 /data ext4 defaults # maps",
    "/dev/sda1 /my maps ext4 defaults 0 2",
    "/dev/sda1 /data ext4 defaults x",
    "/dev/sda1 /data ext4 defaults 0 2 7",
    "UUID=1-2 /my\\040maps ext4 ro,nofail 0 2",
    "tmpfs /tmp tmpfs size=64M",
]


def read(text: str) -> Fstab:
    return parse(Source("etc/fstab", text, kind="fstab"))


def test_fields_and_escapes():
    (mount,) = read("# comment\n\n  UUID=1-2\t/my\\040maps ext4 rw,ro,size=1M 0 2 # maps\n").mounts
    assert (mount.device, mount.target, mount.type, mount.passno) == ("UUID=1-2", "/my maps", "ext4", "2")
    assert mount.is_read_only and mount.is_block and mount.option("size") == "1M"
    assert mount.target.span.text == "/my\\040maps"


def test_the_mount_of_a_path():
    fstab = read("a / ext4 defaults 0 1\ntmpfs /var/log tmpfs size=1M 0 0\n")
    assert fstab.mount_of("/var/log/ros2").is_tmpfs
    assert fstab.mount_of("/var/logs").target == "/"


@pytest.mark.skipif(shutil.which("findmnt") is None, reason="needs findmnt")
@pytest.mark.parametrize("line", LINES)
def test_libmount_refuses_the_same_lines(line, tmp_path):
    file = tmp_path / "fstab"
    file.write_text(line + "\n")
    command = ["findmnt", "--tab-file", str(file), "-n", "-o", "TARGET"]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    (mount,) = read(line).mounts
    ours = len(mount.fields) < 3 or any(not field.isdecimal() for field in mount.fields[4:6])
    assert ("parse error" in run.stderr) == ours


@given(st.text(alphabet="/da =,#\\0471\n\t", max_size=60))
def test_no_text_raises_and_every_span_lies_inside(text):
    for mount in read(text).mounts:
        for field in (*mount.fields, *mount.options):
            assert 0 <= field.span.start <= field.span.end <= len(text)
        assert mount.is_read_only in (True, False)
