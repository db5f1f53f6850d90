"""Controllers that get the name of their manager, because a launch file names it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.python_api import distribution_of
from bringup_lint.graph.launch.python_api import looks_at_distribution
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.plugins.controllers import is_manager
from bringup_lint.graph.plugins.controllers import spawned_by
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.launch.started import Started
    from bringup_lint.graph.params.params import Params

_RENAMING = ("foxy", "galactic", "humble", "iron")
"""Releases whose controllers take the arguments of the whole process (controller_interface_base.cpp)."""
_GIVES_FILE = ".params_file"
"""The end of the parameter by which a manager gives a controller a file of its own (controller_manager.cpp)."""
_BROADCASTER = "broadcaster"
"""Controllers that run without parameters."""


class RenamedControllers(NamedTuple):
    name: Located
    """The name that the launch file gives to the manager."""
    controllers: tuple[Located, ...]
    """Those of them that need parameters, where they are spawned."""
    manager: Started
    distribution: str


def renamed_controllers(launch: Launch, params: Params) -> Iterator[RenamedControllers]:
    """Each manager once; not where a parameter file gives joints to every node."""
    if any(str(each.block.key) in ("**", "/**") for _, each in params.named("joints")):
        return
    found: dict[Span, RenamedControllers] = {}
    for expansion in launch.entries:
        managers = [node for node in expansion.nodes if is_manager(node)]
        controllers = [name for node in expansion.nodes for name in spawned_by(node) if _BROADCASTER not in name]
        renamed = _renamed(launch, managers[0], controllers) if len(managers) == 1 and controllers else None
        if renamed is not None:
            found.setdefault(renamed.name.span, renamed)
    yield from found.values()


def _renamed(launch: Launch, manager: Started, controllers: list[Located]) -> RenamedControllers | None:
    name, distribution = literal_text(manager.name), distribution_of(launch, manager.file)
    if name is None or distribution not in _RENAMING:
        return None
    if not manager.file.source.judged or looks_at_distribution(manager.file):
        return None
    if _GIVES_FILE in manager.file.source.text:
        return None
    return RenamedControllers(name, tuple(controllers), manager, str(distribution))
