"""NetworkManager: profiles, and the questions that several of them answer together."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.on_demand import on_demand

if TYPE_CHECKING:
    from bringup_lint.graph.networkmanager.profiles import NetworkManager
    from bringup_lint.graph.networkmanager.profiles import alone_off
    from bringup_lint.graph.networkmanager.profiles import colliding
    from bringup_lint.graph.networkmanager.profiles import colliding_netplan
    from bringup_lint.model.networkmanager import Profile
else:
    __getattr__ = on_demand(globals())

__all__ = ["NetworkManager", "Profile", "alone_off", "colliding", "colliding_netplan"]
