"""Ordering cycles against the real systemd: bred unit graphs, with a cycle or without one."""

from __future__ import annotations

import os
import random
import subprocess
from pathlib import Path

import pytest

from bringup_lint.discover.walk import discover
from bringup_lint.graph.graph import Node
from bringup_lint.graph.systemd.dependencies import PULLING
from bringup_lint.robot import Robot
from tests.oracles.verify import systemd_version

KEYS = {"After": 0.8, "Before": 0.3, "Requires": 0.3, "Wants": 0.35, "BindsTo": 0.1, "PartOf": 0.1}
EARLY = ("multi-user.target", "graphical.target", "sysinit.target", "basic.target")

pytestmark = pytest.mark.skipif(systemd_version() < 250, reason="needs systemd-analyze 250 or newer")


def breed(folder: Path, seed: int) -> None:
    """Two to five services and up to two targets with random relations, all wanted by all.target."""
    pick = random.Random(seed)
    services = [f"u{number}.service" for number in range(pick.randint(2, 5))]
    names = services + [f"t{number}.target" for number in range(pick.randint(0, 2))]
    for name in names:
        lines = ["[Unit]", "Description=bred"]
        for key, chance in KEYS.items():
            lines += [f"{key}={other}" for other in names if other != name and pick.random() < chance / len(names)]
        if pick.random() < 0.15:
            lines.append(f"{pick.choice(['After', 'Before'])}={pick.choice(EARLY)}")
        if pick.random() < 0.1:
            lines.append("DefaultDependencies=no")
        if name in services:
            lines += ["[Service]", "ExecStart=/bin/true"]
        (folder / name).write_text("\n".join(lines) + "\n")
    wanted = [name for name in names if pick.random() < 0.85]
    (folder / "all.target").write_text(f"[Unit]\nDescription=all\nWants={' '.join(wanted)}\n")


def systemd_finds_a_cycle(folder: Path) -> bool:
    run = subprocess.run(
        ["systemd-analyze", "verify", "--man=no", "./all.target"],
        cwd=folder,
        capture_output=True,
        text=True,
        env={**os.environ, "SYSTEMD_UNIT_PATH": f"{folder}:"},
    )
    return "ordering cycle" in run.stderr


@pytest.mark.parametrize("first", [0, 100, 200])
def test_cycles_of_bred_graphs(tmp_path, monkeypatch, first):
    found = {}
    for seed in range(first, first + 20):
        folder = tmp_path / str(seed)
        folder.mkdir()
        breed(folder, seed)
        monkeypatch.chdir(folder)
        units = Robot(discover(["."]), configured_systemd=systemd_version()).units
        started = units.graph.reachable(Node("unit", "all.target"), PULLING)
        own = any({edge.source for edge in cycle.edges} <= started for cycle in units.cycles)
        found[seed] = (own, systemd_finds_a_cycle(folder))
    assert {seed for seed, (own, real) in found.items() if own != real} == set()
    assert len({real for _, real in found.values()}) == 2
