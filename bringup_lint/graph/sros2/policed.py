"""sros2 policies joined to what launch files start."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.sros2.enclaves import of_node
from bringup_lint.model.launch import ComposableNode
from bringup_lint.model.sros2_policy import Policy
from bringup_lint.model.sros2_policy import PolicyEnclave
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.robot import Robot

_ALL = ("*", "/*", "**", "/**")


def described(policies: list[Policy]) -> dict[str, PolicyEnclave]:
    """The enclaves that exactly one policy describes, with all their profiles in it."""
    found: dict[str, list[PolicyEnclave]] = {}
    for policy in policies:
        for enclave in policy.enclaves:
            found.setdefault(str(enclave.path), []).append(enclave)
    return {path: each[0] for path, each in found.items() if len(each) == 1 and not each[0].open}


def policed_nodes(robot: Robot, policies: list[Policy]) -> Iterator[tuple[Started, Located, PolicyEnclave]]:
    """The nodes of known name that select such an enclave, with the word that selects it."""
    known = described(policies) if policies else {}
    for node in _started(robot) if known else ():
        _, selected = of_node(node)
        enclave = known.get(str(selected)) if selected is not None else None
        if enclave is not None and node.fqn is not None and not _allows_everything(enclave):
            yield node, selected, enclave


def _started(robot: Robot) -> Iterator[Started]:
    """The nodes that start when nothing else is asked for, each once, as their units or entries start them."""
    if not robot.of_kind(*LAUNCH):
        return
    seen = set()
    launched = [each for launcher in robot.ros.launchers for each in robot.ros.launched_by(launcher)]
    files = {id(file) for each in launched for file in each.expansion.files}
    entries = (expansion for expansion in robot.launch.entries if id(expansion.entry) not in files)
    for node in (*(each.node for each in launched), *(node for each in entries for node in each.nodes)):
        place = (id(node.span.source), node.span.start, node.fqn)
        if node.by_default is True and not isinstance(node.action, ComposableNode) and place not in seen:
            seen.add(place)
            yield node


def _allows_everything(enclave: PolicyEnclave) -> bool:
    """Whether any node's parameter services are granted."""
    rights = (right for profile in enclave.profiles for right in profile.rights)
    return any(right.kind == "service" and right.allows("reply") and right.name.strip() in _ALL for right in rights)
