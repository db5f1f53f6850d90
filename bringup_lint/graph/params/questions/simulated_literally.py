"""Launch files that give the clock of a simulation to nodes in any case, in a tree that simulates nothing."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.facts.ros import simulation
from bringup_lint.graph.launch.resolve import truth
from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.params.questions.time import waits_for_time
from bringup_lint.graph.workspace import place
from bringup_lint.model.launch_values import DictValue
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import TypedValue
from bringup_lint.model.launch_values import Value
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.launch.expansion import Included
    from bringup_lint.graph.launch.launch import Launch

_NAME = "use_sim_time"
_SIMULATION = regex(
    rf"{simulation.TOLD}|ignition|unity"
    r"|\bbag\s+play|rosbag|/clock\b|(?:^|[^a-z])sim(?:[^a-z_]|$)|_sim(?![a-z_])|(?<![a-z_])sim_|\bhil\b|in-the-loop",
    re.I,
)
_WRITTEN_FALSE = regex(r"use_sim_time['\"]?\s*:\s*(?:false|no|off)\b", re.I, hints="use_sim_time")
_PAGES = (".md", ".rst", ".txt")
_MOST = 200_000
"""Characters of a page that are looked at."""


class Literally(NamedTuple):
    where: Span
    is_waiting: bool
    """A node gets it that does nothing as long as its time is zero."""
    label: str
    """What gets the clock."""


def simulates_nothing(files: Files) -> bool:
    """Whether nothing of a tree is about a simulation or a recording: no file, no name of one, no page."""
    tree = files.tree
    if any(map(_SIMULATION.search, tree.paths)) or files.mentions(_SIMULATION):
        return False
    pages = (path for path in tree.paths if path.endswith(_PAGES))
    return not any(_SIMULATION.search(tree.head(path, _MOST)) for path in pages)


def simulated_literally(launch: Launch, files: Files) -> Iterator[Literally]:
    """The first of each place that gives the clock of a simulation, whatever the arguments are."""
    found: dict[tuple[str, int], Literally] = {}
    defaults: set[tuple[str, int]] = set()
    for expansion in launch.entries:
        if launch.simulated(expansion.entry):
            continue
        values = (declared.action.default for declared in expansion.declared)
        defaults |= {_key(value.span) for value in values if value is not None}
        for node in expansion.nodes:
            _add(found, _of_node(node, files))
        for include in expansion.includes:
            _add(found, _of_include(include))
    if found and simulates_nothing(files):
        yield from (each for key, each in found.items() if key not in defaults and each.where.source.judged)


def _add(found: dict[tuple[str, int], Literally], new: Literally | None) -> None:
    if new is None:
        return
    key = _key(new.where)
    old = found.setdefault(key, new)
    if new.is_waiting and not old.is_waiting:
        found[key] = new


def _key(where: Span) -> tuple[str, int]:
    return (where.source.name, where.start)


def _of_node(node: Started, files: Files) -> Literally | None:
    if node.conditions or node.by_default is not True or not node.is_node:
        return None
    for source in reversed(node.parameters):
        if not isinstance(source, DictValue):
            if files.mentions(_WRITTEN_FALSE):
                return None
            continue
        value = source.get(_NAME)
        if value is not None:
            waits = waits_for_time(literal_text(node.package) or "")
            where = _true(value)
            return Literally(where, waits, node.label()) if where is not None else None
    return None


def _of_include(include: Included) -> Literally | None:
    """An include of a file that is not in the tree; what a file of the tree does with the argument is seen there."""
    value = include.arguments.get(_NAME)
    target = place(include.file)
    if value is None or include.conditions or include.target is not None or target is None:
        return None
    where = _true(value)
    waits = waits_for_time(target.package)
    return Literally(where, waits, target.package) if where is not None else None


def _true(value: Value) -> Span | None:
    inner = value.value if isinstance(value, TypedValue) else value
    return inner.span if isinstance(inner, Literal) and truth(inner) is True else None
