"""Topics that a process uses and that the permissions of its enclave do not allow."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator
from collections.abc import Mapping
from fnmatch import fnmatchcase
from typing import TYPE_CHECKING

from bringup_lint.graph.sros2.enclaves import enclave_of
from bringup_lint.model.sros2 import Governance
from bringup_lint.model.sros2 import Grant
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.topics.resolved.endpoint_use import LaunchedNode
    from bringup_lint.graph.topics.resolved.endpoint_use import Use

LISTS = {"publisher": "publish", "subscription": "subscribe"}


class Ungranted(NamedTuple):
    use: Use
    grant: Grant
    enclave: Located
    """Where the process selects it."""
    near: Located | None
    """What is granted instead: the same last part under another name."""


Grants = Mapping[str, list[Grant]]
"""Name of an enclave -> what every document for it grants."""


def grants_of(documents: Iterable[tuple[Grant, list[Governance]]]) -> Grants:
    """The grants of each enclave of which all topics are checked; each grant with the governance of its keystore."""
    found: dict[str, list[Grant]] = {}
    unchecked = set()
    for grant, governances in documents:
        found.setdefault(str(grant.enclave), []).append(grant)
        if any(map(_leaves_open, governances)):
            unchecked.add(str(grant.enclave))
    return {enclave: grants for enclave, grants in found.items() if enclave not in unchecked}


def ungranted(grants: Grants, nodes: Iterable[LaunchedNode]) -> Iterator[Ungranted]:
    """Only for topics whose full names are known, and where every document for the enclave denies them."""
    seen: set[tuple[str, str, str]] = set()
    for node in nodes:
        enclave = _enclave(node)
        documents = grants.get(str(enclave))
        if enclave is None or documents is None:
            continue
        for use in node.uses:
            key = (str(enclave), use.role, use.topic)
            if key in seen or use.conditional_source or not all(_denies(grant, use) for grant in documents):
                continue
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
    return enclave_of(process)[1]


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
