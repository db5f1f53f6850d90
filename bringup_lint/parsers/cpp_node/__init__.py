"""C++ sources of nodes, read from the syntax tree of tree-sitter; nothing of them is compiled."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.model.cpp_source import CppNode
from bringup_lint.model.parameter_words import LOOSE
from bringup_lint.parsers.cpp_node.busy_spins import busy_spins
from bringup_lint.parsers.cpp_node.canceled import canceled
from bringup_lint.parsers.cpp_node.classes import activation
from bringup_lint.parsers.cpp_node.classes import components
from bringup_lint.parsers.cpp_node.classes import node_classes
from bringup_lint.parsers.cpp_node.classes import node_names
from bringup_lint.parsers.cpp_node.component_ends import component_ends
from bringup_lint.parsers.cpp_node.deaf_loops import deaf_loops
from bringup_lint.parsers.cpp_node.deaf_loops import making_loops
from bringup_lint.parsers.cpp_node.declared_again import declared_again
from bringup_lint.parsers.cpp_node.divisors import divisors
from bringup_lint.parsers.cpp_node.dropped import dropped
from bringup_lint.parsers.cpp_node.durations import durations
from bringup_lint.parsers.cpp_node.early_members import early_members
from bringup_lint.parsers.cpp_node.early_pointers import early_pointers
from bringup_lint.parsers.cpp_node.early_pointers import second_owners
from bringup_lint.parsers.cpp_node.elements import unchecked_elements
from bringup_lint.parsers.cpp_node.endless_answers import ASKS
from bringup_lint.parsers.cpp_node.endless_answers import endless_answers
from bringup_lint.parsers.cpp_node.endpoints import endpoint
from bringup_lint.parsers.cpp_node.endpoints import timer
from bringup_lint.parsers.cpp_node.format_texts import format_texts
from bringup_lint.parsers.cpp_node.given_up import given_up
from bringup_lint.parsers.cpp_node.handles import few_handles
from bringup_lint.parsers.cpp_node.kept import called
from bringup_lint.parsers.cpp_node.kept import kept
from bringup_lint.parsers.cpp_node.kept import sent
from bringup_lint.parsers.cpp_node.lookups import lookups
from bringup_lint.parsers.cpp_node.misread import misread
from bringup_lint.parsers.cpp_node.missing_returns import missing_returns
from bringup_lint.parsers.cpp_node.nested_spins import nested_spins
from bringup_lint.parsers.cpp_node.parameters import declarations
from bringup_lint.parsers.cpp_node.parameters import is_open
from bringup_lint.parsers.cpp_node.parameters import reads
from bringup_lint.parsers.cpp_node.profiles import Profiles
from bringup_lint.parsers.cpp_node.races import races
from bringup_lint.parsers.cpp_node.repeated_branches import repeated_branches
from bringup_lint.parsers.cpp_node.restamped import RESTAMPS
from bringup_lint.parsers.cpp_node.restamped import restamped
from bringup_lint.parsers.cpp_node.service_answers import service_answers
from bringup_lint.parsers.cpp_node.stuck_joins import stuck_joins
from bringup_lint.parsers.cpp_node.swallowed import swallowed
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.parsers.cpp_node.text_limits import TEXT
from bringup_lint.parsers.cpp_node.text_limits import too_much
from bringup_lint.parsers.cpp_node.texts_as_bool import texts_as_bool
from bringup_lint.parsers.cpp_node.threads import late_joins
from bringup_lint.parsers.cpp_node.threads import threads
from bringup_lint.parsers.cpp_node.time_sources import time_members
from bringup_lint.parsers.cpp_node.time_sources import time_uses
from bringup_lint.parsers.cpp_node.unset import unset
from bringup_lint.parsers.cpp_node.unset_members import bare_members
from bringup_lint.parsers.cpp_node.unset_members import unset_members
from bringup_lint.parsers.cpp_node.unstamped import unstamped
from bringup_lint.parsers.cpp_node.values import Names
from bringup_lint.parsers.cpp_node.waits import waits
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

CALLBACKS = 200
"""Callbacks of one file that are looked into."""
_OF_NODES = regex(
    r"c(?<!\wc)reate_(?:publisher|subscription|service|client|server|wall_timer|timer)\b|_parameters?\w{0,64}\s*[<(]"
    r"|N(?<!\wN)ode(?:Status)?\b|L(?<!\wL)ifecycleNode\b|/dev/|RCLCPP_COMPONENTS_REGISTER_NODE|s(?<!\ws)td::thread\b"
    r"|r(?<!\wr)(?:clc_executor_init|eturn_type)\b|C(?<!\wC)allbackReturn\b",
    hints="create_ _parameter Node /dev/ RCLCPP_COMPONENTS_REGISTER_NODE std::thread rclc_executor_init CallbackReturn "
    "return_type",
)
"""Each way begins with a letter, so that the search goes from one of these to the next."""
_ROLES = {"subscription", "timer"}
"""The callbacks of a node that may go on with what it got before."""
_EXECUTORS = regex(
    r"MultiThreadedExecutor|EventsExecutor|create_callback_group|component_container_(?:mt|isolated)",
    hints="MultiThreadedExecutor EventsExecutor create_callback_group component_container_",
)
_OPENING = regex(r"(?i)f?open(?:_?(?:serial|port|device))?\Z|set_?port\Z|VideoCapture\Z|Serial\Z")
_DEVICE = regex(r"/dev/[A-Za-z][\w.+-]*(?:/[\w.:+-]+)*\Z")


def parse(source: Source) -> CppNode:
    """What a file makes, declares and waits for. Never raises; ``problems``: ``too-large``, ``too-deep``."""
    node = CppNode(source)
    if len(source.text) <= TEXT and not _OF_NODES.search(source.text):
        return node
    problem = too_much(source)
    if problem is not None:
        node.problems.append(problem)
        return node
    code = Code(source)
    node.classes = node_classes(code)
    node.components = components(code)
    node.names = node_names(code)
    names = Names(code)
    _read_calls(node, code, names)
    node.declares_others |= bool(LOOSE.search(source.text))
    node.executors = bool(_EXECUTORS.search(source.text))
    node.devices = list(_devices(code))
    node.threads = list(threads(code))
    node.late_joins = list(late_joins(code, node.threads, node.callbacks[:CALLBACKS]))
    if {each.role for each in node.callbacks} >= _ROLES:
        node.kept = kept(code, node.callbacks[:CALLBACKS])
        node.sent = sent(code, node.callbacks[:CALLBACKS])
    if any(each.role == "subscription" for each in node.callbacks):
        node.passed_on = sent(code, node.callbacks[:CALLBACKS], "subscription")
        node.called = called(code, node.callbacks[:CALLBACKS])
        node.kept = node.kept or kept(code, node.callbacks[:CALLBACKS])
    node.lookups = list(lookups(code, node.callbacks[:CALLBACKS]))
    node.waits = list(waits(code, node.callbacks[:CALLBACKS]))
    if any(each in source.text for each in ASKS):
        node.endless_answers = list(endless_answers(code))
    node.nested_spins = list(nested_spins(code, node.callbacks[:CALLBACKS]))
    node.activation = activation(code)
    node.misread = list(misread(code))
    node.missing_returns = list(missing_returns(code))
    node.races = list(races(code, node.callbacks[:CALLBACKS]))
    node.repeated_branches = list(repeated_branches(code))
    node.unset = list(unset(code))
    node.bare_members = list(bare_members(code, node.classes))
    node.unset_members = list(unset_members(code, node.classes, node.callbacks[:CALLBACKS]))
    node.canceled = list(canceled(code, node.callbacks[:CALLBACKS]))
    node.unchecked_elements = list(unchecked_elements(code, node.callbacks[:CALLBACKS]))
    node.divisors = list(divisors(code))
    node.texts_as_bool = list(texts_as_bool(code))
    node.unstamped = list(unstamped(code, names, node.endpoints))
    if RESTAMPS.search(source.text):
        node.restamped = list(restamped(code))
    node.declared_again = list(dict.fromkeys(declared_again(code)))
    node.stuck_joins = list(stuck_joins(code, node.components))
    node.component_ends = list(component_ends(code, node.components))
    node.durations = list(durations(code))
    node.service_answers = list(service_answers(code, node.callbacks[:CALLBACKS]))
    node.format_texts = list(format_texts(code))
    node.swallowed = list(dict.fromkeys(swallowed(code)))
    node.dropped = list(dropped(code))
    node.given_up = list(given_up(code))
    node.early_members = list(early_members(code))
    node.early_pointers = list(dict.fromkeys(early_pointers(code)))
    node.second_owners = list(second_owners(code, node.classes))
    node.time_members = list(time_members(code))
    node.time_uses = list(time_uses(code, node.callbacks[:CALLBACKS]))
    node.few_handles = list(few_handles(code))
    node.making_loops = list(dict.fromkeys(making_loops(code)))
    node.deaf_loops = list(dict.fromkeys(deaf_loops(code)))
    node.busy_spins = list(busy_spins(code))
    return node


def _read_calls(node: CppNode, code: Code, names: Names) -> None:
    profiles = Profiles(code)
    for call in code.calls:
        made = endpoint(code, names, profiles, call)
        if made is not None:
            node.endpoints.append(made[0])
        clocked = timer(code, call)
        if clocked is not None:
            node.timers.append(clocked[0])
        node.callbacks += [each[1] for each in (made, clocked) if each is not None and each[1] is not None]
        node.parameters += declarations(code, call)
        node.reads += reads(code, call)
        node.declares_others |= is_open(code, call)


def _devices(code: Code) -> Iterator[Located]:
    """The paths that a call opens directly."""
    for call in code.calls:
        text = code.literal(call.arguments[0]) if call.arguments and _OPENING.match(call.name) else None
        if text is not None and _DEVICE.match(text):
            yield text
