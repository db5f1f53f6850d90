"""Cyclone DDS configurations: what their names and values mean, and the discovery that follows from them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.on_demand import on_demand
from bringup_lint.parsers.cyclonedds_values import words as words_of

if TYPE_CHECKING:
    from bringup_lint.graph.dds.cyclonedds_discovery import bad_addresses
    from bringup_lint.graph.dds.cyclonedds_discovery import contacts_itself
    from bringup_lint.graph.dds.cyclonedds_discovery import domain_number
    from bringup_lint.graph.dds.cyclonedds_discovery import finds_itself
    from bringup_lint.graph.dds.cyclonedds_discovery import has_peers
    from bringup_lint.graph.dds.cyclonedds_discovery import least_buffers
    from bringup_lint.graph.dds.cyclonedds_discovery import multicast_off
    from bringup_lint.graph.dds.cyclonedds_discovery import on_loopback_only
    from bringup_lint.graph.dds.cyclonedds_discovery import peer_addresses
    from bringup_lint.graph.dds.cyclonedds_discovery import peers
    from bringup_lint.graph.dds.cyclonedds_discovery import size_of
    from bringup_lint.graph.dds.cyclonedds_names import can_be_renamed
    from bringup_lint.graph.dds.cyclonedds_names import first_named
    from bringup_lint.graph.dds.cyclonedds_names import has_address
    from bringup_lint.graph.dds.cyclonedds_names import interfaces_instead
    from bringup_lint.graph.dds.cyclonedds_names import meant_item
    from bringup_lint.graph.dds.cyclonedds_names import place_of
    from bringup_lint.graph.dds.cyclonedds_names import taken_by
    from bringup_lint.graph.dds.cyclonedds_names import versions_with
    from bringup_lint.model.cyclonedds import Configuration
    from bringup_lint.model.cyclonedds import Domain
    from bringup_lint.model.cyclonedds import Setting
    from bringup_lint.parsers.cyclonedds_checks import PORT_DEFAULTS
else:
    __getattr__ = on_demand(globals())

__all__ = [
    "PORT_DEFAULTS",
    "Configuration",
    "Domain",
    "Setting",
    "bad_addresses",
    "can_be_renamed",
    "contacts_itself",
    "domain_number",
    "finds_itself",
    "first_named",
    "has_address",
    "has_peers",
    "interfaces_instead",
    "least_buffers",
    "meant_item",
    "multicast_off",
    "on_loopback_only",
    "peer_addresses",
    "peers",
    "place_of",
    "size_of",
    "taken_by",
    "versions_with",
    "words_of",
]
