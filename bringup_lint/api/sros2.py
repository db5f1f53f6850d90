"""Keystores, policies, governance and permissions documents."""

from __future__ import annotations

from fnmatch import fnmatchcase as matches
from typing import TYPE_CHECKING

from bringup_lint.on_demand import on_demand

if TYPE_CHECKING:
    from bringup_lint.graph.sros2.enclaves import enclave_of
    from bringup_lint.model.sros2 import Grant
    from bringup_lint.model.sros2 import TopicRule
    from bringup_lint.model.sros2 import moment
    from bringup_lint.model.sros2 import moves_robot
    from bringup_lint.model.sros2_policy import PolicyEnclave
    from bringup_lint.model.sros2_policy import Right
else:
    __getattr__ = on_demand(globals())

__all__ = [
    "Grant",
    "PolicyEnclave",
    "Right",
    "TopicRule",
    "enclave_of",
    "matches",
    "moment",
    "moves_robot",
]
