"""Values of parameters that Python nodes keep in an attribute, and then at most log."""

from __future__ import annotations

import ast
import re
from collections import Counter
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.questions.parameters.given_in_package import given_in_package
from bringup_lint.graph.nodes.questions.parameters.unused_parameter import UnusedParameter
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.model.node_source import NodeSource
from bringup_lint.model.python import called_name
from bringup_lint.model.python import is_own
from bringup_lint.model.python import last_name
from bringup_lint.model.python import walk
from bringup_lint.pattern import regex
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

_READS = regex(r"\b(?:get|declare)_parameter\b")
_BY_NAME = regex(
    r"\b(?:getattr|setattr|vars|locals|eval|exec)\s{0,4}\(|__dict__|__slots__|add_\w{0,10}on_set_parameters_callback"
    r"|add_(?:post|pre)_set_parameters_callback|ParameterEventHandler"
)
"""What may use attributes by names that are not written, or hears of changes."""
_CONVERTS = frozenset({"float", "int", "str", "bool", "list", "tuple"})
_ASKS = ("get_parameter", "declare_parameter")
_LEVELS = frozenset({"debug", "info", "warn", "warning", "error", "fatal"})
_OF_ROS = ("use_sim_time", "start_type_description_service", "robot_description")
_FILES = 300
"""Files of a package that are searched; one with more is left alone."""


def unused_in_python(nodes: Nodes) -> Iterator[UnusedParameter]:
    for file in nodes.robot_sources:
        text = file.source.text
        if not _READS.search(text) or _BY_NAME.search(text) or nodes.launch.workspace.is_vendored(file.source):
            continue
        for name, target, is_logged in _unused(nodes.syntax(file)):
            if not _is_used_beside(nodes, file, target.attr):
                variable = Located(f"self.{target.attr}", file.span_of(target))
                given = given_in_package(nodes, file.source, str(name))
                yield UnusedParameter(file.source, name, variable, given, is_logged)


def _unused(syntax: Syntax) -> Iterator[tuple[Located, ast.Attribute, bool]]:
    """The parameters that are read into attributes of the own object, which it does not use; True: it logs them."""
    if syntax.file.tree is None:
        return
    logged = {each for call in syntax.calls if _is_log(call) for each in walk(call)}
    shown = {each.attr for each in logged if is_own(each)}
    kept: list[tuple[ast.Call, ast.Attribute]] = []
    used: set[str] = set()
    texts: Counter[str] = Counter()
    for node in walk(syntax.file.tree):
        if isinstance(node, ast.Attribute) and not isinstance(node.ctx, ast.Store) and node not in logged:
            used.add(node.attr)
        elif isinstance(node, ast.AugAssign) and isinstance(node.target, ast.Attribute):
            used.add(node.target.attr)
        elif isinstance(node, ast.Constant) and isinstance(node.value, str):
            texts[node.value] += 1
        elif isinstance(node, ast.Assign) and len(node.targets) == 1 and is_own(node.targets[0]):
            call = _read(node.value)
            if call is not None and _name(call) is not None:
                kept.append((call, node.targets[0]))
    asked = Counter(_name(call) for call in syntax.calls if called_name(call) == "get_parameter")
    for call, target in kept:
        name, is_asked = _name(call), called_name(call) == "get_parameter"
        is_once = asked[name] == is_asked and texts[str(name)] == 1 + is_asked
        if name is not None and is_once and target.attr not in used and not _may_react(syntax, target):
            yield Located(name, syntax.file.span_of(call.args[0])), target, target.attr in shown


def _is_log(call: ast.Call) -> bool:
    """``self.get_logger().info(...)``, or ``print(...)``."""
    if not isinstance(call.func, ast.Attribute):
        return called_name(call) == "print"
    owner = call.func.value
    named = called_name(owner) if isinstance(owner, ast.Call) else last_name(owner)
    return call.func.attr in _LEVELS and "log" in named.lower()


def _name(call: ast.Call) -> str | None:
    name = call.args[0] if call.args else None
    text = name.value if isinstance(name, ast.Constant) else None
    return text if isinstance(text, str) and text not in _OF_ROS else None


def _may_react(syntax: Syntax, target: ast.Attribute) -> bool:
    """Whether the class may do something when the attribute is set, or one of its bases is not known."""
    node = syntax.class_of(target)
    return node is None or node.is_node is not True or target.attr in node.methods


def _read(value: ast.expr) -> ast.Call | None:
    """The call that asks, in ``float(self.get_parameter('name').value)``."""
    while True:
        if isinstance(value, ast.Attribute):
            value = value.value
        elif not isinstance(value, ast.Call):
            return None
        elif isinstance(value.func, ast.Name) and value.func.id in _CONVERTS and len(value.args) == 1:
            value = value.args[0]
        elif called_name(value) in _ASKS:
            return value
        elif isinstance(value.func, ast.Attribute) and value.func.attr == "get_parameter_value":
            value = value.func.value
        else:
            return None


def _is_used_beside(nodes: Nodes, file: NodeSource, attribute: str) -> bool:
    """Whether another file that may have the object names the attribute."""
    owner = nodes.launch.workspace.owner(file.source)
    paths = nodes.files.tree.walked_below(owner.folder) if owner is not None else []
    paths = [path for path in paths if path.endswith(".py")]
    if owner is None or len(paths) > _FILES:
        return True
    word = re.compile(rf"\b{re.escape(attribute)}\b")
    others = [nodes.files.tree.read(path, judged=False) for path in paths]
    texts = [each.text for each in others if each is not None and each.absolute != file.source.absolute]
    texts += [each.source.text for each in nodes.importers(file.source)]
    return any(f".{attribute}" in text and word.search(text) for text in texts)
