"""The sources of nodes: callbacks, shutdown, safe states."""

from __future__ import annotations

from bringup_lint.on_demand import on_demand
from bringup_lint.pattern import regex
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.edits import import_edits
    from bringup_lint.graph.nodes.edits import swap
    from bringup_lint.graph.nodes.edits import tried_shutdown
    from bringup_lint.graph.nodes.questions.callbacks.asyncio_waits import awaits_asyncio
    from bringup_lint.graph.nodes.questions.callbacks.blocking_calls import UNTIL_TIMEOUT
    from bringup_lint.graph.nodes.questions.callbacks.busy_loops import busy_loops
    from bringup_lint.graph.nodes.questions.callbacks.callback_fit import UnfitCallback
    from bringup_lint.graph.nodes.questions.callbacks.callback_fit import unfit_callbacks
    from bringup_lint.graph.nodes.questions.callbacks.canceled_goals import canceled_goals
    from bringup_lint.graph.nodes.questions.callbacks.early_results import early_results
    from bringup_lint.graph.nodes.questions.callbacks.endless_answers import endless_answers
    from bringup_lint.graph.nodes.questions.callbacks.future_fields import fields_of_futures
    from bringup_lint.graph.nodes.questions.callbacks.ignored_cancels import ignored_cancels
    from bringup_lint.graph.nodes.questions.callbacks.loop_variables import late_bound
    from bringup_lint.graph.nodes.questions.callbacks.lost_requests import lost_requests
    from bringup_lint.graph.nodes.questions.callbacks.making_loops import making_loops
    from bringup_lint.graph.nodes.questions.callbacks.nested_spins import nested_spins
    from bringup_lint.graph.nodes.questions.callbacks.races import races
    from bringup_lint.graph.nodes.questions.callbacks.rates import endless_rates
    from bringup_lint.graph.nodes.questions.callbacks.rejected_goals import stuck_flags
    from bringup_lint.graph.nodes.questions.callbacks.sent_in_vain import sent_in_vain
    from bringup_lint.graph.nodes.questions.callbacks.service_waits import waits
    from bringup_lint.graph.nodes.questions.callbacks.stale_parameters import stale_reads
    from bringup_lint.graph.nodes.questions.callbacks.stopped_callbacks import never_run
    from bringup_lint.graph.nodes.questions.callbacks.stopped_callbacks import stopped_callbacks
    from bringup_lint.graph.nodes.questions.callbacks.stopped_callbacks import stopped_in_cpp
    from bringup_lint.graph.nodes.questions.callbacks.transform_waits import starved_waits
    from bringup_lint.graph.nodes.questions.callbacks.transforms import early_lookups
    from bringup_lint.graph.nodes.questions.callbacks.transforms import unhandled_transforms
    from bringup_lint.graph.nodes.questions.callbacks.unregistered_types import unregistered_types
    from bringup_lint.graph.nodes.questions.commands.offboard_signals import rare_signals
    from bringup_lint.graph.nodes.questions.commands.repeating import guards_commands
    from bringup_lint.graph.nodes.questions.commands.repeating import held
    from bringup_lint.graph.nodes.questions.commands.repeating import repeated
    from bringup_lint.graph.nodes.questions.commands.stale_readings import stale_readings
    from bringup_lint.graph.nodes.questions.commands.unrun_checks import unrun_checks
    from bringup_lint.graph.nodes.questions.commands.zero_divisors import zero_divisors
    from bringup_lint.graph.nodes.questions.cpp.component_ends import ended_containers
    from bringup_lint.graph.nodes.questions.cpp.empty_queues import is_never_filled
    from bringup_lint.graph.nodes.questions.cpp.in_file import blind_waits
    from bringup_lint.graph.nodes.questions.cpp.in_file import cut_answers
    from bringup_lint.graph.nodes.questions.cpp.in_file import early_members
    from bringup_lint.graph.nodes.questions.cpp.in_file import format_texts
    from bringup_lint.graph.nodes.questions.cpp.in_file import repeated_branches
    from bringup_lint.graph.nodes.questions.cpp.in_file import unread_answers
    from bringup_lint.graph.nodes.questions.cpp.in_file import wrong_durations
    from bringup_lint.graph.nodes.questions.cpp.missing_returns import missing_returns
    from bringup_lint.graph.nodes.questions.cpp.relocks import relocks
    from bringup_lint.graph.nodes.questions.cpp.thrown import thrown
    from bringup_lint.graph.nodes.questions.cpp.time_clocks import ClockMix
    from bringup_lint.graph.nodes.questions.cpp.time_clocks import clock_mixes
    from bringup_lint.graph.nodes.questions.cpp.unset_members import unset_members
    from bringup_lint.graph.nodes.questions.cpp.unthrown import unthrown
    from bringup_lint.graph.nodes.questions.cpp.waiting_handlers import waiting_handlers
    from bringup_lint.graph.nodes.questions.cpp.zero_fractions import zero_fractions
    from bringup_lint.graph.nodes.questions.ending.deaf_handlers import deaf_handlers
    from bringup_lint.graph.nodes.questions.ending.endless_threads import endless_threads
    from bringup_lint.graph.nodes.questions.ending.given_up import given_up
    from bringup_lint.graph.nodes.questions.ending.late_spins import late_spins
    from bringup_lint.graph.nodes.questions.ending.safe_state import fed_without_condition
    from bringup_lint.graph.nodes.questions.ending.safe_state import publish_after_deactivate
    from bringup_lint.graph.nodes.questions.ending.safe_state import relays
    from bringup_lint.graph.nodes.questions.ending.shut_constructors import shut_constructors
    from bringup_lint.graph.nodes.questions.ending.shut_constructors import spun_after
    from bringup_lint.graph.nodes.questions.ending.stopping import double_shutdown
    from bringup_lint.graph.nodes.questions.ending.stopping import handler_never_runs
    from bringup_lint.graph.nodes.questions.ending.stopping import stop_after_shutdown
    from bringup_lint.graph.nodes.questions.ending.stopping import unhandled_shutdown
    from bringup_lint.graph.nodes.questions.ending.swallowed_failures import swallowed_failures
    from bringup_lint.graph.nodes.questions.ending.unreached_stops import unreached_stops
    from bringup_lint.graph.nodes.questions.ending.unsafe_ends import unsafe_ends
    from bringup_lint.graph.nodes.questions.ending.unsafe_hardware import unsafe_hardware
    from bringup_lint.graph.nodes.questions.ending.unsafe_hardware import unsafe_in_cpp
    from bringup_lint.graph.nodes.questions.ending.unsafe_publishers import unsafe_publishers
    from bringup_lint.graph.nodes.questions.ending.window_spins import window_spins
    from bringup_lint.graph.nodes.questions.files.home_files import home_files
    from bringup_lint.graph.nodes.questions.files.relative_files import relative_files
    from bringup_lint.graph.nodes.questions.files.unreached_servers import unreached_servers
    from bringup_lint.graph.nodes.questions.hardware.hardware_interfaces import blocking_reads
    from bringup_lint.graph.nodes.questions.hardware.hardware_interfaces import zeroed_commands
    from bringup_lint.graph.nodes.questions.hardware.hidden_failures import hidden_failures
    from bringup_lint.graph.nodes.questions.hardware.left_moving import left_moving
    from bringup_lint.graph.nodes.questions.hardware.lost_cameras import lost_cameras
    from bringup_lint.graph.nodes.questions.hardware.lost_transfers import lost_transfers
    from bringup_lint.graph.nodes.questions.hardware.pin_modes import without_pin_mode
    from bringup_lint.graph.nodes.questions.hardware.unchecked_devices import unchecked_devices
    from bringup_lint.graph.nodes.questions.hardware.unplugged_ports import unplugged_ports
    from bringup_lint.graph.nodes.questions.lifecycle.declared_again import declared_again
    from bringup_lint.graph.nodes.questions.lifecycle.inactive_publishers import inactive_publishers
    from bringup_lint.graph.nodes.questions.lifecycle.stuck_switches import stuck_switches
    from bringup_lint.graph.nodes.questions.messages.message_fields import NoField
    from bringup_lint.graph.nodes.questions.messages.message_fields import consequence
    from bringup_lint.graph.nodes.questions.messages.message_fields import converted
    from bringup_lint.graph.nodes.questions.messages.message_fields import given_in_order
    from bringup_lint.graph.nodes.questions.messages.message_fields import is_checked
    from bringup_lint.graph.nodes.questions.messages.message_fields import misplaced_constants
    from bringup_lint.graph.nodes.questions.messages.message_fields import missing_fields
    from bringup_lint.graph.nodes.questions.messages.message_fields import wrong_fields
    from bringup_lint.graph.nodes.questions.messages.message_sequences import used_as_lists
    from bringup_lint.graph.nodes.questions.messages.message_units import wrong_units
    from bringup_lint.graph.nodes.questions.messages.mistaken_handlers import mistaken_handlers
    from bringup_lint.graph.nodes.questions.messages.published_values import wrong_publishes
    from bringup_lint.graph.nodes.questions.messages.quaternion_order import misordered_quaternions
    from bringup_lint.graph.nodes.questions.messages.restamped import restamped
    from bringup_lint.graph.nodes.questions.messages.shell_commands import shell_commands
    from bringup_lint.graph.nodes.questions.messages.unchecked_elements import unchecked_elements
    from bringup_lint.graph.nodes.questions.messages.unchecked_messages import Unchecked
    from bringup_lint.graph.nodes.questions.messages.unchecked_messages import unchecked_messages
    from bringup_lint.graph.nodes.questions.messages.unstamped import unstamped
    from bringup_lint.graph.nodes.questions.messages.wrong_unit import WrongUnit
    from bringup_lint.graph.nodes.questions.parameters.dict_ranges import dict_ranges
    from bringup_lint.graph.nodes.questions.parameters.dict_ranges import range_text
    from bringup_lint.graph.nodes.questions.parameters.heard_parameters import heard_parameters
    from bringup_lint.graph.nodes.questions.parameters.known_unread import is_known_unread
    from bringup_lint.graph.nodes.questions.parameters.misread_parameters import misread_parameters
    from bringup_lint.graph.nodes.questions.parameters.parameter_calls import empty_defaults
    from bringup_lint.graph.nodes.questions.parameters.parameter_calls import untyped_reads
    from bringup_lint.graph.nodes.questions.parameters.unread_in_cpp import unread_in_cpp
    from bringup_lint.graph.nodes.questions.parameters.unread_parameters import unread_parameters
    from bringup_lint.graph.nodes.questions.parameters.unused_in_cpp import unused_in_cpp
    from bringup_lint.graph.nodes.questions.parameters.unused_in_python import unused_in_python
    from bringup_lint.graph.nodes.questions.parameters.unused_parameter import UnusedParameter
    from bringup_lint.graph.nodes.questions.python.abstract_classes import unfinished_classes
    from bringup_lint.graph.nodes.questions.python.call_fit import unfit_calls
    from bringup_lint.graph.nodes.questions.python.class_attributes import class_attributes
    from bringup_lint.graph.nodes.questions.python.early_reads import early_reads
    from bringup_lint.graph.nodes.questions.python.enum_members import enum_members
    from bringup_lint.graph.nodes.questions.python.half_made import half_made
    from bringup_lint.graph.nodes.questions.python.late_attributes import late_attributes
    from bringup_lint.graph.nodes.questions.python.missing_attributes import missing_attributes
    from bringup_lint.graph.nodes.questions.python.missing_attributes import taken_attributes
    from bringup_lint.graph.nodes.questions.python.missing_modules import missing_modules
    from bringup_lint.graph.nodes.questions.python.missing_names import missing_names
    from bringup_lint.graph.nodes.questions.python.missing_qos import without_qos
    from bringup_lint.graph.nodes.questions.python.object_attributes import object_attributes
    from bringup_lint.graph.nodes.questions.python.operators import is_operated
    from bringup_lint.graph.nodes.questions.python.pipes import unread_pipes
    from bringup_lint.graph.nodes.questions.python.plain_attributes import plain_attributes
    from bringup_lint.graph.nodes.questions.python.python_releases import NotThere
    from bringup_lint.graph.nodes.questions.python.python_releases import not_there
    from bringup_lint.graph.nodes.questions.python.python_releases import python_of
    from bringup_lint.graph.nodes.questions.python.python_relocks import python_relocks
    from bringup_lint.graph.nodes.questions.python.rclpy_names import lacking_names
    from bringup_lint.graph.nodes.questions.python.refused_logs import RefusedLog
    from bringup_lint.graph.nodes.questions.python.refused_logs import refused_logs
    from bringup_lint.graph.nodes.questions.python.time_misfits import TimeMisfit
    from bringup_lint.graph.nodes.questions.python.time_misfits import time_misfits
    from bringup_lint.graph.nodes.questions.python.unbound_locals import unbound_locals
    from bringup_lint.graph.nodes.questions.python.undefined_names import undefined_in
    from bringup_lint.graph.nodes.resolved.starting import chain_to
    from bringup_lint.graph.nodes.resolved.starting import is_stopped
    from bringup_lint.graph.nodes.resolved.starting import is_tool
    from bringup_lint.graph.nodes.resolved.starting import runners_of
    from bringup_lint.graph.nodes.resolved.starting import stopped_by
    from bringup_lint.graph.nodes.resolved.starting import watcher
    from bringup_lint.graph.nodes.sources.halting import has_firmware
    from bringup_lint.graph.nodes.sources.motion import is_remote
    from bringup_lint.graph.nodes.sources.motion import moves
    from bringup_lint.graph.nodes.sources.threads import ends_thread
    from bringup_lint.graph.nodes.sources.threads import late_join
    from bringup_lint.graph.nodes.sources.what_ends import end_of
    from bringup_lint.graph.nodes.sources.what_ends import end_of_callbacks
    from bringup_lint.graph.topics.questions.undeclared import asked_in_vain
    from bringup_lint.graph.topics.questions.undeclared import asked_quietly
    from bringup_lint.graph.topics.questions.undeclared import is_called_nowhere
    from bringup_lint.graph.topics.questions.undeclared import switchless
    from bringup_lint.graph.topics.questions.undeclared import unset
    from bringup_lint.model.cpp_source import ComponentEnd
    from bringup_lint.model.cpp_source import Swallowed
    from bringup_lint.model.node_source import Callback
    from bringup_lint.model.node_source import Endpoint
    from bringup_lint.model.node_source import NodeSource
    from bringup_lint.model.node_source import Timer
else:
    __getattr__ = on_demand(globals())

__all__ = [
    "UNTIL_TIMEOUT",
    "Callback",
    "ClockMix",
    "ComponentEnd",
    "Endpoint",
    "NoField",
    "NodeSource",
    "NotThere",
    "RefusedLog",
    "Swallowed",
    "TimeMisfit",
    "Timer",
    "Unchecked",
    "UnfitCallback",
    "UnusedParameter",
    "WrongUnit",
    "asked_in_vain",
    "asked_quietly",
    "awaits_asyncio",
    "blind_waits",
    "blocking_reads",
    "busy_loops",
    "canceled_goals",
    "chain_to",
    "class_attributes",
    "clock_mixes",
    "consequence",
    "converted",
    "cut_answers",
    "deaf_handlers",
    "declared_again",
    "dict_ranges",
    "double_shutdown",
    "early_lookups",
    "early_members",
    "early_reads",
    "early_results",
    "empty_defaults",
    "end_of",
    "end_of_callbacks",
    "ended_containers",
    "endless_answers",
    "endless_rates",
    "endless_threads",
    "ends_thread",
    "enum_members",
    "fed_without_condition",
    "fields_of_futures",
    "format_texts",
    "given_in_order",
    "given_up",
    "guards_commands",
    "half_made",
    "handler_never_runs",
    "has_firmware",
    "heard_parameters",
    "held",
    "hidden_failures",
    "home_files",
    "ignored_cancels",
    "import_edits",
    "inactive_publishers",
    "is_called_nowhere",
    "is_checked",
    "is_known_unread",
    "is_never_filled",
    "is_operated",
    "is_remote",
    "is_stopped",
    "is_tool",
    "lacking_names",
    "late_attributes",
    "late_bound",
    "late_join",
    "late_spins",
    "left_moving",
    "lost_cameras",
    "lost_requests",
    "lost_transfers",
    "making_loops",
    "misordered_quaternions",
    "misplaced_constants",
    "misread_parameters",
    "missing_attributes",
    "missing_fields",
    "missing_modules",
    "missing_names",
    "missing_returns",
    "mistaken_handlers",
    "moves",
    "nested_spins",
    "never_run",
    "not_there",
    "object_attributes",
    "plain_attributes",
    "publish_after_deactivate",
    "python_of",
    "python_relocks",
    "races",
    "range_text",
    "rare_signals",
    "refused_logs",
    "relative_files",
    "relays",
    "relocks",
    "repeated",
    "repeated_branches",
    "restamped",
    "runners_of",
    "sent_in_vain",
    "shell_commands",
    "shut_constructors",
    "spun_after",
    "stale_readings",
    "stale_reads",
    "starved_waits",
    "stop_after_shutdown",
    "stopped_by",
    "stopped_callbacks",
    "stopped_in_cpp",
    "stuck_flags",
    "stuck_switches",
    "swallowed_failures",
    "swap",
    "switchless",
    "taken_attributes",
    "thrown",
    "time_misfits",
    "tried_shutdown",
    "unbound_locals",
    "unchecked_devices",
    "unchecked_elements",
    "unchecked_messages",
    "undefined_in",
    "unfinished_classes",
    "unfit_callbacks",
    "unfit_calls",
    "unhandled_shutdown",
    "unhandled_transforms",
    "unplugged_ports",
    "unreached_servers",
    "unreached_stops",
    "unread_answers",
    "unread_in_cpp",
    "unread_parameters",
    "unread_pipes",
    "unregistered_types",
    "unrun_checks",
    "unsafe_ends",
    "unsafe_hardware",
    "unsafe_in_cpp",
    "unsafe_publishers",
    "unset",
    "unset_members",
    "unstamped",
    "unthrown",
    "untyped_reads",
    "unused_in_cpp",
    "unused_in_python",
    "used_as_lists",
    "valid_node_name",
    "waiting_handlers",
    "waits",
    "watcher",
    "window_spins",
    "without_pin_mode",
    "without_qos",
    "wrong_durations",
    "wrong_fields",
    "wrong_publishes",
    "wrong_units",
    "zero_divisors",
    "zero_fractions",
    "zeroed_commands",
]

_NODE_NAME = regex(r"[A-Za-z_][A-Za-z0-9_]{0,254}\Z")


def valid_node_name(name: str) -> bool:
    """Whether rcl takes a node name (rmw, validate_node_name.c)."""
    return bool(_NODE_NAME.match(name))
