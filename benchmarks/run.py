"""Benchmarks against peers in one run, as ratios of medians: ``python benchmarks/run.py [GROUP]...``.

The groups are start, trees, again, growth and shapes. Needs yamllint. ``etc`` and ``repo`` are generated robots;
BRINGUP_LINT_BENCH_ETC and BRINGUP_LINT_BENCH_REPO name folders of real files to take in their place. Nothing fails when
an aim is missed, which follows each line.
"""

from __future__ import annotations

import os
import shutil
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

import robot
import shapes
from timing import Command
from timing import medians
from timing import usage

PROJECT = Path(__file__).parent.parent
OURS = (sys.executable, "-m", "bringup_lint")
FLOOR = (sys.executable, str(Path(__file__).parent / "floor.py"))
PLAIN = """\
[Unit]
Description=Camera server
After=network.target

[Service]
ExecStart=/usr/bin/camera-server
Restart=on-failure

[Install]
WantedBy=multi-user.target
"""
YAML = "network:\n  version: 2\n  ethernets:\n    enp3s0:\n      dhcp4: true\n"
START = {
    "--version": (("--version",), "0.25"),
    "one plain unit": (("plain/camera.service",), "1.0"),
    "one ROS unit": (("ros/robot.service",), "1.2"),
    "rules": (("rules",), "0.8"),
    "explain RULE": (("explain", "systemd/root-user"), "0.8"),
}
AIMS = {"etc": "8", "repo": "6"}
AGAIN = "0.4"
NO_CACHE = "BRINGUP_LINT_NO_CACHE"
SHAPE_LIMIT = 60
"""CPU seconds after which a run over a hostile shape is killed."""


def start_up(folder: Path) -> None:
    """How long the smallest tasks take, compared with yamllint on one file."""
    shapes.write(folder / "plain/camera.service", PLAIN)
    shapes.write(folder / "ros/robot.service", robot.UNIT.format(n=1, previous=0))
    shapes.write(folder / "net.yaml", YAML)
    yamllint = shutil.which("yamllint", path=f"{Path(sys.executable).parent}:{os.environ['PATH']}") or "yamllint"
    commands = {name: Command((*OURS, *words), folder) for name, (words, _) in START.items()}
    taken = medians({"yamllint": Command((yamllint, "net.yaml"), folder), **commands}, 9)
    for name, (_, aim) in START.items():
        _print(name, taken[name].seconds, taken["yamllint"].seconds, f"yamllint   aim ≤ {aim}")


def trees(folder: Path) -> None:
    """Whole trees, compared with the floor."""
    for name, aim in AIMS.items():
        real = os.environ.get(f"BRINGUP_LINT_BENCH_{name.upper()}")
        top = Path(real) if real else robot.generate(folder / name, 50 if name == "etc" else 150)
        commands = {"ours": Command((*OURS, "."), top), "floor": Command((*FLOOR, "."), top)}
        taken = medians(commands, 3)
        memory = f"{taken['ours'].mebibytes:.0f} MiB"
        _print(name, taken["ours"].seconds, taken["floor"].seconds, f"floor   aim ≤ {aim}, {memory}")


def again(folder: Path) -> None:
    """Whole trees once more, when nothing has changed, when times count and when content does."""
    os.environ["XDG_CACHE_HOME"] = str(folder / "cache")
    del os.environ[NO_CACHE]
    for name in AIMS:
        real = os.environ.get(f"BRINGUP_LINT_BENCH_{name.upper()}")
        top = Path(real) if real else robot.generate(folder / f"{name}-again", 50 if name == "etc" else 150)
        commands = {by: Command((*OURS, "--cache-by", by, "."), top) for by in ("times", "content")}
        taken = medians({**commands, "floor": Command((*FLOOR, "."), top)}, 9)
        for by in commands:
            _print(f"{name} again, {by}", taken[by].seconds, taken["floor"].seconds, f"floor   aim ≤ {AGAIN}")
    os.environ[NO_CACHE] = "1"


def growth(folder: Path) -> None:
    """One robot with three and ten times as many files."""
    tops = {times: robot.generate(folder / f"grown{times}", 40 * times) for times in (1, 3, 10)}
    taken = medians({str(times): Command((*OURS, "."), top) for times, top in tops.items()}, 3)
    for times in (3, 10):
        memory = f"{taken[str(times)].mebibytes:.0f} MiB"
        aim = f"aim ≤ {times * 1.05:.1f}, {memory}"
        _print(f"growth x{times}", taken[str(times)].seconds, taken["1"].seconds, f"x1   {aim}")


def hostile(folder: Path) -> None:
    """Each hostile shape at its size: at most 20 times the floor, and 10 seconds."""
    for name in shapes.SHAPES:
        top = folder / "shape"
        top.mkdir()
        shapes.generate(top, name)
        ours = usage(Command((*OURS, "."), top), SHAPE_LIMIT)
        floor = usage(Command((*FLOOR, "."), top))
        killed = ", killed" if ours.killed else ""
        _print(name, ours.seconds, floor.seconds, f"floor   aim ≤ 20 and 10 s, {ours.mebibytes:.0f} MiB{killed}")
        shutil.rmtree(top)


def _print(name: str, ours: float, theirs: float, unit: str) -> None:
    print(f"{name:<20} {ours:7.3f} s / {theirs:7.3f} s = {ours / theirs:6.2f} x {unit}", flush=True)


GROUPS: dict[str, Callable[[Path], None]] = {
    "start": start_up,
    "trees": trees,
    "again": again,
    "growth": growth,
    "shapes": hostile,
}


def main(names: list[str]) -> None:
    os.environ["PYTHONPATH"] = str(PROJECT)
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
    os.environ[NO_CACHE] = "1"
    with tempfile.TemporaryDirectory() as name:
        for group in names or GROUPS:
            GROUPS[group](Path(name))


if __name__ == "__main__":
    main(sys.argv[1:])
