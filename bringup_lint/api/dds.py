"""CycloneDDS and Fast DDS configurations, and the discovery that follows from them."""

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
    from bringup_lint.graph.dds.cyclonedds_names import accepted_by
    from bringup_lint.graph.dds.cyclonedds_names import can_be_renamed
    from bringup_lint.graph.dds.cyclonedds_names import first_of
    from bringup_lint.graph.dds.cyclonedds_names import interfaces_instead
    from bringup_lint.graph.dds.cyclonedds_names import meant_item
    from bringup_lint.graph.dds.cyclonedds_names import place_of
    from bringup_lint.graph.dds.cyclonedds_names import renamed
    from bringup_lint.graph.dds.cyclonedds_names import taken_by
    from bringup_lint.graph.dds.fastdds_names import can_become
    from bringup_lint.graph.dds.fastdds_names import first_named
    from bringup_lint.graph.dds.fastdds_names import initial_peers
    from bringup_lint.graph.dds.fastdds_names import is_beside
    from bringup_lint.graph.dds.fastdds_names import meant_name
    from bringup_lint.graph.dds.fastdds_names import multicast_peers
    from bringup_lint.graph.dds.fastdds_names import number
    from bringup_lint.graph.dds.fastdds_names import overwritten_qos
    from bringup_lint.graph.dds.fastdds_names import places_of
    from bringup_lint.graph.dds.fastdds_names import seconds
    from bringup_lint.graph.dds.fastdds_names import transport_named
    from bringup_lint.graph.dds.fastdds_names import transport_type
    from bringup_lint.graph.dds.fastdds_names import used_transports
    from bringup_lint.graph.dds.fastdds_names import versions_with
    from bringup_lint.graph.dds.fastdds_names import whitelisted_addresses
    from bringup_lint.graph.dds.fastdds_names import with_blanks
    from bringup_lint.graph.dds.fastdds_names import words_taken
    from bringup_lint.graph.dds.network import interface_of_device
    from bringup_lint.graph.dds.network import interface_with
    from bringup_lint.graph.dds.network import may_exist
    from bringup_lint.graph.dds.network import named_interfaces
    from bringup_lint.graph.dds.network import networks
    from bringup_lint.graph.dds.network import subnets
    from bringup_lint.graph.dds.selection import Selection
    from bringup_lint.graph.dds.selection import user_of
    from bringup_lint.model.cyclonedds import Configuration
    from bringup_lint.model.cyclonedds import Domain
    from bringup_lint.model.cyclonedds import Setting
else:
    __getattr__ = on_demand(globals())

__all__ = [
    "Configuration",
    "Domain",
    "Selection",
    "Setting",
    "accepted_by",
    "bad_addresses",
    "can_be_renamed",
    "can_become",
    "contacts_itself",
    "domain_number",
    "finds_itself",
    "first_named",
    "first_of",
    "has_peers",
    "initial_peers",
    "interface_of_device",
    "interface_with",
    "interfaces_instead",
    "is_beside",
    "least_buffers",
    "may_exist",
    "meant_item",
    "meant_name",
    "multicast_off",
    "multicast_peers",
    "named_interfaces",
    "networks",
    "number",
    "on_loopback_only",
    "overwritten_qos",
    "peer_addresses",
    "peers",
    "place_of",
    "places_of",
    "renamed",
    "seconds",
    "size_of",
    "subnets",
    "taken_by",
    "transport_named",
    "transport_type",
    "used_transports",
    "user_of",
    "versions_with",
    "whitelisted_addresses",
    "with_blanks",
    "words_of",
    "words_taken",
]
