"""Nodes as processes of their own that are told to stop: what they publish, how they end, and what they print."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple

READY = "@@ ready"
START_TIMEOUT = 40.0
STOP_TIMEOUT = 4.0
"""Seconds after which a process counts as one that ignores the signal."""
TOPIC = "wheel_command"


class Stopped(NamedTuple):
    received: int
    """Messages that arrived at another node after the signal."""
    code: int | None
    """The exit status, negative for a signal; None: the process had to be killed."""
    output: str


class Observer:
    """A node in a context of its own that listens to the topics of the nodes that are tried."""

    def __init__(self, node, executor) -> None:
        self.node = node
        self.executor = executor
        self.received: dict[str, int] = {}

    def listen(self, topic: str) -> None:
        from rcl_interfaces.msg import FloatingPointRange

        def count(_: FloatingPointRange) -> None:
            self.received[topic] = self.received.get(topic, 0) + 1

        self.node.create_subscription(FloatingPointRange, topic, count, 10)

    def spin(self, seconds: float) -> None:
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            self.executor.spin_once(timeout_sec=0.02)

    def stop(self, tries: list[tuple[Path, str, signal.Signals]]) -> list[Stopped]:
        """Start files that publish on topics of their own, wait until all are ready, send each its signal."""
        for _, topic, _ in tries:
            self.listen(topic)
        running = [Running(path) for path, _, _ in tries]
        self._wait(START_TIMEOUT, lambda: all(each.ready or each.code is not None for each in running))
        self.spin(0.5)
        self.received.clear()
        for each, (_, _, number) in zip(running, tries, strict=True):
            each.process.send_signal(number)
        self._wait(STOP_TIMEOUT, lambda: all(each.code is not None for each in running))
        codes = [each.code for each in running]
        outputs = [each.kill() for each in running]
        self.spin(0.3)
        counts = [self.received.get(topic, 0) for _, topic, _ in tries]
        return [Stopped(*found) for found in zip(counts, codes, outputs, strict=True)]

    def _wait(self, seconds: float, done: Callable[[], bool]) -> None:
        end = time.monotonic() + seconds
        while not done() and time.monotonic() < end:
            self.spin(0.05)


class Running:
    """One process; its output is read as it comes."""

    def __init__(self, path: Path) -> None:
        self.process = subprocess.Popen(
            [sys.executable, str(path)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, env=environment()
        )
        self.lines: list[str] = []
        self.reader = threading.Thread(target=lambda: self.lines.extend(self.process.stdout), daemon=True)
        self.reader.start()

    @property
    def ready(self) -> bool:
        return f"{READY}\n" in self.lines

    @property
    def code(self) -> int | None:
        return self.process.poll()

    def kill(self) -> str:
        """What the process printed, once it is gone."""
        self.process.kill()
        self.process.wait()
        self.reader.join(2)
        return "".join(self.lines)


def environment() -> dict[str, str]:
    """This process' variables, with discovery on the loopback interface in a domain of its own."""
    own = {"ROS_DOMAIN_ID": str(20 + os.getpid() % 70), "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"}
    kept = {name: value for name, value in os.environ.items() if not name.startswith(("ROS_", "RMW_"))}
    return {**kept, **own}


@contextmanager
def observer() -> Iterator[Observer]:
    """A node that counts what arrives."""
    import rclpy
    from rclpy.context import Context
    from rclpy.executors import SingleThreadedExecutor

    before = dict(os.environ)
    os.environ.update(environment())
    context = Context()
    rclpy.init(context=context)
    try:
        node = rclpy.create_node("observer", context=context, enable_rosout=False, start_parameter_services=False)
        executor = SingleThreadedExecutor(context=context)
        executor.add_node(node)
        yield Observer(node, executor)
    finally:
        context.shutdown()
        os.environ.clear()
        os.environ.update(before)
