"""A process of its own that runs real nodes: described as JSON in the first argument; ``ready`` when they are up.

With ``watch`` as the first argument it looks at the node of another program instead, for some seconds.
"""

from __future__ import annotations

import contextlib
import json
import subprocess
import sys
import time
from collections.abc import Iterator

READY = "@@ready"


@contextlib.contextmanager
def running(*nodes: dict[str, object], environment: dict[str, str], arguments: tuple[str, ...] = ()) -> Iterator[None]:
    """Nodes while the block runs. Each: ``name``, ``namespace``, ``publishes`` and ``subscribes`` (topic ->
    reliability), ``lifecycle``, ``parameters``."""
    process = subprocess.Popen(
        [sys.executable, __file__, json.dumps(nodes), *arguments],
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
        env=environment,
    )
    try:
        assert any(line.strip() == READY for line in process.stdout)
        yield
    finally:
        stop(process)
        process.stdout.close()


@contextlib.contextmanager
def watching(name: str, seconds: float, environment: dict[str, str]) -> Iterator[list[dict[str, list[str]]]]:
    """What another node is seen to have, in the list after the block."""
    process = subprocess.Popen(
        [sys.executable, __file__, "watch", name, str(seconds)], stdout=subprocess.PIPE, text=True, env=environment
    )
    answers: list[dict[str, list[str]]] = []
    try:
        assert any(line.strip() == READY for line in process.stdout)
        yield answers
        answers.append(json.loads(process.communicate(timeout=seconds + 20)[0].splitlines()[-1]))
    finally:
        stop(process)
        process.stdout.close()


def stop(process: subprocess.Popen[str]) -> None:
    """Let it take its shared memory along, if it can."""
    process.terminate()
    try:
        process.wait(timeout=3)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()


def main() -> None:
    import rclpy
    from rclpy.executors import SingleThreadedExecutor

    if sys.argv[1] == "watch":
        watch(sys.argv[2], float(sys.argv[3]))
        return
    rclpy.init(args=sys.argv[2:])
    executor = SingleThreadedExecutor()
    nodes = [make(**each) for each in json.loads(sys.argv[1])]
    for node in nodes:
        executor.add_node(node)
    print(READY, flush=True)
    executor.spin()


def make(name, namespace="/", publishes=(), subscribes=(), lifecycle=False, parameters=()):
    from builtin_interfaces.msg import Time
    from rclpy.lifecycle import LifecycleNode
    from rclpy.node import Node

    node = (LifecycleNode if lifecycle else Node)(name, namespace=namespace)
    for parameter, value in dict(parameters).items():
        node.declare_parameter(parameter, value)
    for topic, reliability in dict(publishes).items():
        node.create_publisher(Time, topic, profile(reliability))
    for topic, reliability in dict(subscribes).items():
        node.create_subscription(Time, topic, lambda message: None, profile(reliability))
    return node


def profile(reliability: str):
    from rclpy.qos import QoSProfile
    from rclpy.qos import ReliabilityPolicy

    return QoSProfile(depth=5, reliability=ReliabilityPolicy[reliability])


def watch(name: str, seconds: float) -> None:
    import rclpy

    rclpy.init()
    node = rclpy.create_node("watcher", start_parameter_services=False, enable_rosout=False)
    print(READY, flush=True)
    found: dict[str, set[str]] = {
        "seen": set(),
        "publishers": set(),
        "subscriptions": set(),
        "services": set(),
        "clients": set(),
    }
    ends = time.monotonic() + seconds
    while time.monotonic() < ends:
        rclpy.spin_once(node, timeout_sec=0.05)
        if name in node.get_node_names():
            found["seen"].add(name)
            with contextlib.suppress(Exception):
                found["publishers"].update(each for each, _ in node.get_publisher_names_and_types_by_node(name, "/"))
                found["subscriptions"].update(
                    each for each, _ in node.get_subscriber_names_and_types_by_node(name, "/")
                )
                found["services"].update(each for each, _ in node.get_service_names_and_types_by_node(name, "/"))
                found["clients"].update(each for each, _ in node.get_client_names_and_types_by_node(name, "/"))
    print(json.dumps({key: sorted(values) for key, values in found.items()}))


if __name__ == "__main__":
    main()
