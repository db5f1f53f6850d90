"""Velocity commands that a node goes on with although no new one comes."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.pin_libraries import PIN_LIBRARIES
from bringup_lint.facts.ros.self_stopping import SELF_STOPPING
from bringup_lint.graph.nodes.questions.commands.sent_anyway import is_sent_anyway
from bringup_lint.graph.nodes.sources.age import COMMENTS
from bringup_lint.graph.nodes.sources.age import looks_at_age
from bringup_lint.graph.nodes.sources.age import looks_at_time
from bringup_lint.graph.nodes.sources.callback_code import reached
from bringup_lint.graph.nodes.sources.halting import firmware_looks_at_time
from bringup_lint.graph.nodes.sources.kept_commands import held_over
from bringup_lint.graph.nodes.sources.kept_commands import loops
from bringup_lint.graph.nodes.sources.motion import is_aimed
from bringup_lint.graph.nodes.sources.motion import is_for_motors
from bringup_lint.graph.nodes.sources.motion import is_motor_command
from bringup_lint.graph.nodes.sources.motion import moves
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import body_of
from bringup_lint.graph.nodes.sources.with_header import with_header
from bringup_lint.model.node_source import Endpoint
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.python import walk
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.model.cpp_source import CppNode
    from bringup_lint.model.node_source import Callback
    from bringup_lint.model.node_source import NodeSource
    from bringup_lint.source import Source

_TYPES = frozenset({"Twist", "TwistStamped", "AckermannDrive", "AckermannDriveStamped"})
_JOYSTICKS = regex(r"/Joy(?!_?(?:Feedback|Trajectory)|nt)\w*\Z")
_AXES = regex(r"(?:axes|(?:left|right)_?(?:stick_?)?[xy](?:_axis)?|(?:l|r)(?:stick|joy)_?[xy])\Z")
"""The types of messages of joysticks, and their fields that hold axes."""
_SENDS = regex(
    r"(?i)(?:publish|write|send|set_?(?:motor|speed|velocity|pwm|wheel)\w*|drive"
    r"|(?:send|write)_?(?:control|command|cmd|velocit|speed|motor|drive|twist|frame)\w*)\Z"
)
_NUMBERS = frozenset({"Float64MultiArray", "Float32MultiArray"})
_DRIVES = regex(r"(?i)motor|wheel|vtarget|throttle|thrust|pwm")
_WRITES = regex(r"stop|halt|brake|set_|write|send|drive|motor|thr[ou]|pwm|speed|output|move|apply", re.I)
"""What a call is named that may end a motion."""
_REPORTS = regex(r"(?i)odom|state|status|feedback|metric|debug|diagnos|monitor")


_PYTHON_BUS = regex(
    rf"^[ \t]*(?:import|from)[ \t]+(?P<bus>{'|'.join(PIN_LIBRARIES)})\b",
    re.M,
)
_CPP_BUS = regex(
    r"(?P<bus>/dev/i2c-\d+|/sys/class/(?:pwm|gpio)\b|linux/i2c-dev\.h|wiringPi\.h|pigpio\w*\.h|lgpio\.h|gpiod\.h"
    r"|wiringPiI2C\.h)"
)
_I2C = regex(r"/dev/i2c-\d+")
"""Pins, and buses whose chips keep what was written last."""


_PYTHON_PORT = regex(r"^[ \t]*(?:import|from)[ \t]+(?P<module>serial|can)\b", re.M)
_CPP_PORT = regex(
    r"termios\.h|serial/serial\.h|\blibserial\b|\b[Ss]erial_?[Pp]ort\b|(?P<can>linux/can\.h|\b[Ss]ocket_?[Cc][Aa][Nn]\b)",
    hints="termios.h serial/serial.h libserial erial linux/can.h ocket",
)
_PORTS = {"serial": "a serial port", "can": "a CAN bus"}
_CPP_WRITES = regex(r"(?i)(?:write|send)\w{0,40}\Z")


_GUARD = regex(
    r"(?:cmd|command|vel(?:ocity)?|twist|msg|message)_?\w{0,20}time_?out|time_?out_?(?:cmd|command|vel|twist)|watch_?dog"
    r"|last_?(?:cmd|command|vel(?:ocity)?|twist|msg|message)\w{0,20}(?:time|stamp)"
    r"|(?:time|stamp|since)\w{0,10}last_?(?:cmd|command|vel|twist|msg|message)",
    re.I,
)
"""The names of what ends a motion when commands fail to come."""


class Repeated(NamedTuple):
    """A timer that sends what a subscription kept, however old that is."""

    source: Source
    subscription: Endpoint
    kept: str
    """The member that holds the command."""
    timer: str
    """The callback of the timer."""
    where: Span
    sender: Span | None = None
    """The call that sends it, where it is known."""


def repeated(nodes: Nodes) -> Iterator[Repeated]:
    """The commands that are sent again and again, in sources that look at no time."""
    for file in nodes.robot_sources:
        fed = [(node, found) for node in file.classes if node.is_node is True and (found := _fed(node))]
        files = nodes.imported(file) if fed else None
        if files is not None:
            for node, endpoints in fed:
                yield from _in_class(nodes, file, node, endpoints, files)
    for source in nodes.cpp:
        yield from _in_cpp(nodes, source)


def _is_command(endpoint: Endpoint) -> bool:
    kind = (endpoint.type or "").rpartition("/")[2]
    if endpoint.role != "subscription" or kind not in _TYPES:
        return False
    return moves(endpoint) or ("vel" in str(endpoint.name or "") and not is_aimed(endpoint))


def ignores_time(nodes: Nodes, file: NodeSource) -> bool:
    files = nodes.imported(file)
    return files is not None and not any(looks_at_time(each.source) for each in files)


def _fed(node: NodeClass) -> list[Endpoint]:
    """The endpoints by which a class gets commands."""
    return [each for each in node.endpoints if is_held(each) or _is_joystick(node, each)]


def _in_class(
    nodes: Nodes, file: NodeSource, node: NodeClass, endpoints: list[Endpoint], files: list[NodeSource]
) -> Iterator[Repeated]:
    syntax = nodes.syntax(file)
    ignores = not any(looks_at_time(each.source) for each in files)
    for endpoint in endpoints:
        for loop in loops(syntax, node):
            senders = [each for each in loop.code if isinstance(each, ast.Call) and _sends(each, node)]
            names = sorted(held_over(syntax, node, endpoint.callback, loop)) if senders else []
            found = ((name, sender) for name in names for sender in senders)
            for name, sender in found:
                if ignores or is_sent_anyway(syntax, files, node, loop, name, sender):
                    where = file.span_of(sender)
                    yield Repeated(file.source, endpoint, f"self.{name}", f"{loop.name}()", loop.span, where)
                    break


def _is_joystick(node: NodeClass, endpoint: Endpoint) -> bool:
    """Whether a callback takes the axes of a joystick, which sends nothing any more when it drops out."""
    method = node.methods.get(endpoint.callback or "") if _JOYSTICKS.search(endpoint.type or "") else None
    return method is not None and any(
        isinstance(each, ast.Attribute) and _AXES.match(each.attr) for each in walk(method.node)
    )


def _sends(call: ast.Call, node: NodeClass) -> bool:
    """Whether a call writes to hardware, or publishes what moves something."""
    if not isinstance(call.func, ast.Attribute) or not _SENDS.match(call.func.attr):
        return False
    if call.func.attr != "publish":
        return call.func.attr not in node.methods
    kept = written(call.func.value)
    return any(each.attribute == kept and is_motion(each) for each in node.all_endpoints)


def is_motion(endpoint: Endpoint) -> bool:
    if endpoint.role != "publisher" or _REPORTS.search(str(endpoint.name or "")):
        return False
    kind = (endpoint.type or "").rpartition("/")[2]
    return (
        moves(endpoint) or kind in _TYPES or is_for_motors(endpoint) or bool(_DRIVES.search(str(endpoint.name or "")))
    )


def _in_cpp(nodes: Nodes, source: CppNode) -> Iterator[Repeated]:
    commands = [each for each in source.endpoints if is_held(each)]
    if not commands or not source.kept or not source.sent or not _moves_something(source):
        return
    if looks_at_age(with_header(nodes, source.source)):
        return
    for endpoint in commands:
        held = next((names for at, names in source.kept.items() if _is_within(at, endpoint.span)), frozenset())
        for each in source.callbacks:
            words = source.sent.get(each.span.start, frozenset()) if each.role == "timer" else frozenset()
            for name in sorted(held & words)[:1]:
                place = next((timer.span for timer in source.timers if _is_within(each.span.start, timer.span)), None)
                timer = f"{each.name}()" if each.name is not None else "The timer"
                yield Repeated(source.source, endpoint, name, timer, place or endpoint.span)


def _is_within(at: int, span: Span) -> bool:
    return span.start <= at < span.end


def _moves_something(source: CppNode) -> bool:
    """Whether a file publishes what moves something, or publishes nothing and so writes to hardware."""
    publishers = [each for each in source.endpoints if each.role == "publisher"]
    return not publishers or any(is_motion(each) or _is_command_topic(each) for each in publishers)


def _is_command_topic(endpoint: Endpoint) -> bool:
    """Whether numbers are published under the name of a command, as those of a gait that is walked on with."""
    kind = (endpoint.type or "").rpartition("/")[2]
    return kind in _NUMBERS and (endpoint.name or "").rpartition("/")[2] in ("command", "commands", "cmd")


def guards_commands(text: str) -> bool:
    """Whether a source looks after the age of the commands that it gets, by the names in its code."""
    return _GUARD.search(COMMENTS.sub("", text)) is not None


class Held(NamedTuple):
    """A subscription that drives motors over a bus which keeps the last value."""

    source: Source
    subscription: Endpoint
    bus: str
    """The bus or the library that writes to it: ``/dev/i2c-1``, ``the I2C bus``, ``smbus``."""
    writer: Span | None = None
    """The first statement of the callback that uses the message, where it is known."""
    is_board: bool = False
    """Something at the other end drives the motors, which may stop them by itself."""


def held(nodes: Nodes) -> Iterator[Held]:
    """Nodes that take velocities to pins or to a bus without a controller of its own, and look at no time."""
    for file in nodes.robot_sources:
        if not any(
            is_held(each) for each in (*file.strays, *(each for node in file.classes for each in node.endpoints))
        ):
            continue
        bus = driven_bus(nodes, file)
        if any(looks_at_time(each.source) for each in nodes.imported(file) or ()):
            continue
        if bus is None:
            yield from _sent_to_board(nodes, file)
            continue
        yield from (Held(file.source, each, bus, _writer(file, each)) for each in file.strays if is_held(each))
        for node in file.classes:
            if node.is_node is True and not _ends_in_loop(nodes, file, node):
                yield from (
                    Held(file.source, each, bus, _writer(file, each)) for each in node.endpoints if is_held(each)
                )
    for source in nodes.cpp:
        yield from _held_in_cpp(nodes, source)


def _sent_to_board(nodes: Nodes, file: NodeSource) -> Iterator[Held]:
    """The velocities that only their own callback writes to a serial port or a CAN bus, where nothing in the tree says
    that the board at its other end stops by itself."""
    port = _PYTHON_PORT.search(COMMENTS.sub("", file.source.text))
    if port is None or boards_stop(nodes, file.source.text):
        return
    for node in file.classes:
        if node.is_node is True and not _ends_in_loop(nodes, file, node):
            for each in node.endpoints:
                method = node.methods.get(each.callback or "")
                if is_held(each) and method is not None and _writes(nodes.syntax(file), node, method.node):
                    yield Held(file.source, each, _PORTS[port["module"]], _writer(file, each), True)


def _writes(syntax: Syntax, node: NodeClass, function: ast.AST) -> bool:
    """Whether a callback writes to the port by itself: ``self.port.write(...)``."""
    calls = (each for each in reached(syntax, body_of(function), node) if isinstance(each, ast.Call))
    return any(isinstance(each.func, ast.Attribute) and each.func.attr in ("write", "send") for each in calls)


def _held_in_cpp(nodes: Nodes, source: CppNode) -> Iterator[Held]:
    commands = [each for each in source.endpoints if is_held(each)]
    if not commands:
        return
    text = with_header(nodes, source.source)
    bus = bus_in_cpp(text) if not source.sent else None
    if bus is not None and not looks_at_age(text):
        yield from (Held(source.source, each, bus) for each in commands)
    elif bus is None:
        yield from _sent_to_board_in_cpp(nodes, source, commands, text)


def _sent_to_board_in_cpp(nodes: Nodes, source: CppNode, commands: list[Endpoint], text: str) -> Iterator[Held]:
    port = _CPP_PORT.search(COMMENTS.sub("", text)) or _CPP_PORT.search(text)
    if port is None or looks_at_age(text) or boards_stop(nodes, text):
        return
    timers = [each for each in source.callbacks if each.role == "timer"]
    if len(timers) != len(source.timers) or any(_may_stop(source, each) for each in timers):
        return
    for each in commands:
        called = next((names for at, names in source.called.items() if _is_within(at, each.span)), frozenset())
        if any(_CPP_WRITES.match(name) for name in called) and "publish" not in called:
            yield Held(source.source, each, _PORTS["can" if port["can"] else "serial"], None, True)


def _may_stop(source: CppNode, timer: Callback) -> bool:
    """Whether a timer writes to the hardware, too."""
    called = source.called.get(timer.span.start)
    return called is None or any(_WRITES.search(name) for name in called if not name.startswith("set__"))


def boards_stop(nodes: Nodes, text: str) -> bool:
    """Whether a board is known to stop without commands, or firmware of the tree looks at a time."""
    return bool(SELF_STOPPING.search(text)) or firmware_looks_at_time(nodes)


def driven_bus(nodes: Nodes, file: NodeSource) -> str | None:
    """The bus or library for pins that a Python source, or one of the workspace that it imports, writes to."""
    texts = (each.source.text for each in nodes.imported(file) or ())
    return next(filter(None, (_bus(text, _PYTHON_BUS) for text in texts)), None)


def bus_in_cpp(text: str) -> str | None:
    """The bus or library for pins that a C++ source writes to."""
    return _bus(text, _CPP_BUS)


def _writer(file: NodeSource, endpoint: Endpoint) -> Span | None:
    functions = (each for each in file.nodes if isinstance(each, ast.FunctionDef))
    named = [each for each in functions if each.name == endpoint.callback]
    if len(named) != 1 or not named[0].args.args:
        return None
    message = named[0].args.args[-1].arg
    for statement in named[0].body:
        if any(isinstance(each, ast.Name) and each.id == message for each in walk(statement)):
            return file.span_of(statement)
    return None


def _ends_in_loop(nodes: Nodes, file: NodeSource, node: NodeClass) -> bool:
    """Whether a timer or thread of a node writes to the hardware, too, and so may stop it."""
    if len(node.all_timers) != len(node.timers):
        return True
    called = (each for loop in loops(nodes.syntax(file), node) for each in loop.code if isinstance(each, ast.Call))
    return any(_WRITES.search(written(each.func)) for each in called)


def is_held(endpoint: Endpoint) -> bool:
    """Whether what comes in is a velocity, bare numbers included: motors keep those that were written last."""
    if _is_command(endpoint) or is_motor_command(endpoint):
        return True
    return endpoint.role == "subscription" and moves(endpoint)


def _bus(text: str, pattern: re.Pattern[str]) -> str | None:
    found = pattern.search(COMMENTS.sub("", text) if pattern is _PYTHON_BUS else text)
    if found is None or not found["bus"].endswith(".h"):
        return found["bus"] if found is not None else None
    device = _I2C.search(COMMENTS.sub("", text))
    if device is not None:
        return device[0]
    return "the I2C bus" if "i2c" in found["bus"].lower() else found["bus"].removesuffix(".h")
