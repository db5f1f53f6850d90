"""Addresses of hosts, as peers and discovery servers name them."""

from __future__ import annotations

from bringup_lint.graph.dds.addresses import hosts_in
from bringup_lint.graph.dds.addresses import is_address

__all__ = [
    "hosts_in",
    "is_address",
]
