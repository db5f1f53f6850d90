"""What selects a DDS configuration, and the networks and interfaces that it names."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.on_demand import on_demand

if TYPE_CHECKING:
    from bringup_lint.graph.dds.network import interface_of_device
    from bringup_lint.graph.dds.network import interface_with
    from bringup_lint.graph.dds.network import may_exist
    from bringup_lint.graph.dds.network import named_interfaces
    from bringup_lint.graph.dds.network import networks
    from bringup_lint.graph.dds.network import subnets
    from bringup_lint.graph.dds.renaming import renamed
    from bringup_lint.graph.dds.selection import Selection
    from bringup_lint.graph.dds.selection import user_of
else:
    __getattr__ = on_demand(globals())

__all__ = [
    "Selection",
    "interface_of_device",
    "interface_with",
    "may_exist",
    "named_interfaces",
    "networks",
    "renamed",
    "subnets",
    "user_of",
]
