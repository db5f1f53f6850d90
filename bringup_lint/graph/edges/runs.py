"""What units start: wrapper scripts of the tree, launch files, ROS nodes, other programs."""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.commands.wrappers import unwrapped
from bringup_lint.graph.edges.systemd import own_units
from bringup_lint.graph.file_nodes import file_node
from bringup_lint.graph.file_nodes import file_place
from bringup_lint.graph.file_nodes import is_plain
from bringup_lint.graph.graph import Edge
from bringup_lint.graph.graph import Node
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.commands.command_line import Step
    from bringup_lint.graph.commands.ros_command import Ros
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.systemd.process import Process
    from bringup_lint.graph.systemd.units import Units

_INTERPRETER = regex(r"python[0-9.]*|perl|node|ruby")
_SCRIPT = regex(r"/.*\.(?:py|pl|js|rb)")


def run_edges(tree: Tree, units: Units, launch: Callable[[], Launch]) -> Iterator[Edge]:
    """``runs`` from units, and from the scripts that they run."""
    for unit, node in own_units(units):
        if unit.type == "service":
            for process in units.processes(unit):
                yield from _of_process(node, process, tree, launch)


def script_places(tree: Tree, units: Units) -> Iterator[tuple[Node, Span]]:
    for unit in units.services:
        for process in units.processes(unit):
            for step in process.steps:
                if step.script is not None:
                    yield file_node("script", step.script), file_place(step.script)
            found = _script(_program(process), tree) if process.key == "ExecStart" else None
            if found is not None:
                yield file_node("script", found), file_place(found)


def _of_process(unit: Node, process: Process, tree: Tree, launch: Callable[[], Launch]) -> Iterator[Edge]:
    followed = False
    last: dict[int, Step] = {}
    for step in process.steps:
        caller = last.get(step.depth - 1)
        last[step.depth] = step
        if step.script is not None and caller is not None and step.script is not caller.script:
            yield _run(unit, process, caller, file_node("script", step.script), process.line.span)
            followed = True
    for step, ros in process.ros:
        started = started_node(ros, launch)
        if started is not None:
            yield _run(unit, process, step, started, ros.where.span)
            followed = True
    program = _program(process)
    if process.key == "ExecStart" and not followed and not process.shell and is_plain(program):
        found = _script(program, tree)
        target = file_node("script", found) if found else Node("program", str(program))
        yield Edge("runs", unit, target, program.span, "ExecStart=")


def _program(process: Process) -> Located:
    """What is run, interpreters left out."""
    words = unwrapped(process.argv) or process.argv
    if _INTERPRETER.fullmatch(words[0].rpartition("/")[2]) and len(words) > 1 and "/" in words[1]:
        return words[1]
    return words[0]


def _script(program: Located, tree: Tree) -> Source | None:
    """The program in the tree, if it is a script: nothing is learnt from reading others."""
    return tree.find(program) if _SCRIPT.fullmatch(program) and is_plain(program) else None


def _run(unit: Node, process: Process, step: Step, target: Node, where: Span) -> Edge:
    """From the script that holds the command, else from the unit."""
    if step.script is None:
        return Edge("runs", unit, target, where, f"{process.key}=")
    words = step.command.words
    return Edge("runs", file_node("script", step.script), target, words[0].span if words else where, "command")


def started_node(ros: Ros, launch: Callable[[], Launch]) -> Node | None:
    """What ``ros2 launch``, ``ros2 run`` or an installed executable starts, when its name is known."""
    if ros.target is None or ros.kind == "cli" or not is_plain(ros.target) or not is_plain(ros.package or ""):
        return None
    if ros.kind == "launch":
        file = launch().named(ros.package, ros.target)
        if file is not None:
            return file_node("launch-file", file.source)
        return Node("launch-file", f"{ros.package}/{ros.target}" if ros.package else str(ros.target))
    if ros.kind == "run":
        return Node("ros-node", f"{ros.package}/{ros.target}") if ros.package else None
    return Node("ros-node", str(ros.target))
