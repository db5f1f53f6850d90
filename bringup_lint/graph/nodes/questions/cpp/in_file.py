"""Mistakes of C++ nodes that one file alone shows, those of a file together."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_driver import BlindWait
from bringup_lint.model.cpp_driver import CutAnswer
from bringup_lint.model.cpp_source import EarlyMember
from bringup_lint.model.cpp_source import FormatText
from bringup_lint.model.cpp_source import RepeatedBranch
from bringup_lint.model.cpp_source import UnreadAnswer
from bringup_lint.model.cpp_source import WrongDuration

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes


def wrong_durations(nodes: Nodes) -> Iterator[WrongDuration]:
    """The durations that are much shorter than what is written."""
    for node in nodes.cpp:
        yield from node.durations


def unread_answers(nodes: Nodes) -> Iterator[list[UnreadAnswer]]:
    """The callbacks of services that answer ``false``, those that owe data first."""
    for node in nodes.cpp:
        if node.service_answers:
            yield sorted(node.service_answers, key=lambda each: not each.has_data)


def format_texts(nodes: Nodes) -> Iterator[list[FormatText]]:
    """The texts that log macros take as formats, those from other nodes first."""
    for node in nodes.cpp:
        if node.format_texts:
            yield sorted(node.format_texts, key=lambda each: not each.is_foreign)


def blind_waits(nodes: Nodes) -> Iterator[list[BlindWait]]:
    """The waits for condition variables that look at nothing before."""
    for driver in nodes.drivers:
        if driver.blind_waits:
            yield driver.blind_waits


def early_members(nodes: Nodes) -> Iterator[EarlyMember]:
    """The members that are made of one which is made after them."""
    for node in nodes.cpp:
        yield from node.early_members


def cut_answers(nodes: Nodes) -> Iterator[list[CutAnswer]]:
    """The answers of devices that are taken apart unseen."""
    for driver in nodes.drivers:
        if driver.cut_answers:
            yield driver.cut_answers


def repeated_branches(nodes: Nodes) -> Iterator[RepeatedBranch]:
    """The branches of C++ nodes that never run."""
    for node in nodes.cpp:
        yield from node.repeated_branches
