"""What the controller manager of a package loads from other packages."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from typing import TYPE_CHECKING

from bringup_lint.facts import table
from bringup_lint.facts.ros.brought import is_released
from bringup_lint.facts.ros.simulation import is_simulation
from bringup_lint.graph.dependencies.needs import Need
from bringup_lint.graph.dependencies.needs import is_installed
from bringup_lint.graph.dependencies.needs import is_meant
from bringup_lint.graph.launch.packages import is_known_package
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.parsers import params
from bringup_lint.parsers import urdf
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.launch.launch import Launch

_MANAGER = "controller_manager"


def of_plugins(files: Files, launch: Launch) -> Iterator[Need]:
    """The packages of the hardware that descriptions name, and of the controllers that parameter files name, of a
    package whose launch files talk to the controller manager."""
    managing = _managing(launch)
    if not managing:
        return
    for source in files.of_kind("urdf", "params"):
        owner = launch.workspace.owner(source)
        if owner is None or owner.name not in managing or not source.judged:
            continue
        if is_meant(files, source, owner) and (not owner.installs_known or is_installed(owner, source)):
            for plugin in _plugins(source):
                package = plugin.partition("/")[0]
                is_public = plugin in _public() and (is_released(package) or is_known_package(package))
                is_known = is_public or package in launch.workspace.packages
                if is_known and not is_simulation(package):
                    yield Need("plugin", Located(package, plugin.span), owner)


def _managing(launch: Launch) -> frozenset[str]:
    """The packages whose launch files start what belongs to the controller manager."""
    started = (node for node in launch.nodes if literal_text(node.package) == _MANAGER)
    owners = (launch.workspace.owner(node.file.source) for node in started)
    return frozenset(owner.name for owner in owners if owner is not None)


def _plugins(source: Source) -> list[Located]:
    """The classes that a description or a parameter file names."""
    if source.kind == "urdf":
        return urdf.parse(source).plugins
    named = (each for block in params.parse(source).blocks for each in block.parameters)
    types = (each for each in named if each.name.rpartition(".")[2] == "type" and isinstance(each.value.data, str))
    return [Located(str(each.value.data), each.span) for each in types]


@cache
def _public() -> frozenset[str]:
    return frozenset(row["name"] for row in table("ros/plugins"))
