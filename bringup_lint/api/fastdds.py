"""Fast DDS profiles: what their names mean, transports, peers and QoS."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.on_demand import on_demand

if TYPE_CHECKING:
    from bringup_lint.graph.dds.fastdds_names import can_be_renamed
    from bringup_lint.graph.dds.fastdds_names import first_named
    from bringup_lint.graph.dds.fastdds_names import initial_peers
    from bringup_lint.graph.dds.fastdds_names import is_beside
    from bringup_lint.graph.dds.fastdds_names import meant_name
    from bringup_lint.graph.dds.fastdds_names import multicast_peers
    from bringup_lint.graph.dds.fastdds_names import number
    from bringup_lint.graph.dds.fastdds_names import overwritten_qos
    from bringup_lint.graph.dds.fastdds_names import place_of
    from bringup_lint.graph.dds.fastdds_names import seconds
    from bringup_lint.graph.dds.fastdds_names import transport_named
    from bringup_lint.graph.dds.fastdds_names import transport_type
    from bringup_lint.graph.dds.fastdds_names import used_transports
    from bringup_lint.graph.dds.fastdds_names import versions_with
    from bringup_lint.graph.dds.fastdds_names import whitelisted_addresses
    from bringup_lint.graph.dds.fastdds_names import with_blanks
    from bringup_lint.graph.dds.fastdds_names import words_taken
else:
    __getattr__ = on_demand(globals())

__all__ = [
    "can_be_renamed",
    "first_named",
    "initial_peers",
    "is_beside",
    "meant_name",
    "multicast_peers",
    "number",
    "overwritten_qos",
    "place_of",
    "seconds",
    "transport_named",
    "transport_type",
    "used_transports",
    "versions_with",
    "whitelisted_addresses",
    "with_blanks",
    "words_taken",
]
