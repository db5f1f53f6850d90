"""Displays and helpers whose end shuts down all that an including launch file starts."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.started import literal_text
from bringup_lint.model.launch import Emit
from bringup_lint.model.launch import walk_actions
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.launch.expansion import Expansion
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.launch.started import Started
    from bringup_lint.source import Span

_HELPER = regex(
    r"(?<![a-z\d])(?:rviz2?|rqt|ui|gui|hmi|dashboard|viewer|plotjuggler|foxglove_bridge|rosbridge_server|rosapi"
    r"|web_video_server|diagnostic_aggregator|rosboard)(?![a-z\d])",
    hints="rviz rqt ui gui hmi dashboard viewer plotjuggler foxglove_bridge rosbridge rosapi web_video diagnostic_agg "
    "rosboard",
)
"""What shows something, or hands it on, and that no robot needs to drive."""


class Shutdown(NamedTuple):
    helper: Started
    action: Span
    """What shuts down."""
    include: Span
    """How the launch file that starts the others comes to it."""
    others: tuple[Started, ...]
    """What ends with it."""


def shut_down_by_helpers(launch: Launch) -> Iterator[Shutdown]:
    """Each place once, for the first launch file that includes it and starts something else."""
    seen: set[Span] = set()
    for expansion in launch.entries:
        if launch.simulated(expansion.entry):
            continue
        for helper, action in _ends(expansion):
            if action in seen or not helper.chain or not _is_helper(launch, helper):
                continue
            others = tuple(each for each in expansion.nodes if _is_other(launch, each, helper))
            if others:
                seen.add(action)
                yield Shutdown(helper, action, helper.chain[0], others)


def _ends(expansion: Expansion) -> Iterator[tuple[Started, Span]]:
    """What no argument has to switch on, and shuts everything down when it ends, with the action that does."""
    by_key = {node.action.key: node for node in expansion.nodes if node.by_default is not False}
    for node in by_key.values():
        for action in walk_actions(getattr(node.action, "on_exit", ())):
            if isinstance(action, Emit) and action.event == "shutdown":
                yield node, action.span
    for handler, _ in expansion.handlers:
        target = by_key.get(handler.target) if handler.target is not None else None
        if target is None or handler.event != "OnProcessExit" or handler.conditions:
            continue
        for action in walk_actions(handler.actions):
            if isinstance(action, Emit) and action.event == "shutdown" and not action.conditions:
                yield target, action.span


def _is_helper(launch: Launch, node: Started) -> bool:
    """Whether a package is that of a display or helper; of a process, the package of its launch file."""
    package = literal_text(node.package)
    if package is None and not node.is_node:
        owner = launch.workspace.owner(node.file.source)
        package = owner.manifest.name if owner is not None else None
    return package is not None and _HELPER.search(package) is not None


def _is_other(launch: Launch, node: Started, helper: Started) -> bool:
    """Whether a node starts without arguments in another file than a helper, and is none itself."""
    return node.is_node and node.by_default is True and node.file is not helper.file and not _is_helper(launch, node)
