"""Quality of service that parameters decide: ``qos_overrides``."""

from __future__ import annotations

from typing import TYPE_CHECKING
from typing import Any

from bringup_lint.dataclass import replace

if TYPE_CHECKING:
    from bringup_lint.graph.topics.resolved.endpoint_use import Use
    from bringup_lint.graph.topics.resolved.parameters import GivenParameters

POLICIES = ("reliability", "durability", "history", "depth")
ALLOWED = ("/tf", "/tf_static")
"""Topics of tf2, whose publishers and subscriptions take overrides of these policies."""


def overridden(use: Use, given: GivenParameters) -> Use:
    """The use with the policies that ``qos_overrides.<topic>.<role>.<policy>`` gives; they count only where the node
    allows them, so that elsewhere a policy that is overridden is not known."""
    prefix = f"qos_overrides.{use.topic}.{use.role}"
    for name, (value, where) in given.values.items():
        if use.qos is None or not name.startswith(prefix) or name[len(prefix) : len(prefix) + 1] not in (".", "_"):
            continue
        policy = name.rpartition(".")[2]
        certain = name == f"{prefix}.{policy}" and use.topic in ALLOWED and policy in POLICIES
        known = value.upper() if isinstance(value, str) else value
        if policy in POLICIES:
            change: dict[str, Any] = {policy: known if certain else None}
            use.qos = replace(use.qos, **change)
            use.qos_parameter = where if certain else None
        else:
            use.qos = replace(use.qos, deadline=None, liveliness=None, lease=None)
    return use
