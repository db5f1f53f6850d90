"""What waits for what at boot: the answers, and that many questions take no more than the units do."""

from __future__ import annotations

import random
from pathlib import Path

import networkx
import pytest

from bringup_lint.graph.graph import Node
from bringup_lint.graph.systemd.reachability import Reachability
from bringup_lint.graph.systemd.units import Units
from tests.graph.systemd.test_dependencies import service
from tests.graph.systemd.test_units import load
from tests.scenarios.test_growth import SIZES
from tests.scenarios.test_growth import counted
from tests.scenarios.test_growth import excess

UNITS = 60
"""Of the smallest tree."""


@pytest.mark.parametrize("seed", range(30))
def test_nodes_lead_where_a_path_is(seed: int) -> None:
    chance = random.Random(seed)
    graph = networkx.gnp_random_graph(12, chance.choice([0.05, 0.1, 0.2]), seed=seed, directed=True)
    found = Reachability([Node("unit", str(node)) for node in graph], lambda node: _after(graph, node))
    for start in graph:
        for goal in graph:
            there = start != goal and networkx.has_path(graph, start, goal)
            assert found.leads({Node("unit", str(start))}, Node("unit", str(goal))) == there


def _after(graph: networkx.DiGraph, node: Node) -> list[Node]:
    return [Node("unit", str(other)) for other in graph.successors(int(node.name))]


SHAPES = {
    "each before the next": "Before=r{next}.service\nAfter=network.target",
    "each after the next": "Requires=r{next}.service\nAfter=r{next}.service",
    "each before the next, which it requires": "Before=r{next}.service\nRequires=r{next}.service",
    "all after one": "After=network.target\nWants=network.target",
}


@pytest.mark.slow
@pytest.mark.parametrize("lines", SHAPES.values(), ids=SHAPES)
@pytest.mark.parametrize("last", ["After=network-online.target", "Requires=r0.service"])
def test_questions_of_all_units_grow_as_the_units_do(
    lines: str, last: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    calls = []
    for size in SIZES:
        count = UNITS * size
        files = {f"r{n}.service": service(lines.format(next=n + 1), "WantedBy=multi-user.target") for n in range(count)}
        files[f"r{count}.service"] = service(last)
        folder = tmp_path / str(size)
        folder.mkdir()
        units = load(folder, files, monkeypatch)
        calls.append(counted(lambda units=units: ask(units))["graph/systemd"])  # type: ignore[misc]
    assert excess(*calls) <= 1.3


def ask(units: Units) -> None:
    for number, unit in enumerate(units.services):
        units.waits_for(unit, "network-online.target")
        units.waits_for(unit, "docker.service")
        units.brings_in(unit, f"r{number + 1}.service")
        units.brings_in(unit, f"r{number - 1}.service")
        units.brought_in(unit, f"r{number + 1}.service")
        units.ordered(unit, f"r{number + 1}.service")
        units.ordered(unit, "docker.service")
