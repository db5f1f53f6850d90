"""Who runs ``ros2 launch``, with which environment, and every process that comes of it."""

from __future__ import annotations

import re
from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING
from typing import NamedTuple

from bringup_lint.graph.environment.launched import launched_environment
from bringup_lint.graph.launch.expansion import Expansion
from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.systemd.environment import SETUP_FILE
from bringup_lint.graph.systemd.environment import Environment
from bringup_lint.graph.systemd.environment import after_commands
from bringup_lint.graph.systemd.environment import assign_before
from bringup_lint.graph.systemd.environment import process_environment
from bringup_lint.graph.systemd.process import SHELLS
from bringup_lint.graph.systemd.process import Process
from bringup_lint.graph.systemd.process import Ros
from bringup_lint.graph.systemd.process import ros_command
from bringup_lint.graph.systemd.process import unwrapped
from bringup_lint.model.dockerfile import Instruction
from bringup_lint.model.launch import ComposableNode
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import Unknown
from bringup_lint.model.shell import Command
from bringup_lint.parsers.shell import commands
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.model.compose import Service
    from bringup_lint.model.dockerfile import Stage
    from bringup_lint.robot import Robot

_WORD = re.compile(r'"((?:[^"\\]|\\.)*)"')
_EXPANDED = re.compile(r"[$`*?%]")
"""What a shell or systemd puts something in for."""


class Launching(NamedTuple):
    """One command that starts something of ROS, and the environment in which it runs."""

    ros: Ros
    environment: Environment


class Launched(NamedTuple):
    """A process that a launch file starts when nothing else is asked for."""

    node: Started
    environment: Environment
    expansion: Expansion
    """The launch file that was given to ``ros2 launch``, with all that it leads to."""


def of_unit(process: Process, robot: Robot) -> list[Launching]:
    """The ROS programs that a command line of a unit starts."""
    found = [Launching(ros, process_environment(process, robot, step)) for step, ros in process.ros]
    for each in found:
        each.environment.complete &= not process.opaque
    return found


def of_service(service: Service, stage: Stage | None, base: Environment) -> list[Launching]:
    """Those of a compose service; without a command of its own it runs what its image says."""
    words = [*service.entrypoint, *service.command]
    if not service.command and stage is not None:
        start = stage.last("CMD")
        words += _words(start) if start is not None else []
    return _following(_inside(tuple(words)), base)


def of_script(text: Located, base: Environment) -> list[Launching]:
    """Those of a shell script."""
    return _following(commands(text), base)


def _following(found: list[Command], base: Environment) -> list[Launching]:
    result = []
    for at, command in enumerate(found):
        ros = ros_command(command)
        if ros is not None:
            inside = after_commands(base, found[:at], lambda path: bool(SETUP_FILE.search(path)))
            assign_before(inside, command)
            result.append(Launching(ros, inside))
    return result


def _inside(words: tuple[Located, ...]) -> list[Command]:
    """The commands of a container: its own words, and the text behind ``bash -c``."""
    found = [Command(words)]
    plain = unwrapped(words)
    names = [word.rpartition("/")[2] for word in plain]
    for at, name in enumerate(names):
        if name in SHELLS and at + 2 < len(plain) and re.fullmatch(r"-\w*c", plain[at + 1]):
            return commands(plain[at + 2])
    if names[:1] != ["ros2"] and "ros2" in names:
        found.append(Command(plain[names.index("ros2") :]))
    return found


def _words(instruction: Instruction) -> list[Located]:
    """The words of CMD; those of the shell form as ``sh -c`` gets them."""
    if instruction.exec_form is None:
        value = instruction.value
        return [Located("sh", value.span), Located("-c", value.span), value]
    return [instruction.value.part(word.start(1), word.end(1)) for word in _WORD.finditer(instruction.value)]


def expansion_of(ros: Ros, launch: Launch) -> Expansion | None:
    """What ``ros2 launch`` leads to with its arguments; None when its file is not in the tree."""
    file = launch.named(ros.package, ros.target) if ros.kind == "launch" else None
    if file is None:
        return None
    arguments = {}
    for word in ros.arguments:
        name, colon, text = word.partition(":=")
        value = word.part(len(name) + 2, len(word))
        if colon:
            arguments[name] = Unknown("shell", word.span) if _EXPANDED.search(text) else Literal(value, value.span)
    return launch.expand(file, arguments) if arguments else launch.expansion(file)


def launched(expansion: Expansion, base: Environment) -> Iterator[Launched]:
    """Every process of a launch file that surely starts; components live in the process of their container."""
    for node in expansion.nodes:
        if node.by_default is True and not isinstance(node.action, ComposableNode):
            yield Launched(node, launched_environment(base, node) if node.env or node.own_env else base, expansion)


def alike(found: Iterable[Launched], names: re.Pattern[str]) -> dict[tuple, list[Launched]]:
    """The processes in groups that see the same variables, as far as ``names`` goes."""
    groups: dict[tuple, list[Launched]] = {}
    for each in found:
        groups.setdefault(view(each.environment, names), []).append(each)
    return groups


def view(environment: Environment, names: re.Pattern[str]) -> tuple:
    """What there is to see of an environment, as far as ``names`` goes: equal for equal texts from equal places."""
    chains = ((name, chain) for name, chain in environment.chains.items() if names.fullmatch(name))
    places = ((name, tuple((each.text, each.value.span) for each in chain)) for name, chain in chains)
    return (environment.complete, *sorted(places, key=lambda pair: pair[0]))
