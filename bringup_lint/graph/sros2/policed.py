"""sros2 policies joined to what launch files start."""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.sros2.enclaves import enclave_of
from bringup_lint.model.launch import ComposableNode
from bringup_lint.model.sros2_policy import Policy
from bringup_lint.model.sros2_policy import PolicyEnclave
from bringup_lint.source import Located
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.environment.ros import RosEnvironment
    from bringup_lint.graph.launch.launch import Launch

_ALL = ("*", "/*", "**", "/**")


def described(policies: list[Policy]) -> dict[str, PolicyEnclave]:
    """The enclaves that exactly one policy describes, with all their profiles in it."""
    found: dict[str, list[PolicyEnclave]] = {}
    for policy in policies:
        for enclave in policy.enclaves:
            found.setdefault(str(enclave.path), []).append(enclave)
    return {path: each[0] for path, each in found.items() if len(each) == 1 and not each[0].open}


def policed_nodes(
    policies: list[Policy], ros: RosEnvironment, launch: Callable[[], Launch]
) -> Iterator[tuple[Started, Located, PolicyEnclave]]:
    """The nodes of known name that select such an enclave, with the word that selects it."""
    known = described(policies)
    if not known:
        return
    for node in _started(ros, launch()):
        _, selected = enclave_of(node)
        enclave = known.get(str(selected))
        if selected is None or enclave is None or node.fqn is None or _allows_everything(enclave):
            continue
        yield node, selected, enclave


def _started(ros: RosEnvironment, launch: Launch) -> Iterator[Started]:
    """The nodes that start when nothing else is asked for, each once, as their runners or entries start them."""
    seen: set[tuple[Span, str | None]] = set()
    launched = [each for launcher in ros.launchers for each in ros.launched_by(launcher)]
    files = {file for each in launched for file in each.expansion.files}
    entries = (expansion for expansion in launch.entries if expansion.entry not in files)
    for node in (*(each.node for each in launched), *(node for each in entries for node in each.nodes)):
        place = (node.span, node.fqn)
        if node.by_default is True and not isinstance(node.action, ComposableNode) and place not in seen:
            seen.add(place)
            yield node


def _allows_everything(enclave: PolicyEnclave) -> bool:
    """Whether any node's parameter services are granted."""
    rights = (right for profile in enclave.profiles for right in profile.rights)
    return any(right.kind == "service" and right.allows("reply") and right.name.strip() in _ALL for right in rights)
