"""The plan of the package: each layer may import only what is below it, and no files import each other in a circle.

Every import counts: inside functions, and for type checkers only.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.architecture.imports import PACKAGE
from tests.architecture.imports import circles
from tests.architecture.imports import import_graph
from tests.architecture.imports import name_of
from tests.architecture.imports import paths
from tests.architecture.imports import uses_of_robot

LAYERS = (
    {"__main__"},
    {"cli"},
    {"finish"},
    {"engine"},
    {"fix", "baseline", "suppress", "config", "registry"},
    {"report", "live"},
    {"api"},
    {"robot"},
    {"graph.edges", "graph.observed", "graph.secrets"},
    {"graph.sros2"},
    {"graph.topics", "graph.supervision"},
    {"graph.nodes", "graph.host"},
    {"graph.provenance"},
    {"graph.dds", "graph.params"},
    {"graph.environment"},
    {"graph.runners"},
    {"graph.systemd", "graph.launch"},
    {"graph.workspace", "graph.compose", "graph.netplan", "graph.udev", "graph.commands"},
    {"graph.files", "graph.file_nodes", "graph.places", "graph.layers"},
    {"graph.graph", "graph.target", "graph.variants", "graph.yaml_edits"},
    {"discover"},
    {"parsers"},
    {"schema"},
    {"model", "finding", "facts"},
    {"source", "spelling", "templates", "toml"},
    {""},
)
"""From the top down. The layers of one line do not import each other; ``""`` is the version of the package."""
LEVEL = {name: level for level, names in enumerate(LAYERS) for name in names}
TAKES_A_ROBOT = """
    graph.dds.dds
    graph.dds.machines
    graph.dds.network
    graph.nodes.modules
    graph.nodes.nodes
    graph.nodes.programs
    graph.secrets.in_clear
    graph.secrets.programs
    graph.secrets.ros
    graph.sros2.enclaves
    graph.sros2.policed
    graph.sros2.secured
    graph.sros2.shared
    graph.sros2.sros2
    graph.sros2.ungranted
    graph.supervision.launched_by_unit
    graph.supervision.notify
    graph.supervision.watchdog
    graph.systemd.capabilities
    graph.systemd.companions
    graph.systemd.daemons
    graph.systemd.distribution
    graph.systemd.environment
    graph.systemd.filesystem
    graph.systemd.limits
    graph.systemd.main_process
    graph.systemd.manager
    graph.systemd.named_units
    graph.systemd.restart
    graph.systemd.sandbox
    graph.systemd.supervision
    graph.systemd.unit_loading
    graph.systemd.units
    graph.systemd.waits
    graph.topics.code
    graph.topics.commands
    graph.topics.cpp_code
    graph.topics.given
    graph.topics.launched
    graph.topics.node_names
    graph.topics.rviz
    graph.topics.systems
    graph.topics.topics
    graph.topics.watched
""".split()
"""What still has to be given its layers one by one; nothing may be added."""
CIRCLES = (
    "graph.environment.images graph.environment.ros",
    "graph.params.matching graph.params.params graph.params.time",
    "graph.systemd.boot graph.systemd.companions graph.systemd.cycles graph.systemd.dependencies"
    " graph.systemd.distribution graph.systemd.implicit graph.systemd.named_units graph.systemd.units",
    "graph.topics.code graph.topics.cpp_code",
    "graph.topics.node_names graph.topics.topics graph.topics.watched",
    "report.frame report.rows",
)
"""What still has to be taken apart; nothing may be added."""


def layer_of(module: str) -> str:
    """The longest name of a layer that the module lies in."""
    parts = module.split(".")
    names = (".".join(parts[:count]) for count in range(len(parts), 0, -1))
    return next((name for name in names if name in LEVEL), "")


@pytest.mark.parametrize("path", paths(), ids=lambda path: str(path.relative_to(PACKAGE)))
def test_imports_point_down(path: Path) -> None:
    module = name_of(path)
    own = layer_of(module)
    assert own or module in ("", "graph"), f"{module} is in no layer"
    for other in import_graph()[module]:
        if other == "robot" and module in TAKES_A_ROBOT:
            continue
        theirs = layer_of(other)
        assert theirs == own or LEVEL[theirs] > LEVEL[own], f"{own} may not import {other}"


def test_no_circle_of_files() -> None:
    graph = dict(import_graph())
    for module in TAKES_A_ROBOT:
        graph[module] = graph[module] - {"robot"}
    assert {tuple(sorted(members)) for members in circles(graph)} == {tuple(members.split()) for members in CIRCLES}


def test_only_the_top_knows_the_robot() -> None:
    """A module of the graph says what it asks: files, or single layers."""
    below = [path for path in paths() if LEVEL[layer_of(name_of(path))] > LEVEL["robot"]]
    assert {name_of(path) for path in below if any(uses_of_robot(path))} == set(TAKES_A_ROBOT)
