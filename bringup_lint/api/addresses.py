"""IP addresses, ports and hosts, and what they mean."""

from __future__ import annotations

from bringup_lint.addresses import HIGHEST_PORT
from bringup_lint.addresses import address_of
from bringup_lint.addresses import host_of
from bringup_lint.addresses import hosts_in
from bringup_lint.addresses import is_address
from bringup_lint.addresses import is_loopback

__all__ = [
    "HIGHEST_PORT",
    "address_of",
    "host_of",
    "hosts_in",
    "is_address",
    "is_loopback",
]
