"""Which of the nodes of one launch run at the same time and in the same domain."""

from __future__ import annotations

from bringup_lint.graph.commands.environment import Environment
from bringup_lint.graph.environment.launched import launched_environment
from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.launch.started import exclusive
from bringup_lint.graph.topics.resolved.endpoint_use import LaunchedNode
from bringup_lint.model.launch import EventHandler

DOMAIN = "ROS_DOMAIN_ID"
ENDINGS = ("OnProcessExit", "OnExecutionComplete", "OnShutdown")


def coexist(one: LaunchedNode, other: LaunchedNode) -> bool:
    """Whether two nodes both start when no argument is passed, and can meet."""
    if one is other:
        return True
    ours, theirs = one.started, other.started
    if ours.by_default is not True or theirs.by_default is not True or exclusive(ours, theirs):
        return False
    return not (_waits_for(ours, theirs) or _waits_for(theirs, ours)) and _domain(ours) == _domain(theirs)


def _waits_for(one: Started, other: Started) -> bool:
    """Whether a node starts only when the other has ended."""
    for action in one.context:
        if action is other.action:
            return True
        if isinstance(action, EventHandler) and action.event in ENDINGS and action.target in (None, other.action.key):
            return True
    return False


def _domain(node: Started) -> tuple[bool | None, str | None]:
    """The domain that launch gives to a process, and whether it gives one at all."""
    if DOMAIN not in node.env and not node.own_env:
        return False, None
    environment = launched_environment(Environment(), node)
    return environment.defines(DOMAIN), environment.text(DOMAIN)
