"""Callbacks that do not run while another callback of their node waits, or because the constructor never ends."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.questions.callbacks.blocking import Blocking
from bringup_lint.graph.nodes.questions.callbacks.blocking import blocking
from bringup_lint.graph.nodes.questions.callbacks.blocking import deadlocks
from bringup_lint.graph.nodes.questions.callbacks.blocking_calls import FOREVER
from bringup_lint.graph.nodes.questions.callbacks.blocking_calls import UNTIL_KEY
from bringup_lint.graph.nodes.questions.callbacks.driver_waits import driver_waits
from bringup_lint.graph.nodes.questions.callbacks.nested_spins import taking_spins
from bringup_lint.graph.nodes.sources.callback_code import only_stores
from bringup_lint.graph.nodes.sources.device_reads import UNTIL_BYTE
from bringup_lint.graph.nodes.sources.device_reads import UNTIL_PACKET
from bringup_lint.graph.nodes.sources.endless_loops import Endless
from bringup_lint.graph.nodes.sources.endless_loops import endless_constructors
from bringup_lint.model.cpp_source import UNTIL_OTHER_NODE
from bringup_lint.model.cpp_source import Waiting
from bringup_lint.model.node_source import Callback
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.node_source import NodeSource
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.source import Source

_WORK = ("subscription", "timer", "service", "action", "client")
_URGENT = ("subscription", "timer", "action")
"""What must not wait: a service may answer a few seconds later."""
_SERVED = ("subscription", "service")
"""Callbacks that are to run once for each message or request: a timer whose callback never ends may be meant."""
_DEAF = (UNTIL_BYTE, UNTIL_PACKET, UNTIL_KEY)
"""Waits in a timer that keep even a node without other callbacks from its services and from SIGTERM."""
_SPIN = "rclcpp::spin"
_MEASURES = "psutil."
"""Short waits of a status node, which matter when its timer is due again before they end."""
_SECONDS = regex(r"for (\d+(?:\.\d+)?) s\Z")
_SOON = ("for ", "as long as ")
"""Waits that end by themselves: a subscription that only keeps the newest message may be served after them."""


class Stopped(NamedTuple):
    """A wait in a callback of a Python node, and the other callbacks that do not run in the meantime."""

    file: NodeSource
    wait: Blocking
    callbacks: list[Callback]
    certain: bool
    """One thread runs them all."""
    period: float | None = None
    """Seconds between the calls of the timer which the wait itself makes late."""


class NeverRun(NamedTuple):
    """A loop in the constructor, and the callbacks that it keeps from ever running."""

    file: NodeSource
    loop: Endless
    callbacks: list[Callback]


class StoppedInCpp(NamedTuple):
    source: Source
    wait: Waiting
    callbacks: list[Callback]


def stopped_callbacks(nodes: Nodes) -> Iterator[Stopped]:
    for file, node in nodes.node_classes:
        threads = nodes.threads(node)
        taken = set(taking_spins(nodes, nodes.ending(file), node))
        own = list(blocking(nodes.ending(file), node))
        for wait in own or driver_waits(nodes, file, node):
            if wait.call in taken:
                continue
            found = _stopped(nodes, file, node, wait, threads)
            period = _missed(node, wait)
            if found is not None or period is not None:
                yield Stopped(file, wait, found or [], threads == "one", period)


def _stopped(nodes: Nodes, file: NodeSource, node: NodeClass, wait: Blocking, threads: str) -> list[Callback] | None:
    """The callbacks that a wait stops; None when that does no harm, or is not sure.

    rclpy runs the execute callback of an action server as a task of the executor, which is in no callback group
    (``ActionServer.notify_execute``): several threads run the others meanwhile."""
    callback = wait.callback
    if wait.what.startswith(_MEASURES):
        return None
    found = [each for each in node.callbacks if each.role in _WORK and each.name != callback.name]
    if threads == "several":
        if callback.role == "action":
            return None
        found = [each for each in found if each.group == callback.group and each.role != "action"]
        if wait.how_long and callback.group is not None and callback.group.reentrant is not False:
            return None
    if not wait.how_long or wait.nested:
        return found if deadlocks(wait, threads) else None
    if wait.how_long == FOREVER and callback.role in _SERVED:
        return found
    urgent = [each for each in found if each.role in _URGENT]
    if wait.how_long.startswith(_SOON):
        ending = nodes.ending(file)
        urgent = [each for each in urgent if each.role != "subscription" or not only_stores(ending, node, each)]
    is_deaf = wait.how_long in _DEAF and callback.role == "timer"
    return found if urgent or is_deaf else None


def _missed(node: NodeClass, wait: Blocking) -> float | None:
    """The period of the timer that is due again before its callback has measured; None when there is time, and for a
    sleep, which may pace the timer on purpose."""
    seconds = _SECONDS.match(wait.how_long)
    if seconds is None or wait.callback.role != "timer" or not wait.what.startswith(_MEASURES):
        return None
    periods = [each.period for each in node.timers if each.callback == wait.callback.name and each.period is not None]
    return periods[0] if len(periods) == 1 and 0 < periods[0] < float(seconds[1]) else None


def never_run(nodes: Nodes) -> Iterator[NeverRun]:
    """The nodes whose constructors never end, so that no executor gets them."""
    for file, node in nodes.node_classes:
        callbacks = [each for each in node.callbacks if each.role in _WORK]
        loop = next(endless_constructors(nodes.ending(file), node), None) if callbacks else None
        if loop is not None:
            yield NeverRun(file, loop, callbacks)


def stopped_in_cpp(nodes: Nodes) -> Iterator[StoppedInCpp]:
    for node in nodes.cpp:
        thrown = {each.span for each in node.nested_spins}
        for wait in node.waits:
            if (node.executors and not wait.is_certain) or wait.span in thrown:
                continue
            found = [each for each in node.callbacks if each.span != wait.callback.span and each.role in _URGENT]
            if found or wait.how_long == UNTIL_OTHER_NODE or wait.what == _SPIN or wait.is_certain:
                yield StoppedInCpp(node.source, wait, found)
