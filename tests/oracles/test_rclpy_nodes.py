"""What the rules on node sources say, against real nodes of rclpy that run, are stopped, and publish or not."""

from __future__ import annotations

import importlib.util
import random
import signal
import textwrap
from pathlib import Path

import pytest

from bringup_lint.api.nodes import valid_node_name
from bringup_lint.parsers.python_node import parse
from bringup_lint.parsers.python_node.qos import PRESET_MEMBERS
from bringup_lint.parsers.python_node.qos import PRESETS
from bringup_lint.source import Source
from tests.lint import lint
from tests.oracles.stopped_node import READY
from tests.oracles.stopped_node import TOPIC
from tests.oracles.stopped_node import Observer
from tests.oracles.stopped_node import Stopped
from tests.oracles.stopped_node import observer

pytestmark = pytest.mark.skipif(importlib.util.find_spec("rclpy") is None, reason="needs ros-jazzy-rclpy")

HEAD = f"""\
import atexit
import signal
import sys
import time

import rclpy
from rcl_interfaces.msg import FloatingPointRange
from rclpy.executors import ExternalShutdownException
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from rclpy.signals import SignalHandlerOptions


class Wheel(Node):
    def __init__(self):
        super().__init__('wheel')
        self.pub = self.create_publisher(FloatingPointRange, '{TOPIC}', 10)
        @constructor

    def tick(self):
        self.ticks = True

    def stop(self):
        self.pub.publish(FloatingPointRange())

@methods

def ready(node):
    while node.pub.get_subscription_count() == 0:
        time.sleep(0.02)
    print('{READY}', flush=True)


def main():
"""
TIMER = "self.create_timer(0.2, self.tick)"
DEFAULT = "rclpy.init()"
OWN = "rclpy.init(signal_handler_options=SignalHandlerOptions.NO)"
INTERRUPT = "signal.signal(signal.SIGTERM, signal.default_int_handler)"
ONE = "KeyboardInterrupt"
BOTH = "(KeyboardInterrupt, ExternalShutdownException)"


def source(
    init: str = DEFAULT,
    before: str = "",
    spin: str = "rclpy.spin(node)",
    *,
    caught: str = "",
    handler: str = "pass",
    last: str = "",
    constructor: str = "pass",
    methods: str = "",
) -> str:
    lines = [init, "node = Wheel()", "ready(node)", *before.splitlines()]
    if caught or last:
        lines += ["try:", textwrap.indent(spin, "    ")]
        lines += [f"except {caught}:", textwrap.indent(handler, "    ")] if caught else []
        lines += ["finally:", textwrap.indent(last, "    ")] if last else []
    else:
        lines += spin.splitlines()
    head = HEAD.replace("@constructor", constructor).replace("@methods\n", textwrap.indent(methods, "    "))
    return head + textwrap.indent("\n".join(lines), "    ") + "\n\n\nmain()\n"


EXECUTOR = "executor = MultiThreadedExecutor()\nexecutor.add_node(node)\nexecutor.spin()"
LOOP = "while rclpy.ok():\n    rclpy.spin_once(node, timeout_sec=0.1)"
HANDLER = "signal.signal(signal.SIGTERM, lambda *_: (node.stop(), time.sleep(0.2), sys.exit(0)))"
OVERRIDE = "def destroy_node(self):\n    self.stop()\n    super().destroy_node()\n\n"
GOODBYE = "node.stop()\ntime.sleep(0.2)\nnode.destroy_node()\nrclpy.try_shutdown()"

SOURCES = {
    "nothing": source(),
    "one": source(caught=ONE),
    "both": source(caught=BOTH),
    "shutdown": source(caught=BOTH, last="rclpy.shutdown()"),
    "shutdown-behind": source(caught=BOTH, handler="pass\nrclpy.shutdown()"),
    "shutdown-asked": source(caught=BOTH, last="if rclpy.ok():\n    rclpy.shutdown()"),
    "shutdown-tried": source(caught=BOTH, last="rclpy.try_shutdown()"),
    "threads-shutdown": source(spin=EXECUTOR, caught=BOTH, last="rclpy.shutdown()"),
    "threads-one": source(spin=EXECUTOR, caught=ONE),
    "loop-one": source(spin=LOOP, caught=ONE),
    "stop": source(caught=BOTH, last="node.stop()\nrclpy.try_shutdown()"),
    "stop-asked": source(caught=BOTH, last="if rclpy.ok():\n    node.stop()\nrclpy.try_shutdown()"),
    "stop-in-handler": source(caught=BOTH, handler="node.stop()"),
    "stop-in-destroy": source(caught=BOTH, last="node.destroy_node()", methods=OVERRIDE),
    "stop-at-exit": source(before="atexit.register(node.stop)", caught=BOTH),
    "stop-on-shutdown": source(
        constructor="self.context.on_shutdown(self.stop)", caught=BOTH, last="rclpy.try_shutdown()"
    ),
    "stop-behind-loop": source(spin=LOOP, caught=BOTH, last="node.stop()"),
    "pattern": source(OWN, INTERRUPT, caught=ONE, last=GOODBYE, constructor=TIMER),
    "pattern-without-timer": source(OWN, INTERRUPT, caught=ONE, last=GOODBYE),
    "pattern-without-handler": source(OWN, caught=ONE, last=GOODBYE, constructor=TIMER),
    "handler": source(before=HANDLER, constructor=TIMER),
    "handler-without-timer": source(before=HANDLER),
    "handler-in-loop": source(before=HANDLER, spin=LOOP),
}


def ids(text: str, folder: Path) -> set[str]:
    """The rules of the family that find something in a source."""
    (folder / "wheel").mkdir(exist_ok=True)
    (folder / "wheel/wheel.py").write_text(text)
    run = lint("--select", "node", "--min-severity", "info", "--output-format", "concise", ".", cwd=folder)
    assert run.code in (0, 1), run.stderr
    lines = [line for line in run.stdout.splitlines() if "[node/" in line]
    found = {line.partition("[node/")[2].partition("]")[0] for line in lines}
    told = any("Ctrl-C ends in 'rcl_shutdown already called'" in line for line in lines)
    return found | ({"shutdown-double"} if told else set())


CODES = {"shutdown": 1, "shutdown-tried": 0}
"""Exit codes before and after the fix of ``node/shutdown-double``, which is unsafe because they differ."""
SIGNALS = (signal.SIGTERM, signal.SIGINT)
AT_ONCE = 8
"""Processes that run side by side."""
TRIES = 3
"""rclpy handles signals in a thread of its own, so a node may need several tries to do what it mostly does."""


def run(names: list[str], folder: Path, watching: Observer, turn: int) -> dict[str, list[Stopped]]:
    """What becomes of the sources at SIGTERM and at SIGINT."""
    tries = []
    for name in names:
        for number in SIGNALS:
            topic = f"{TOPIC}_{len(tries)}_{turn}"
            path = folder / f"{topic}.py"
            path.write_text(SOURCES[name].replace(f"'{TOPIC}'", f"'{topic}'"))
            tries.append((path, topic, number))
    answers = [each for at in range(0, len(tries), AT_ONCE) for each in watching.stop(tries[at : at + AT_ONCE])]
    return {name: answers[2 * at : 2 * at + 2] for at, name in enumerate(names)}


def agree(name: str, said: set[str], term: Stopped, interrupt: Stopped) -> str:
    """What of the rules' words is not what happened; empty when all of it is."""
    text = SOURCES[name]
    wrong = []
    if ("shutdown-signal-handler-starved" in said) != (term.code is None):
        wrong.append("ignores SIGTERM" if term.code is None else "does not ignore SIGTERM")
    if "shutdown-only-keyboardinterrupt" in said and "ExternalShutdownException" not in term.output:
        wrong.append("SIGTERM raises nothing")
    passed = term.output.rstrip().endswith("ExternalShutdownException")
    if "except " in text and passed and "shutdown-only-keyboardinterrupt" not in said:
        wrong.append("SIGTERM passes the except")
    twice = ["rcl_shutdown already called" in each.output for each in (term, interrupt)]
    if "shutdown-double" in said and not any(twice):
        wrong.append("shuts down once")
    if "shutdown-double" not in said and twice[0]:
        wrong.append("shuts down twice")
    if CODES.get(name, term.code) != term.code:
        wrong.append(f"ends with {term.code}")
    late = "shutdown-publish-after-context" in said
    if late and term.received:
        wrong.append("publishes though the context is gone")
    if name == "pattern-without-handler" and (term.code, term.received) != (-signal.SIGTERM, 0):
        wrong.append("SIGTERM does not end it at once")
    stops = ".stop" in text.partition("def main")[2] or "stop-" in name or name.startswith("pattern")
    if stops and not late and "shutdown-signal-handler-starved" not in said and name != "pattern-without-handler":
        wrong += [] if term.received else ["does not publish at SIGTERM"]
    return ", ".join(wrong)


def test_stopping(tmp_path: Path) -> None:
    said = {name: ids(text, tmp_path) for name, text in SOURCES.items()}
    left: dict[str, object] = dict.fromkeys(SOURCES)
    with observer() as watching:
        for turn in range(TRIES):
            answers = run(list(left), tmp_path, watching, turn)
            assert all(READY in each.output for pair in answers.values() for each in pair), answers
            wrong = {name: agree(name, said[name], *pair) for name, pair in answers.items()}
            left = {name: (words, said[name], answers[name]) for name, words in wrong.items() if words}
            if not left:
                break
    assert not left, "\n".join(f"{name}: {words}" for name, words in left.items())
    assert {rule for found in said.values() for rule in found} >= {
        "shutdown-double",
        "shutdown-only-keyboardinterrupt",
        "shutdown-publish-after-context",
        "shutdown-signal-handler-starved",
    }


def test_presets_are_those_of_rclpy() -> None:
    import rclpy.qos

    for name, expected in PRESETS.items():
        real = getattr(rclpy.qos, name, None) or rclpy.qos.QoSPresetProfiles[_member(name)].value
        policies = real.reliability, real.durability, real.history, real.depth, real.liveliness
        assert tuple(getattr(each, "name", each) for each in policies) == expected, name
    members = {member.name for member in rclpy.qos.QoSPresetProfiles}
    assert members - {"UNKNOWN"} <= PRESET_MEMBERS.keys()


def _member(name: str) -> str:
    return next(member for member, profile in PRESET_MEMBERS.items() if profile == name)


PROFILES = [
    "10",
    "QoSProfile(depth=3)",
    "QoSProfile(history=HistoryPolicy.KEEP_ALL)",
    "QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)",
    "QoSProfile(depth=2, reliability=ReliabilityPolicy.BEST_EFFORT, liveliness=LivelinessPolicy.MANUAL_BY_TOPIC)",
    "QoSProfile(depth=2, deadline=Duration(seconds=2), liveliness_lease_duration=Duration(nanoseconds=500000000))",
    "QoSPresetProfiles.SENSOR_DATA.value",
    "qos_profile_sensor_data",
]


@pytest.mark.parametrize("expression", PROFILES)
def test_profiles_mean_what_rclpy_makes_of_them(expression: str) -> None:
    import rclpy.qos
    from rclpy.duration import Duration

    made = eval(expression, {**vars(rclpy.qos), "Duration": Duration})
    real = rclpy.qos.QoSProfile(depth=made) if isinstance(made, int) else made
    names = "QoSProfile, QoSPresetProfiles, HistoryPolicy, DurabilityPolicy, ReliabilityPolicy, LivelinessPolicy"
    text = f"""\
import rclpy
from rclpy.duration import Duration
from rclpy.qos import {names}, qos_profile_sensor_data
rclpy.create_node('a').create_publisher(T, 'a', {expression})
"""
    (endpoint,) = parse(Source("a.py", text)).strays or [
        each for node in parse(Source("a.py", text)).classes for each in node.endpoints
    ]
    read = endpoint.qos
    assert (read.reliability, read.durability) == (real.reliability.name, real.durability.name)
    assert (read.history, read.depth, read.liveliness) == (real.history.name, real.depth, real.liveliness.name)
    for ours, theirs in ((read.deadline, real.deadline), (read.lease, real.liveliness_lease_duration)):
        assert (0 if ours == float("inf") else ours) == theirs.nanoseconds / 1e9


def test_node_names_are_those_that_rclpy_takes() -> None:
    from rclpy.exceptions import InvalidNodeNameException
    from rclpy.validate_node_name import validate_node_name

    chance = random.Random(5)
    letters = "ab_Z09-. /~äx{}"
    texts = ["", "a", "_", "9a", "a" * 255, "a" * 256, "a\n"]
    texts += ["".join(chance.choices(letters, k=chance.randint(1, 6))) for _ in range(2000)]
    for text in texts:
        try:
            validate_node_name(text)
            real = True
        except (InvalidNodeNameException, ValueError):
            real = False
        assert valid_node_name(text) == real, text


def test_a_dict_is_no_range() -> None:
    import rclpy
    from rcl_interfaces.msg import FloatingPointRange
    from rcl_interfaces.msg import ParameterDescriptor
    from rclpy.context import Context

    context = Context()
    rclpy.init(context=context)
    node = rclpy.create_node("probe", context=context, enable_rosout=False, start_parameter_services=False)
    fields = {"from_value": 0.0, "to_value": 1.5, "step": 0.1}
    with pytest.raises((AttributeError, AssertionError)):
        node.declare_parameter("speed", 0.5, ParameterDescriptor(floating_point_range=[fields]))
    node.declare_parameter("height", 0.5, ParameterDescriptor(floating_point_range=[FloatingPointRange(**fields)]))
    context.shutdown()
