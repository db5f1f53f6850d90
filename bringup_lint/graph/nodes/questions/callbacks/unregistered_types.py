"""Messages that a program gives to a tf2 buffer, and of which no module that it imports tells the buffer how to turn
them."""

from __future__ import annotations

import ast
import os
import sys
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.questions.callbacks.transforms import is_lookup
from bringup_lint.graph.nodes.sources.message_types import MessageTypes
from bringup_lint.graph.nodes.sources.what_ends import end_of
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.python_node.values import argument

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.model.node_source import NodeSource

_GEOMETRY = "tf2_geometry_msgs"
_REGISTERED = {
    "geometry_msgs/msg/PointStamped": _GEOMETRY,
    "geometry_msgs/msg/PoseStamped": _GEOMETRY,
    "geometry_msgs/msg/PoseWithCovarianceStamped": _GEOMETRY,
    "geometry_msgs/msg/Vector3Stamped": _GEOMETRY,
    "sensor_msgs/msg/PointCloud2": "tf2_sensor_msgs",
}
"""Type -> the module whose import registers it (``tf2_ros.TransformRegistration().add``)."""
_KNOWN = frozenset(
    (
        *("rclpy", "tf2_ros", "tf2_py", "numpy", "scipy", "cv2", "cv_bridge", "yaml", "message_filters"),
        *("ament_index_python", "builtin_interfaces", "image_geometry", "sensor_msgs_py", "tf_transformations"),
        *("transforms3d", "serial"),
    )
)
"""Modules that import none of those which register types."""
_INTERFACES = frozenset({"msg", "srv", "action"})
_CAUGHT = frozenset({"Exception", "BaseException", "TypeException"})


class Unregistered(NamedTuple):
    file: NodeSource
    call: ast.Call
    type: str
    module: str
    """The module that would register the type."""
    end: str
    """What the exception ends, in words."""


def unregistered_types(nodes: Nodes) -> Iterator[Unregistered]:
    """The calls of ``transform()`` of a buffer in files that are programs themselves."""
    for types in nodes.message_types:
        file = types.file
        if file.main is None or "transform(" not in file.source.text:
            continue
        found = list(_calls(nodes, types))
        modules = _imported(nodes, file) if found else None
        if modules is not None:
            yield from (each for each in found if each.module not in modules)


def _calls(nodes: Nodes, types: MessageTypes) -> Iterator[Unregistered]:
    ending = nodes.ending(types.file)
    for call in types.syntax.calls:
        is_transform = isinstance(call.func, ast.Attribute) and call.func.attr == "transform"
        given = argument(call, 0, "object_stamped") if is_transform else None
        type_ = types.of(given) if given is not None else None
        module = _REGISTERED.get(type_ or "")
        if type_ is None or module is None or not is_lookup(ending, call) or types.syntax.is_dead(call):
            continue
        end = end_of(types.syntax, call, caught=types.syntax.catches(call, _CAUGHT))
        yield Unregistered(types.file, call, type_, module, end)


def _imported(nodes: Nodes, file: NodeSource) -> set[str] | None:
    """The modules of tf2 that a program imports, also through files of the tree; None where it imports something that
    may do so unseen."""
    files = nodes.imported(file)
    if files is None or any("import_module" in each.source.text or _has_package_code(nodes, each) for each in files):
        return None
    found: set[str] = set()
    for each in files:
        for name in (*each.imports.values(), *each.stars):
            module = name or ""
            top, _, rest = module.partition(".")
            if top in _REGISTERED.values():
                found.add(top)
            elif not (_is_known(top, rest) or _is_of_tree(nodes, module, each)):
                return None
    return found


def _has_package_code(nodes: Nodes, file: NodeSource) -> bool:
    """Whether Python runs an ``__init__.py`` that imports something before it comes to a file."""
    folder = os.path.dirname(file.source.absolute)
    while (source := nodes.files.tree.at(f"{folder}/__init__.py")) is not None:
        if source is not file.source and "import" in source.said:
            return True
        folder = os.path.dirname(folder)
    return False


def _is_of_tree(nodes: Nodes, module: str, file: NodeSource) -> bool:
    """Whether a module, or a name of it, is that of a file of the tree."""
    return (
        nodes.module_named(module, file) is not None or nodes.module_named(module.rpartition(".")[0], file) is not None
    )


def _is_known(top: str, rest: str) -> bool:
    is_interface = rest.partition(".")[0] in _INTERFACES
    return top in _KNOWN or top in sys.stdlib_module_names or is_interface or top.endswith("_msgs")
