"""Programs of the tree that are lifecycle nodes, and leave it to others to configure them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.graph.launch.lifecycle_names import is_switched
from bringup_lint.graph.launch.packages import code_of
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.memo import memo
from bringup_lint.graph.nodes.sources.with_header import with_header
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.launch.started import Started
    from bringup_lint.graph.topics.topics import Topics
    from bringup_lint.source import Located

_BASE = regex(r"\bpublic\s{1,8}rclcpp_lifecycle::LifecycleNode\b", hints="LifecycleNode")
_SWITCHES = regex(
    r"(?m)\btrigger_\w|\bTRANSITION_|change_state|ChangeState|auto_?start|lifecycle_manager|nav2_util"
    r"|(?:\.|->)\s{0,4}configure\s{0,4}\("
    r"|(?:^[ \t]{0,80}|[;{}(=!&|,?]\s{0,80}|\breturn\s{1,9})configure\s{0,4}\(\s{0,4}\w{0,60}\s{0,4}\)",
    hints="trigger_ TRANSITION_ change_state ChangeState autostart auto_start lifecycle_manager nav2_util configure",
)
"""By which the sources of a package may configure its nodes, also a member function of the node itself."""


def own_lifecycle(topics: Topics, node: Started) -> Located | None:
    """The name that a launched program of the tree gives its lifecycle node, where nothing of the tree changes the
    states of nodes."""
    code = topics.code(node)
    package = topics.launch.workspace.packages.get(literal_text(node.package) or "")
    if code is None or code.several or code.name is None or package is None or is_switched(topics.launch):
        return None
    if code.node_class is not None:
        is_lifecycle = code.node_class.is_lifecycle
    else:
        is_lifecycle = code.source is not None and _BASE.search(with_header(topics.nodes, code.source)) is not None
    return code.name if is_lifecycle and not _switches_own(topics.launch, package.folder) else None


@memo
def _switches_own(launch: Launch, folder: str) -> bool:
    """Whether the sources below a folder may configure their nodes themselves."""
    return _SWITCHES.search(code_of(launch, folder)) is not None
