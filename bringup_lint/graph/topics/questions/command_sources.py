"""Topics that command or stop the robot's motion, and the nodes that choose or limit what gets through."""

from __future__ import annotations

import re
from collections.abc import Iterable
from collections.abc import Iterator
from itertools import combinations

from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.topics.questions.coexistence import coexist
from bringup_lint.graph.topics.resolved.endpoint_use import LaunchedNode
from bringup_lint.graph.topics.resolved.endpoint_use import Running
from bringup_lint.graph.topics.resolved.endpoint_use import Use
from bringup_lint.graph.topics.resolved.names import tail
from bringup_lint.pattern import regex
from bringup_lint.source import Source

VELOCITY = regex(r"(?:\w+_)?cmd_?vel(?:_\w+)?|\w*velocity_command\w*")
FINAL = ("cmd_vel", "cmd_vel_unstamped")
"""Names of topics that drive the wheels; others may be the inputs of a multiplexer that is not known."""
STOP = regex(r"(?:^|[/_])(?:e_?stop|emergency(?:_?stop)?)(?:$|[/_])", re.I)
TWISTS = ("geometry_msgs/msg/Twist", "geometry_msgs/msg/TwistStamped")
GATE = regex(r"mux|gate|arbit|smooth|collision|limit|safe|guard|filter|supervis|priorit|switch|select")
BY_HAND = regex(r"tele|joy|keyboard|key_?op|remote|steering")
HARDWARE = regex(
    r"\b(?:RPi\.GPIO|gpiod?|gpiozero|pigpio\w*|Jetson\.GPIO|wiringpi)\b|safety_?(?:plc|relay|controller)|sick_?saf\w+|pilz"
    r"|hardware\w{0,64}?[/_]?(?:e_?stop|emergency)|(?:e_?stop|emergency)_?(?:button|pin|relay|input|gpio)",
    re.I,
)
"""Words that speak of a stop in hardware."""
COMPARED = 50
"""Publishers of one velocity that are compared with each other."""
TOGETHER = ("nav2_", "opennav_")
"""Packages whose servers take turns, as the navigator decides."""


def is_velocity(name: str, type_: str | None = None) -> bool:
    return bool(VELOCITY.fullmatch(tail(name))) and type_ in (None, *TWISTS)


def is_stop(name: str) -> bool:
    return bool(STOP.search(name))


def is_gate(node: LaunchedNode) -> bool:
    """Whether a node chooses or limits velocities, by its name or because it turns one velocity into another."""
    words = (node.started.package, node.started.executable, node.started.plugin, node.started.name)
    return any(GATE.search(literal_text(word) or "") for word in words) or passes_on(node)


def passes_on(node: LaunchedNode) -> bool:
    """Whether a node turns one velocity into another."""
    taken = {use.topic for use in node.uses if use.role == "subscription" and is_velocity(use.topic, use.type)}
    given = {use.topic for use in node.uses if use.role == "publisher" and is_velocity(use.topic, use.type)}
    return bool(taken and given)


def rivals(running: Running) -> Iterator[list[Use]]:
    """The publishers of one velocity topic that all start when no argument is passed, when there are several of them
    and no multiplexer or gate is among them or listens to them; or when they go past the one that limits them."""
    for topic, uses in running.by_topic().items():
        if _is_gated(topic, uses):
            continue
        several = _sources(uses)
        if not all(coexist(one.node, other.node) for one, other in combinations(several, 2)):
            continue
        if len(several) > 1 and not any(is_gate(use.node) for use in several):
            yield several
        elif past := _past_the_gate(several):
            yield past


def _is_gated(topic: str, uses: list[Use]) -> bool:
    """Whether something chooses among the publishers of a topic, or may do so unseen."""
    listeners = [use.node for use in uses if use.role == "subscription"]
    return any(map(is_gate, listeners)) or (tail(topic) not in FINAL and not listeners)


def _sources(uses: list[Use]) -> list[Use]:
    """The publishers of velocities that surely start, one for each node."""
    found: dict[object, Use] = {}
    for use in uses:
        started = use.node.started
        sure = started.by_default is True and not use.conditional_source and not started.context
        if sure and use.role == "publisher" and is_velocity(use.topic, use.type):
            found.setdefault(_who(use.node), use)
    return list(found.values())[:COMPARED]


def _past_the_gate(several: list[Use]) -> list[Use]:
    """The gate of the tree and the publishers that nothing limits, when there are any."""
    gates = [use for use in several if not use.of_table and passes_on(use.node)]
    others = [use for use in several if not is_gate(use.node) and _who(use.node) != TOGETHER]
    return [*others, gates[0]] if len(gates) == 1 and others else []


def is_mux(node: LaunchedNode) -> bool:
    """Whether a node is twist_mux."""
    return literal_text(node.started.package) == "twist_mux"


def past_the_mux(running: Running) -> Iterator[list[Use]]:
    """The publishers of the topic to which the one twist_mux sends what it has chosen, after that of twist_mux."""
    for uses in running.by_topic().values():
        several = _sources(uses)
        muxes = [use for use in several if is_mux(use.node)]
        others = [use for use in several if not is_gate(use.node)]
        if len(muxes) == 1 and others and all(coexist(muxes[0].node, use.node) for use in others):
            yield [muxes[0], *others]


def ungated(running: Running) -> Iterator[tuple[Use, Use]]:
    """Velocities that go straight from a node that makes them by itself to the one that obeys."""
    for topic, uses in running.by_topic().items():
        if not is_velocity(topic):
            continue
        sure = [use for use in uses if use.node.started.by_default is True and is_velocity(topic, use.type)]
        makers = [use for use in sure if use.role == "publisher" and not _by_hand(use.node)]
        obeying = [use for use in sure if use.role == "subscription"]
        yield from ((maker, obeying[0]) for maker in makers if obeying and obeying[0].node is not maker.node)


def _by_hand(node: LaunchedNode) -> bool:
    words = (node.started.package, node.started.executable, node.started.name)
    return any(BY_HAND.search(literal_text(word) or "") for word in words)


def has_stop_hardware(sources: Iterable[Source]) -> bool:
    """Whether sources, parameters or launch files speak of hardware that may stop the robot."""
    return any(source.matches(HARDWARE) for source in sources)


def _who(node: LaunchedNode) -> object:
    package = literal_text(node.started.package) or ""
    return TOGETHER if package.startswith(TOGETHER) else node.fqn or node
