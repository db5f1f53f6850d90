"""Run by an interpreter that has ROS's own launch and launch_ros: print what launch files start, as JSON.

Usage: python launch_runner.py PREFIX FILE... ; PREFIX is put before AMENT_PREFIX_PATH. No process is started.
"""

from __future__ import annotations

import json
import os
import sys
import types

sys.modules.setdefault("composition_interfaces", types.ModuleType("composition_interfaces"))
services = types.ModuleType("composition_interfaces.srv")
services.LoadNode = type("LoadNode", (), {"Request": object})
sys.modules.setdefault("composition_interfaces.srv", services)
sys.modules["composition_interfaces"].srv = services

from launch import LaunchContext  # noqa: E402
from launch.actions import ExecuteLocal  # noqa: E402
from launch.actions import IncludeLaunchDescription  # noqa: E402
from launch.actions import RegisterEventHandler  # noqa: E402
from launch.actions import TimerAction  # noqa: E402
from launch.launch_description_sources import AnyLaunchDescriptionSource  # noqa: E402
from launch.utilities import normalize_to_list_of_substitutions  # noqa: E402
from launch.utilities import perform_substitutions  # noqa: E402
from launch_ros.actions import ComposableNodeContainer  # noqa: E402
from launch_ros.actions import LifecycleNode  # noqa: E402
from launch_ros.actions import LoadComposableNodes  # noqa: E402
from launch_ros.actions import Node  # noqa: E402
from launch_ros.parameter_descriptions import ParameterFile  # noqa: E402
from launch_ros.utilities import evaluate_parameters  # noqa: E402
from launch_ros.utilities import make_namespace_absolute  # noqa: E402
from launch_ros.utilities import prefix_namespace  # noqa: E402


def private(thing, owner, name):
    return getattr(thing, f"_{owner}__{name}", None)


def text(context, value):
    if value is None:
        return None
    return perform_substitutions(context, normalize_to_list_of_substitutions(value))


def parameters(context, described):
    result = []
    for source in described or ():
        if isinstance(source, ParameterFile):
            value = private(source, "ParameterFile", "param_file")
            result.append(text(context, value) if isinstance(value, (str, list, tuple)) else str(value))
        else:
            try:
                (values,) = evaluate_parameters(context, [source])
            except Exception as error:
                result.append(f"error {error}")
                continue
            result.append(
                {name: list(value) if isinstance(value, (tuple, list)) else value for name, value in values.items()}
            )
    return result


def record(found, context, node):
    node._perform_substitutions(context)
    owner = "Node"
    namespace = node.expanded_node_namespace
    found.append(
        {
            "package": text(context, private(node, owner, "package")),
            "program": text(context, private(node, owner, "node_executable")),
            "name": text(context, private(node, owner, "node_name")),
            "namespace": "/" if not namespace or namespace == Node.UNSPECIFIED_NODE_NAMESPACE else namespace,
            "remappings": [list(pair) for pair in node.expanded_remapping_rules or ()],
            "parameters": parameters(context, private(node, owner, "parameters")),
        }
    )


def component(found, context, described):
    condition = private(described, "ComposableNode", "condition")
    if condition is not None and not condition.evaluate(context):
        return
    own = text(context, described.node_namespace)
    namespace = make_namespace_absolute(prefix_namespace(context.launch_configurations.get("ros_namespace"), own))
    remaps = list(context.launch_configurations.get("ros_remaps") or ())
    remaps += [(text(context, src), text(context, dst)) for src, dst in described.remappings or ()]
    found.append(
        {
            "package": text(context, described.package),
            "program": text(context, described.node_plugin),
            "name": text(context, described.node_name),
            "namespace": namespace or "/",
            "remappings": [list(pair) for pair in remaps],
            "parameters": parameters(context, described.parameters),
        }
    )


def visit(found, context, entity):
    condition = getattr(entity, "condition", None)
    if isinstance(entity, (ExecuteLocal, LoadComposableNodes, TimerAction, RegisterEventHandler)):
        if condition is not None and not condition.evaluate(context):
            return
    if isinstance(entity, RegisterEventHandler):
        return
    if isinstance(entity, TimerAction):
        for inner in entity.actions:
            visit(found, context, inner)
    elif isinstance(entity, LoadComposableNodes):
        for described in private(entity, "LoadComposableNodes", "composable_node_descriptions"):
            component(found, context, described)
    elif isinstance(entity, Node):
        record(found, context, entity)
        if isinstance(entity, ComposableNodeContainer):
            for described in private(entity, "ComposableNodeContainer", "composable_node_descriptions") or ():
                component(found, context, described)
    elif isinstance(entity, ExecuteLocal):
        command = [text(context, word) for word in entity.cmd]
        if command[:2] == ["ros2", "run"] and len(command) > 3:
            found.append(
                {
                    "package": command[2],
                    "program": command[3],
                    "name": None,
                    "namespace": None,
                    "remappings": [],
                    "parameters": [],
                }
            )
    else:
        for inner in entity.visit(context) or ():
            visit(found, context, inner)


def started(path):
    found = []
    context = LaunchContext(noninteractive=True)
    source = AnyLaunchDescriptionSource(path)
    try:
        visit(found, context, IncludeLaunchDescription(source))
    except Exception as error:
        return {"error": f"{type(error).__name__}: {error}", "nodes": found}
    return {"nodes": found}


def main():
    prefix, *files = sys.argv[1:]
    os.environ["AMENT_PREFIX_PATH"] = os.pathsep.join((prefix, sys.prefix))
    print(json.dumps({path: started(path) for path in files}, default=str))


if __name__ == "__main__":
    assert LifecycleNode
    main()
