"""Looks at the running ROS graph, as a program of its own: a middleware that hangs or crashes takes nothing with it.

It joins a domain as a hidden node that publishes nothing and offers no service, looks, asks lifecycle nodes for their
state, leaves, and prints what it saw as one line of JSON. Needs nothing but rclpy; exit code 3 when there is none. An
alarm ends it when it hangs and nobody waits for it any more.
"""

from __future__ import annotations

import json
import signal
import sys
import time
from typing import Any

NAME = "_bringup_lint"
NO_RCLPY = 3
FAILED = 4
MARK = "@@observed-graph "
"""Begins the line of the answer; anything else on stdout comes from the libraries."""
QUIET = 0.5
"""Seconds without a change after which discovery counts as done, once the wait is over."""
LONGER = 2.0
"""Seconds by which the wait is extended at most, while nodes still appear or none has. Fast DDS announces itself every
3 s."""
ANSWER = 2.0
"""Seconds in which lifecycle nodes must answer, all together."""
GET_STATE = "lifecycle_msgs/srv/GetState"
NO_ANSWER = "no answer"
"""The state of a lifecycle node that does not tell it."""


def main() -> None:
    task = json.loads(sys.argv[1])
    signal.alarm(task["limit"])
    try:
        import rclpy  # noqa: F401

        seen = observe(task["domain"], task["wait"], task["enclave"], task["parameters"])
    except ImportError as error:
        print(error, file=sys.stderr)
        sys.exit(NO_RCLPY)
    except Exception as error:
        print(f"{type(error).__name__}: {error}", file=sys.stderr)
        sys.exit(FAILED)
    print(f"\n{MARK}{json.dumps(seen)}", flush=True)


def observe(domain: int, wait: float, enclave: str | None, parameters: dict[str, list[str]]) -> dict[str, object]:
    """Everything that can be seen on a domain after some seconds."""
    import rclpy
    from rclpy.context import Context
    from rclpy.executors import SingleThreadedExecutor
    from rclpy.signals import SignalHandlerOptions

    context = Context()
    arguments = ["--ros-args", "--disable-external-lib-logs", "--disable-rosout-logs"]
    arguments += ["--enclave", enclave] if enclave else []
    signals = SignalHandlerOptions.NO
    rclpy.init(args=arguments, context=context, domain_id=domain, signal_handler_options=signals)
    try:
        node = quiet_node(context)
        executor = SingleThreadedExecutor(context=context)
        executor.add_node(node)
        discover(node, executor, wait)
        seen = {
            "domain": context.get_domain_id(),
            "rmw": rclpy.get_rmw_implementation_identifier(),
            "nodes": nodes(node),
            "endpoints": endpoints(node),
            "states": lifecycle_states(node, executor),
            "parameters": parameter_values(node, executor, parameters),
        }
        executor.shutdown(timeout_sec=1)
        node.destroy_node()
    finally:
        context.try_shutdown()
    return seen


def quiet_node(context):
    """A hidden node that has no parameter, logging or description services and publishes nothing."""
    from rclpy.node import Node
    from rclpy.parameter import Parameter

    class Nowhere:
        def publish(self, message) -> None:
            """rclpy reports the parameters of every node; this one's interest nobody."""

    class QuietNode(Node):
        def create_publisher(self, *arguments, **options):
            return Nowhere()

    return QuietNode(
        NAME,
        context=context,
        use_global_arguments=False,
        start_parameter_services=False,
        enable_rosout=False,
        parameter_overrides=[Parameter("start_type_description_service", value=False)],
    )


def discover(node, executor, wait: float) -> None:
    """Wait, and a little longer while things still change."""
    started = changed = time.monotonic()
    before = None
    while (now := time.monotonic()) < started + wait + LONGER:
        executor.spin_once(timeout_sec=0.1)
        graph = (sorted(node.get_node_names_and_namespaces()), sorted(node.get_topic_names_and_types()))
        if graph != before:
            before, changed = graph, now
        alone = len(graph[0]) < 2
        if now >= started + wait and now >= changed + QUIET and not alone:
            return


def full_name(name: str, namespace: str) -> str:
    return f"{namespace.rstrip('/')}/{name}"


def nodes(node) -> list[list[str]]:
    """Full name and enclave of every node; a name that is taken twice comes twice."""
    found = node.get_node_names_and_namespaces_with_enclaves()
    return sorted([full_name(name, namespace), enclave] for name, namespace, enclave in found if name != NAME)


def endpoints(node) -> list[dict[str, object]]:
    found = []
    for topic, _ in sorted(node.get_topic_names_and_types()):
        for role, infos in (
            ("publisher", node.get_publishers_info_by_topic(topic)),
            ("subscription", node.get_subscriptions_info_by_topic(topic)),
        ):
            own = [endpoint(topic, role, info) for info in infos if info.node_name != NAME]
            found += sorted(own, key=lambda each: (each["node"], each["type"], json.dumps(each["qos"])))
    return found


def endpoint(topic: str, role: str, info) -> dict[str, object]:
    profile = info.qos_profile
    return {
        "topic": topic,
        "role": role,
        "node": full_name(info.node_name, info.node_namespace),
        "type": info.topic_type,
        "qos": {
            "reliability": profile.reliability.name.lower(),
            "durability": profile.durability.name.lower(),
            "deadline": seconds(profile.deadline),
            "liveliness": profile.liveliness.name.lower(),
            "lease": seconds(profile.liveliness_lease_duration),
        },
    }


def seconds(duration) -> float | None:
    """None when there is no limit: rmw says so with the largest duration, some with zero."""
    limited = 0 < duration.nanoseconds < 2**63 - 1 and duration.nanoseconds != 0x7FFFFFFF * 10**9 + 0x7FFFFFFF
    return duration.nanoseconds / 1e9 if limited else None


def lifecycle_states(node, executor) -> dict[str, str]:
    """Full name -> state of every lifecycle node."""
    try:
        from lifecycle_msgs.srv import GetState
    except ImportError:
        return {}
    services = [name for name, types in node.get_service_names_and_types() if GET_STATE in types]
    found = answers(node, executor, GetState, {name: GetState.Request() for name in services})
    states = {name: found[name].current_state.label if name in found else NO_ANSWER for name in services}
    return {name.rpartition("/")[0]: state for name, state in states.items()}


def parameter_values(node, executor, wanted: dict[str, list[str]]) -> list[list[str]]:
    """Node, name and value of the numbers and switches among the parameters that nodes have; nodes are asked for
    nothing that they do not declare."""
    try:
        from rcl_interfaces.srv import GetParameters
        from rcl_interfaces.srv import ListParameters
    except ImportError:
        return []
    there = {name for name, _ in node.get_service_names_and_types()}
    lists = {f"{each}/list_parameters": each for each in wanted if f"{each}/list_parameters" in there}
    listed = answers(node, executor, ListParameters, {name: ListParameters.Request() for name in lists})
    names_of = {lists[service]: set(answer.result.names) for service, answer in listed.items()}
    known = {each: sorted(names & set(wanted[each])) for each, names in names_of.items()}
    requests = {f"{each}/get_parameters": GetParameters.Request(names=names) for each, names in known.items() if names}
    found = []
    for service, answer in answers(node, executor, GetParameters, requests).items():
        each = service.rpartition("/")[0]
        values = (value_of(value) for value in answer.values)
        found += [[each, name, value] for name, value in zip(known[each], values) if value is not None]
    return sorted(found)


def value_of(value) -> str | None:
    """The text of a number or switch (rcl_interfaces/msg/ParameterType); None for any other."""
    texts = {1: str(value.bool_value).lower(), 2: str(value.integer_value), 3: repr(value.double_value)}
    return texts.get(value.type)


def answers(node, executor, kind, requests: dict[str, Any]) -> dict[str, Any]:
    """The answers that services give in time, all asked side by side."""
    clients = {name: node.create_client(kind, name) for name in requests}
    asked: dict[str, Any] = {}
    until = time.monotonic() + ANSWER
    while time.monotonic() < until and not all(name in asked and asked[name].done() for name in clients):
        for name, client in clients.items():
            if name not in asked and client.service_is_ready():
                asked[name] = client.call_async(requests[name])
        executor.spin_once(timeout_sec=0.05)
    done = {name: future.result() for name, future in asked.items() if future.done()}
    return {name: answer for name, answer in done.items() if answer is not None}


if __name__ == "__main__":
    main()
