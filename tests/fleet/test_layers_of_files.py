"""Archives and overlays: read in memory, nothing extracted, nothing followed out of them."""

from __future__ import annotations

import errno
import io
import json
import os
import tarfile
from pathlib import Path

import pytest

from bringup_lint.discover.layered import archive_entries
from bringup_lint.fleet import state
from tests.conftest import PROJECT
from tests.fleet.test_fleet import judged
from tests.fleet.test_fleet import write
from tests.lint import lint

KEYS = PROJECT / "fixtures/fleet/same_ssh_host_key/bad/robots"
UNIT = "[Unit]\nAfter=network.target\n\n[Service]\nExecStart=/opt/ros/jazzy/bin/ros2 launch rover up.launch.py\n"


def member(archive: tarfile.TarFile, name: str, text: str = "", **attributes: object) -> None:
    info = tarfile.TarInfo(name)
    info.size = len(text)
    for key, value in attributes.items():
        setattr(info, key, value)
    archive.addfile(info, io.BytesIO(text.encode()))


def test_an_archive_is_judged_as_its_folder_is(tmp_path: Path) -> None:
    for name in ("alpha", "beta"):
        write(tmp_path, {f"{name}/etc/systemd/system/rover.service": UNIT})
        key = (KEYS / name / "etc/ssh/ssh_host_ed25519_key.pub").read_text("utf-8")
        write(tmp_path, {f"{name}/etc/ssh/ssh_host_ed25519_key.pub": key})
        with tarfile.open(tmp_path / f"{name}.tar.gz", "w:gz") as archive:
            archive.add(tmp_path / name, arcname=".")
    folders = judged("alpha", "beta", cwd=tmp_path)
    archives = judged("alpha.tar.gz", "beta.tar.gz", cwd=tmp_path)
    assert [found["rule"] for found in archives["findings"]] == ["fleet/same-ssh-host-key"]
    for one, other in zip(folders["robots"], archives["robots"]):
        rules = [found["rule"] for found in one["findings"]]
        assert rules
        assert rules == [found["rule"] for found in other["findings"]]
        assert {found["path"].partition("/")[0] for found in other["findings"]} == {f"{one['name']}.tar.gz"}
    places = [place["path"] for found in archives["findings"] for place in found["places"]]
    assert places == [f"{name}.tar.gz/etc/ssh/ssh_host_ed25519_key.pub" for name in ("alpha", "beta")]
    assert sorted(path.name for path in tmp_path.iterdir()) == ["alpha", "alpha.tar.gz", "beta", "beta.tar.gz"]


def test_templates_of_an_archive_are_read_as_in_a_folder(tmp_path: Path) -> None:
    for name in ("alpha", "beta"):
        text = "[Service]\nExecStart={{ command }}\n{% if slow %}\nRestartSec=20\n{% endif %}\n"
        write(tmp_path, {f"{name}/etc/systemd/system/rover.service": text})
        with tarfile.open(tmp_path / f"{name}.tar", "w") as archive:
            archive.add(tmp_path / name, arcname=".")
    folders, archives = judged("alpha", "beta", cwd=tmp_path), judged("alpha.tar", "beta.tar", cwd=tmp_path)
    for one, other in zip(folders["robots"], archives["robots"]):
        assert [each["message"] for each in one["findings"]] == [each["message"] for each in other["findings"]]


def test_an_overlay_counts_in_place_of_the_image(tmp_path: Path) -> None:
    write(
        tmp_path,
        {
            "image/etc/machine-id": "0" * 32 + "\n",
            "image/etc/hostname": "rover\n",
            "one/etc/machine-id": "1" * 32 + "\n",
            "two/etc/machine-id": "2" * 32 + "\n",
            "fleet.toml": "".join(
                f'[[robot]]\nname = "{name}"\nroot = "image"\noverlays = ["{name}"]\n' for name in ("one", "two")
            ),
        },
    )
    assert [found["rule"] for found in judged(".", cwd=tmp_path)["findings"]] == ["fleet/same-host-name"]


def test_no_link_leads_out_of_an_archive(tmp_path: Path) -> None:
    (tmp_path / "secret").write_text("0" * 32, "utf-8")
    for name in ("alpha", "beta"):
        with tarfile.open(tmp_path / f"{name}.tar", "w") as archive:
            member(archive, "etc/machine-id", type=tarfile.SYMTYPE, linkname=str(tmp_path / "secret"))
            member(archive, "etc/hostname", type=tarfile.SYMTYPE, linkname="../../secret")
            member(archive, "../etc/passwd", "robot:x:0:0::/:\n")
            member(archive, "etc/fifo", type=tarfile.FIFOTYPE)
    assert judged("alpha.tar", "beta.tar", cwd=tmp_path)["findings"] == []
    assert sorted(archive_entries(str(tmp_path / "alpha.tar"))) == ["etc/hostname", "etc/machine-id"]


def test_a_damaged_archive_costs_that_robot(tmp_path: Path) -> None:
    write(tmp_path, {"bad.tar": "no archive", "good/etc/hostname": "good\n"})
    run = lint("fleet", "--workers", "1", "--output-format", "json", "bad.tar", "good", cwd=tmp_path)
    bad, good = json.loads(run.stdout)["robots"]
    assert run.code == 3
    assert "not a tar archive" in bad["failures"][0]
    assert good["failures"] == []


def test_a_run_goes_on_where_the_last_one_stopped(tmp_path: Path) -> None:
    write(tmp_path, {"alpha/etc/machine-id": "0" * 32, "beta/etc/machine-id": "0" * 32})
    first = judged("--state", "state", "alpha", cwd=tmp_path)
    kept = {path.name: path.stat().st_mtime_ns for path in (tmp_path / "state").iterdir()}
    second = judged("--state", "state", "alpha", "beta", cwd=tmp_path)
    assert first["findings"] == []
    assert [found["robots"] for found in second["findings"]] == [["alpha", "beta"]]
    assert kept.items() <= {path.name: path.stat().st_mtime_ns for path in (tmp_path / "state").iterdir()}.items()
    assert (tmp_path / "state").stat().st_mode & 0o077 == 0
    write(tmp_path, {"beta/etc/machine-id": "1" * 32})
    assert judged("--state", "state", "alpha", "beta", cwd=tmp_path)["findings"] == []


def test_a_run_in_another_folder_names_files_from_there(tmp_path: Path) -> None:
    write(tmp_path, {"fleet/alpha/etc/machine-id": "0" * 32, "fleet/beta/etc/machine-id": "0" * 32})
    judged("--state", "state", "fleet/alpha", "fleet/beta", cwd=tmp_path)
    found = judged("--state", "../state", "alpha", "beta", cwd=tmp_path / "fleet")["findings"]
    assert [place["path"] for place in found[0]["places"]] == ["alpha/etc/machine-id", "beta/etc/machine-id"]


RULE = '''"""Every unit.

## What it finds
{what}

## Why it matters on a robot
It does.

## Bad
```ini
[Unit]
```

## Good
```ini
[Service]
```

## When to ignore it
Never.

## References
- systemd.unit(5)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("warning")
def every(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.judged:
        yield finding(unit.where, "{what}")
'''


def test_a_rule_that_changed_is_asked_again(tmp_path: Path) -> None:
    write(tmp_path, {"alpha/etc/systemd/system/rover.service": UNIT})
    for what in ("First", "Second"):
        write(tmp_path, {"mine/site/every.py": RULE.format(what=what)})
        robot = judged("--state", "state", "--rules", "mine", "--select", "site", "alpha", cwd=tmp_path)["robots"][0]
        assert [found["message"] for found in robot["findings"]] == [what]


def test_a_state_that_takes_nothing_more_costs_no_result(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    write(tmp_path, {"alpha/etc/machine-id": "0" * 32, "beta/etc/machine-id": "0" * 32})
    written = state._write

    def full(path: Path, data: bytes) -> None:
        if path.suffix == ".json":
            raise OSError(errno.ENOSPC, "No space left on device")
        written(path, data)

    monkeypatch.setattr(state, "_write", full)
    options = ("--workers", "1", "--state", "state", "--output-format", "concise")
    run = lint("fleet", *options, "alpha", "beta", cwd=tmp_path)
    assert run.code == 1
    assert "error[fleet/same-machine-id]" in run.stdout
    assert run.stderr == "bringup-lint: state: nothing more is kept for another run: No space left on device\n"


@pytest.mark.parametrize(
    "text", ["", "[1]", "3", '{"version": 1}', '{"version": 2}', '{"version": 2, "name": 3, "own": [[1]]}']
)
def test_a_damaged_summary_is_made_anew(tmp_path: Path, text: str) -> None:
    write(tmp_path, {"alpha/etc/machine-id": "0" * 32, "beta/etc/machine-id": "0" * 32})
    first = judged("--state", "state", "alpha", "beta", cwd=tmp_path)
    for path in (tmp_path / "state").glob("*.json"):
        path.write_text(text)
    assert judged("--state", "state", "alpha", "beta", cwd=tmp_path) == first


def test_a_device_is_no_robot(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.tar")
    write(tmp_path, {"fleet.toml": '[[robot]]\nname = "a"\nroot = "pipe.tar"\n'})
    for path in ("fleet.toml", "pipe.tar"):
        run = lint("fleet", path, cwd=tmp_path)
        assert (run.code, "pipe.tar' is neither a folder nor an archive" in run.stderr) == (2, True)
