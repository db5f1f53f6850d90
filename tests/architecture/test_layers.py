"""The plan of the package: each layer may import only what is below it, and no files import each other in a circle.

Every import counts: inside functions, and for type checkers only.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from tests.architecture.imports import circles
from tests.architecture.imports import import_graph
from tests.architecture.imports import name_of
from tests.architecture.imports import paths
from tests.architecture.imports import uses_of_robot
from tests.conftest import PROJECT

LAYERS = (
    {"__main__"},
    {"cli"},
    {"fleet", "server"},
    {"finish"},
    {"log_lines"},
    {"engine"},
    {"steps", "selection"},
    {"isolation"},
    {"fix", "baseline", "suppress", "config", "registry"},
    {"rule_index"},
    {"cache", "report", "live", "writing"},
    {"api"},
    {"robot", "fleet.fleet"},
    {"graph.edges", "graph.observed", "graph.secrets"},
    {"graph.sros2"},
    {"graph.topics", "graph.supervision"},
    {"graph.dependencies", "graph.nodes", "graph.host", "graph.plugins"},
    {"graph.provenance"},
    {"graph.dds", "graph.params"},
    {"graph.environment", "graph.set_aside"},
    {"graph.runners"},
    {
        "graph.systemd",
        "graph.launch",
        "graph.installed",
    },
    {
        "graph.workspace",
        "graph.containers",
        "graph.modules",
        "graph.netplan",
        "graph.networkmanager",
        "graph.udev",
        "graph.commands",
        "graph.switched_off",
        "graph.uncalled",
        "graph.unincluded",
        "graph.unmade",
        "graph.unreached",
    },
    {"graph.copies"},
    {"graph.files", "graph.file_nodes", "graph.interface_files", "graph.places", "graph.layers"},
    {
        "graph.absence",
        "graph.components",
        "graph.graph",
        "graph.image_builds",
        "graph.purpose",
        "graph.target",
        "graph.variants",
        "graph.words",
        "graph.yaml_edits",
    },
    {"graph.memo"},
    {"discover"},
    {"parsers", "codemods"},
    {"schema", "fleet.store"},
    {"model", "finding", "facts", "fleet.summary"},
    {"addresses"},
    {
        "budget",
        "digest",
        "endings",
        "extras",
        "folders",
        "garbage",
        "plural",
        "source",
        "spelling",
        "templates",
        "toml",
    },
    {"ignore_marks"},
    {"pattern", "dataclass", "importing", "named_tuple", "on_demand"},
    {"type_names"},
    {""},
)
"""From the top down. The layers of one line do not import each other; ``""`` is the version of the package."""
LEVEL = {name: level for level, names in enumerate(LAYERS) for name in names}


def layer_of(module: str) -> str:
    """The longest name of a layer that the module lies in."""
    parts = module.split(".")
    names = (".".join(parts[:count]) for count in range(len(parts), 0, -1))
    return next((name for name in names if name in LEVEL), "")


def upward(path: Path) -> Iterator[str]:
    """The imports of a file that do not point down."""
    module = name_of(path)
    own = layer_of(module)
    for other in import_graph()[module]:
        theirs = layer_of(other)
        if theirs != own and LEVEL[theirs] <= LEVEL[own]:
            yield f"{module}: {own} may not import {other}"


def test_every_module_is_in_a_layer() -> None:
    modules = {name_of(path) for path in paths()} - {"", "graph"}
    assert [module for module in sorted(modules) if not layer_of(module)] == []


def test_imports_point_down() -> None:
    assert [line for path in paths() for line in upward(path)] == []


def test_no_circle_of_files() -> None:
    assert [sorted(members) for members in circles(import_graph())] == []


def test_only_the_top_knows_the_robot() -> None:
    """A module of the graph says what it asks: files, or single layers."""
    below = [path for path in paths() if LEVEL[layer_of(name_of(path))] > LEVEL["robot"]]
    assert not [use for path in below for use in uses_of_robot(path)]


def test_the_documentation_lists_the_layers() -> None:
    page = (PROJECT / "docs/architecture.md").read_text("utf-8")
    drawn = page.partition("```text\n")[2].partition("```")[0]
    assert drawn.splitlines() == [" ".join(sorted(names)) for names in LAYERS if names != {""}]
