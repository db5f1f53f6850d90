"""Launch arguments that give the nodes the clock of a simulation unless somebody passes false."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.reads import read_in
from bringup_lint.graph.launch.reads import started_without
from bringup_lint.graph.launch.resolve import truth
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.model.launch import DeclareArgument
from bringup_lint.model.launch import LaunchFile
from bringup_lint.model.launch_values import Literal
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.runners.runners import Runners

_NAMES = ("use_sim_time", "use_sim", "sim", "simulation", "use_simulation", "is_sim", "is_simulation", "sim_mode")


class SimulatedByDefault(NamedTuple):
    name: str
    default: Literal
    started: bool
    """A runner starts the file without the argument."""
    omitted: Span | None
    """Where a launch file or a script starts the file without it."""


def simulated_by_default(launch: Launch, runners: Runners) -> Iterator[SimulatedByDefault]:
    """The arguments of launch files for a robot that are true by default, and that set the clock of its nodes."""
    for file in launch.judged:
        if launch.simulated(file) or launch.ends_at_once(file):
            continue
        for name, default in _true_by_default(launch, file):
            starters = runners.launching(file)
            if starters and all(name in {str(given) for given, _ in each.arguments} for each in starters):
                continue
            omitted = next(started_without(launch, file, name), None)
            used = omitted is not None or bool(starters) or not _is_passed(launch, file, name)
            if used and _sets_clock(launch, file, name):
                yield SimulatedByDefault(name, default, bool(starters), omitted)


def _true_by_default(launch: Launch, file: LaunchFile) -> Iterator[tuple[str, Literal]]:
    for action, _ in launch.visited(file):
        if not isinstance(action, DeclareArgument) or not isinstance(action.default, Literal):
            continue
        name = literal_text(action.name)
        if name in _NAMES and truth(action.default) is True:
            yield str(name), action.default


def _sets_clock(launch: Launch, file: LaunchFile, name: str) -> bool:
    """Whether the argument is read where nodes are given the simulated clock."""
    files = launch.expansion(file).files
    return name in read_in(launch, files) and any("use_sim_time" in each.source.text for each in files)


def _is_passed(launch: Launch, file: LaunchFile, name: str) -> bool:
    """Whether another launch file includes this one and passes the argument."""
    return any(
        include.target is file and name in include.arguments
        for expansion in launch.leading_to(file)
        for include in expansion.includes
    )
