"""Answers from what the tree alone states are those of the whole graph."""

from __future__ import annotations

import random
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace

import pytest

from bringup_lint import facts
from bringup_lint.graph.components import in_order
from bringup_lint.graph.graph import Graph
from bringup_lint.graph.systemd.boot import Boot
from bringup_lint.graph.systemd.cycles import ordering_cycles
from bringup_lint.graph.systemd.dependencies import stated_graph
from bringup_lint.graph.systemd.distribution import RELEASES
from bringup_lint.graph.systemd.distribution import distribution_edges
from bringup_lint.graph.systemd.forward import all_go_forward
from bringup_lint.graph.systemd.implicit import after_members
from bringup_lint.graph.systemd.units import Units
from tests.graph.systemd.test_units import load

TABLE = Path(facts.__file__).parent / "systemd/boot_order.tsv"
HEADER = """\
# An order in which the units of units.tsv can start: no unit waits for one with a greater step.
# Source: computed from unit_edges.tsv over all its releases together, with implicit orders
# (tests/graph/systemd/test_forward.py). Units with the same step wait for each other there.
"""
KEYS = ("After", "After", "Before", "Wants", "Requires", "PartOf")
SHIPPED = ("multi-user.target", "graphical.target", "network.target", "network-online.target", "local-fs.target")
OWN = ("a.service", "b.service", "c.service", "d@.service", "own.target", "e.timer")
REPLACED = ("NetworkManager.service", "network-online.target", "chrony.service.d/own.conf")


def test_the_table_holds_an_order_of_the_distributions_units(update_expected: bool) -> None:
    expected = HEADER + "unit\tstep\n" + "".join(f"{unit}\t{step}\n" for unit, step in boot_order())
    if update_expected:
        TABLE.write_text(expected)
    assert TABLE.read_text() == expected


def boot_order() -> Iterator[tuple[str, int]]:
    """Early where possible: what the tree has in its boot comes after nearly all that it can name."""
    earlier: dict[str, set[str]] = {}
    for release in RELEASES:
        for edge in distribution_graph(release).edges("orders"):
            earlier.setdefault(edge.target.name, set()).add(edge.source.name)
            earlier.setdefault(edge.source.name, set())
    least: dict[str, int] = {}
    components = list(in_order(sorted(earlier), lambda name: sorted(earlier[name])))
    for component in components:
        before = (least.get(other, 0) for name in component for other in earlier[name])
        least.update(dict.fromkeys(component, 1 + max(before, default=0)))
    components.sort(key=lambda component: (max(map(least.__getitem__, component)), min(component)))
    return ((name, step) for step, component in enumerate(components, 1) for name in sorted(component))


def distribution_graph(release: int) -> Graph:
    graph = Graph()
    graph.add(distribution_edges([], release))
    graph.add(list(after_members(graph, SimpleNamespace(all=[], has_vendor_units=False))))  # type: ignore[arg-type]
    return graph


def random_units(seed: int) -> dict[str, str]:
    """Some units of the tree that name each other and the distribution's, of which some replace one of these."""
    pick = random.Random(seed)
    names = [*pick.sample(OWN, pick.randint(1, 4)), *(pick.sample(REPLACED, 1) if pick.random() < 0.2 else [])]
    others = [*(name.replace("@", "@1") for name in OWN), *SHIPPED, *SHIPPED, "NetworkManager.service"]
    files = {}
    for name in names:
        lines = ["[Unit]", *(f"{pick.choice(KEYS)}={pick.choice(others)}" for _ in range(pick.randint(0, 2)))]
        if pick.random() < 0.1:
            lines.append("DefaultDependencies=no")
        if name.endswith(".service"):
            lines += ["[Service]", "ExecStart=/bin/true"]
        if pick.random() < 0.6:
            lines += ["[Install]", f"WantedBy={pick.choice([*SHIPPED, 'own.target'])}"]
        files[name] = "\n".join(lines) + "\n"
    return files


@pytest.mark.parametrize("first", [0, 1000])
def test_no_cycle_is_missed(first: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    answers = set()
    for units in loaded(range(first, first + 100), tmp_path, monkeypatch):
        cycles = list(ordering_cycles(units.graph, units.boot.components))
        assert units.cycles == cycles
        answers.add((all_go_forward(units.stated, units), bool(cycles)))
    assert answers == {(True, False), (False, False), (False, True)}


def test_a_unit_that_replaces_one_has_orders_of_its_own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """multi-user.target wants it, and the distribution's one says that it starts later."""
    files = {
        "systemd-update-utmp-runlevel.service": "[Unit]\nAfter=a.service\n[Service]\nExecStart=/bin/true\n",
        "a.service": "[Unit]\nAfter=graphical.target\n[Service]\nExecStart=/bin/true\n",
    }
    assert load(tmp_path, files, monkeypatch).cycles


def test_what_is_stated_answers_as_the_whole_graph(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    found = set()
    for units in loaded(range(50), tmp_path, monkeypatch):
        whole = Boot(units, Graph(), lambda units=units: units.graph)  # type: ignore[misc]
        for unit in units.all:
            for name in (*OWN, *SHIPPED):
                assert units.waits_for(unit, name) == whole.waits_for(unit, name)
                assert units.ordered(unit, name) == whole.ordered(unit, name)
                assert units.brings_in(unit, name) == whole.brings_in(unit, name)
                found.add((bool(units.waits_for(unit, name)), units.brings_in(unit, name)))
    assert len(found) == 4


def test_the_whole_graph_begins_with_what_is_stated(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    units = load(tmp_path, random_units(1), monkeypatch)
    for node, edges in stated_graph(units).into.items():
        assert units.graph.into[node][: len(edges)] == edges


def loaded(seeds: range, folder: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Units]:
    for seed in seeds:
        yield load(folder / str(seed), random_units(seed), monkeypatch)
