"""IP addresses, ports and hosts, and what they mean."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.on_demand import on_demand

if TYPE_CHECKING:
    from bringup_lint.addresses import HIGHEST_PORT
    from bringup_lint.addresses import address_of
    from bringup_lint.addresses import host_of
    from bringup_lint.addresses import hosts_in
    from bringup_lint.addresses import is_address
    from bringup_lint.addresses import is_loopback
else:
    __getattr__ = on_demand(globals())

__all__ = [
    "HIGHEST_PORT",
    "address_of",
    "host_of",
    "hosts_in",
    "is_address",
    "is_loopback",
]
