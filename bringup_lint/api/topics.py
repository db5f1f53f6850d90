"""Topics: endpoints, velocity commands, misspelt names."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.on_demand import on_demand

if TYPE_CHECKING:
    from bringup_lint.graph.topics.questions.apart import UnservedApart
    from bringup_lint.graph.topics.questions.apart import unserved_apart
    from bringup_lint.graph.topics.questions.autopilot import too_reliable
    from bringup_lint.graph.topics.questions.bonds import Bonds
    from bringup_lint.graph.topics.questions.command_sources import is_gate
    from bringup_lint.graph.topics.questions.command_sources import is_stop
    from bringup_lint.graph.topics.questions.command_sources import is_velocity
    from bringup_lint.graph.topics.questions.command_sources import past_the_mux
    from bringup_lint.graph.topics.questions.command_sources import rivals
    from bringup_lint.graph.topics.questions.command_sources import ungated
    from bringup_lint.graph.topics.questions.compatibility import conflicts_of
    from bringup_lint.graph.topics.questions.compatibility import types_differ
    from bringup_lint.graph.topics.questions.controller_topics import unheard_by_controllers
    from bringup_lint.graph.topics.questions.dead_remappings import DeadRemapping
    from bringup_lint.graph.topics.questions.dead_remappings import dead_remappings
    from bringup_lint.graph.topics.questions.device_programs import device_role
    from bringup_lint.graph.topics.questions.drive_inputs import Unheard
    from bringup_lint.graph.topics.questions.drive_inputs import unheard_commands
    from bringup_lint.graph.topics.questions.misspelt import misspelt
    from bringup_lint.graph.topics.questions.misspelt import probable_typos
    from bringup_lint.graph.topics.questions.monitored_velocities import unmonitored
    from bringup_lint.graph.topics.questions.namespaces import shared_by_namespaces
    from bringup_lint.graph.topics.questions.orphans import orphans
    from bringup_lint.graph.topics.questions.other_ends import used_at
    from bringup_lint.graph.topics.questions.own_lifecycle import own_lifecycle
    from bringup_lint.graph.topics.questions.recorded import misspelt_records
    from bringup_lint.graph.topics.questions.single_names import single_names
    from bringup_lint.graph.topics.questions.single_parameters import single_parameters
    from bringup_lint.graph.topics.questions.transform_files import rivals_in_files
    from bringup_lint.graph.topics.questions.two_parents import two_parents
    from bringup_lint.graph.topics.questions.unfed_inputs import unfed_inputs
    from bringup_lint.graph.topics.questions.unmatched import without_publisher
    from bringup_lint.graph.topics.questions.unpublished import unpublished
    from bringup_lint.graph.topics.questions.unserved import unserved
    from bringup_lint.graph.topics.resolved.endpoint_use import LaunchedNode
    from bringup_lint.graph.topics.resolved.endpoint_use import Pair
    from bringup_lint.graph.topics.resolved.endpoint_use import Use
    from bringup_lint.graph.topics.resolved.names import refusal
    from bringup_lint.graph.topics.resolved.names import tail
    from bringup_lint.graph.topics.sources.publishing import published_at_start
else:
    __getattr__ = on_demand(globals())

__all__ = [
    "Bonds",
    "DeadRemapping",
    "LaunchedNode",
    "Pair",
    "Unheard",
    "UnservedApart",
    "Use",
    "conflicts_of",
    "dead_remappings",
    "device_role",
    "is_gate",
    "is_stop",
    "is_velocity",
    "misspelt",
    "misspelt_records",
    "orphans",
    "own_lifecycle",
    "past_the_mux",
    "probable_typos",
    "published_at_start",
    "refusal",
    "rivals",
    "rivals_in_files",
    "shared_by_namespaces",
    "single_names",
    "single_parameters",
    "tail",
    "too_reliable",
    "two_parents",
    "types_differ",
    "unfed_inputs",
    "ungated",
    "unheard_by_controllers",
    "unheard_commands",
    "unmonitored",
    "unpublished",
    "unserved",
    "unserved_apart",
    "used_at",
    "without_publisher",
]
