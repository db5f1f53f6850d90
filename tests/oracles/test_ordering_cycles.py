"""Ordering cycles against the real systemd: random unit graphs, with a cycle or without one."""

from __future__ import annotations

import os
import random
import subprocess
from pathlib import Path

import pytest

from bringup_lint.discover.walk import discover
from bringup_lint.graph.graph import Node
from bringup_lint.graph.systemd.relations import PULLING
from bringup_lint.robot import Robot
from tests.oracles.answers import Oracle
from tests.oracles.verify import systemd

KEYS = {"After": 0.8, "Before": 0.3, "Requires": 0.3, "Wants": 0.35, "BindsTo": 0.1, "PartOf": 0.1}
EARLY = ("multi-user.target", "graphical.target", "sysinit.target", "basic.target")


def random_units(seed: int) -> dict[str, str]:
    """Two to five services and up to two targets with random relations, all wanted by all.target."""
    pick = random.Random(seed)
    services = [f"u{number}.service" for number in range(pick.randint(2, 5))]
    names = services + [f"t{number}.target" for number in range(pick.randint(0, 2))]
    files = {}
    for name in names:
        lines = ["[Unit]", "Description=random"]
        for key, chance in KEYS.items():
            lines += [f"{key}={other}" for other in names if other != name and pick.random() < chance / len(names)]
        if pick.random() < 0.15:
            lines.append(f"{pick.choice(['After', 'Before'])}={pick.choice(EARLY)}")
        if pick.random() < 0.1:
            lines.append("DefaultDependencies=no")
        if name in services:
            lines += ["[Service]", "ExecStart=/bin/true"]
        files[name] = "\n".join(lines) + "\n"
    wanted = [name for name in names if pick.random() < 0.85]
    return {**files, "all.target": f"[Unit]\nDescription=all\nWants={' '.join(wanted)}\n"}


def written(folder: Path, files: dict[str, str]) -> Path:
    folder.mkdir(parents=True)
    for name, text in files.items():
        (folder / name).write_text(text)
    return folder


def systemd_finds_a_cycle(folder: Path) -> bool:
    run = subprocess.run(
        ["systemd-analyze", "verify", "--man=no", "./all.target"],
        cwd=folder,
        capture_output=True,
        text=True,
        env={**os.environ, "SYSTEMD_UNIT_PATH": f"{folder}:"},
    )
    return "ordering cycle" in run.stderr


def we_find_a_cycle(folder: Path, version: str) -> bool:
    units = Robot(discover([str(folder)]), configured_systemd=int(version)).units
    started = units.graph.reachable(Node("unit", "all.target"), PULLING)
    return any({edge.source for edge in cycle.edges} <= started for cycle in units.cycles)


@pytest.mark.parametrize("first", [0, 100, 200])
def test_cycles_of_random_graphs(answers: Oracle, tmp_path: Path, first: int) -> None:
    trials = [random_units(seed) for seed in range(first, first + 20)]

    def ask(trials: list[dict[str, str]]) -> list[bool]:
        folders = (written(tmp_path / "real" / str(number), files) for number, files in enumerate(trials))
        return [systemd_finds_a_cycle(folder) for folder in folders]

    given = answers.of(f"systemd/orders-{first}", systemd(), trials, ask)
    folders = [written(tmp_path / "ours" / str(number), files) for number, (files, _) in enumerate(given.pairs)]
    found = [we_find_a_cycle(folder, given.version) for folder in folders]
    assert found == [real for _, real in given.pairs]
    assert set(found) == {True, False}
