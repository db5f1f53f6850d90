"""Topics that a process uses and that the permissions of its enclave do not allow."""

from __future__ import annotations

from collections.abc import Iterator
from fnmatch import fnmatchcase
from typing import TYPE_CHECKING
from typing import NamedTuple

from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.graph.sros2.enclaves import of_node
from bringup_lint.model.sros2 import Governance
from bringup_lint.model.sros2 import Grant
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.topics.resolved.endpoint_use import LaunchedNode
    from bringup_lint.graph.topics.resolved.endpoint_use import Use
    from bringup_lint.robot import Robot

LISTS = {"publisher": "publish", "subscription": "subscribe"}


class Ungranted(NamedTuple):
    use: Use
    grant: Grant
    enclave: Located
    """Where the process selects it."""
    near: Located | None
    """What is granted instead: the same last part under another name."""


def ungranted(robot: Robot) -> Iterator[Ungranted]:
    """Only for topics whose full names are known, and where every document for the enclave denies them."""
    if not robot.of_kind(*LAUNCH):
        return
    grants: dict[str, list[Grant]] = {}
    unchecked: set[int] = set()
    for permissions, grant in robot.sros2.ros_grants:
        grants.setdefault(str(grant.enclave), []).append(grant)
        if any(map(_leaves_open, robot.sros2.governances_of(permissions.source))):
            unchecked.add(id(grant))
    seen = set()
    for running in robot.topics.runs if grants else ():
        for node in running.nodes:
            enclave = _enclave(node)
            for use in node.uses if enclave is not None and str(enclave) in grants else ():
                documents = grants[str(enclave)]
                key = (str(enclave), use.role, use.topic)
                if key in seen or use.conditional_source or unchecked & set(map(id, documents)):
                    continue
                if all(_denies(grant, use) for grant in documents):
                    seen.add(key)
                    yield Ungranted(use, documents[0], enclave, _near(documents[0], use))


def _leaves_open(governance: Governance) -> bool:
    """Whether a governance document has the permissions of some topic not checked."""
    return any(
        rule.fields.get(f"enable_{way}_access_control") in ("false", "0", "FALSE")
        for domain in governance.rules
        for rule in domain.topic_rules
        for way in ("read", "write")
    )


def _enclave(node: LaunchedNode) -> Located | None:
    """The enclave belongs to the process: for a component, to its container."""
    process = node.started.container or node.started
    return of_node(process)[1]


def _denies(grant: Grant, use: Use) -> bool:
    """Rules in order, then the default. A grant without a default is left to its own rule."""
    for rule in grant.rules:
        if any(fnmatchcase(f"rt{use.topic}", topic) for topic in getattr(rule, LISTS[use.role])):
            return not rule.allows
    return grant.default == "DENY"


def _near(grant: Grant, use: Use) -> Located | None:
    tail = use.topic.rpartition("/")[2]
    topics = (topic for rule in grant.allowed for topic in getattr(rule, LISTS[use.role]))
    return next((topic for topic in topics if topic.rpartition("/")[2] == tail), None)
