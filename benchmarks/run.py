"""Benchmarks against peers in one run, as ratios of medians: ``python benchmarks/run.py``.

Needs yamllint; systemd-analyze and systemdlint are compared when they are there, and the units of real repositories
when BRINGUP_LINT_CORPUS names a folder of them. Aims stand behind each line; nothing fails when an aim is missed.
"""

from __future__ import annotations

import os
import shutil
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

from timing import Comparison
from timing import compare
from timing import seconds

PROJECT = Path(__file__).parent.parent
OURS = (sys.executable, "-m", "bringup_lint")
BIN = Path(sys.executable).parent

UNIT = """\
[Unit]
Description=Drivers of the robot
Wants=network-online.target
After=network-online.target

[Service]
User=robot
EnvironmentFile=/etc/robot/ros.env
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch robot_bringup drivers.launch.py'
Restart=always
RestartSec=1
KillSignal=SIGINT

[Install]
WantedBy=multi-user.target
"""
YAML = "network:\n  version: 2\n  ethernets:\n    enp3s0:\n      dhcp4: true\n"


def installed(script: str) -> tuple[str, ...] | None:
    path = BIN / script if (BIN / script).exists() else shutil.which(script)
    return (str(path),) if path else None


def start_up(folder: Path) -> Iterator[tuple[str, Comparison, str]]:
    (folder / "robot.service").write_text(UNIT)
    (folder / "net.yaml").write_text(YAML)
    console = installed("bringup-lint") or OURS
    yamllint = installed("yamllint")
    if yamllint:
        yield (
            "--version / yamllint --version",
            compare((*console, "--version"), (*yamllint, "--version"), folder),
            "0.8",
        )
        yield (
            "one unit / yamllint on one file",
            compare((*console, "robot.service"), (*yamllint, "net.yaml"), folder),
            "1",
        )
    systemdlint = installed("systemdlint")
    if systemdlint:
        ours = (*console, "robot.service")
        yield "one unit / systemdlint", compare(ours, (*systemdlint, "robot.service"), folder), "1"


def corpus_units(corpus: Path, folder: Path) -> Iterator[tuple[str, Comparison, str]]:
    units = folder / "units"
    units.mkdir()
    for path in sorted((corpus / "systemd__systemd-stable/units").glob("*")):
        if path.suffix in (".service", ".target", ".socket", ".timer", ".mount", ".path", ".slice"):
            shutil.copy(path, units)
    names = [f"./{path.name}" for path in sorted(units.iterdir())]
    if shutil.which("systemd-analyze") and names:
        verify = ("systemd-analyze", "verify", "--man=no", *names)
        label = f"{len(names)} units of systemd / one call of systemd-analyze verify"
        yield label, compare((*OURS, "."), verify, units, 5), "6"
        each = sum(seconds(("systemd-analyze", "verify", "--man=no", name), units) for name in names)
        yield "the same / one call of it for each file", Comparison(seconds((*OURS, "."), units), each), "1"


def growth(folder: Path) -> Iterator[tuple[str, Comparison, str]]:
    for count in (200, 2000):
        many = folder / f"many{count}"
        many.mkdir()
        for number in range(count):
            (many / f"robot-{number}.service").write_text(UNIT)
    ours = compare((*OURS, folder / "many2000"), (*OURS, folder / "many200"), folder, 3)
    yield "2000 units / 200 units", ours, "10"


def main() -> None:
    os.environ["PYTHONPATH"] = str(PROJECT)
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
    corpus = os.environ.get("BRINGUP_LINT_CORPUS")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        lines = [start_up(folder), growth(folder)]
        if corpus:
            lines.insert(1, corpus_units(Path(corpus), folder))
        for group in lines:
            for label, result, aim in group:
                print(f"{label:<62} {result.ours:7.3f} s / {result.theirs:7.3f} s = {result.ratio:6.2f}   aim ≤ {aim}")


if __name__ == "__main__":
    main()
