"""Parameters that a node declares and never reads, though a file gives them a value."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.memo import memo
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.model.node_source import NodeSource
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.graph.params.params import Params
    from bringup_lint.model.params import Parameter

_READS_OTHERS = regex(
    r"get_parameters|get_parameter_or|_parameters\b|add_on_set|on_set_param|parameter_callback|set_descriptor|getattr"
    r"|get_parameter\((?![ \t\n]*[\"'])"
)
"""What may read parameters by names that are not literal, or hear of their changes."""
_OF_ROS = ("use_sim_time", "start_type_description_service", "robot_description")


class UnreadParameter(NamedTuple):
    file: NodeSource
    name: Located
    given: list[Parameter]
    """Where parameter files of the same package set it."""


def unread_parameters(nodes: Nodes, params: Params) -> Iterator[UnreadParameter]:
    """The parameters of Python programs whose names appear in the declaration alone."""
    values = _Given(nodes, params)
    for file in nodes.robot_sources:
        if ".declare_parameter(" not in file.source.text or nodes.launch.workspace.is_vendored(file.source):
            continue
        imported = nodes.imported(file)
        if imported is None or any(each.source.matches(_READS_OTHERS) for each in imported):
            continue
        text = "\n".join(each.source.text for each in imported)
        for name in _declared(nodes.syntax(file)):
            given = values.of(file, str(name))
            if given and len(re.findall(rf"[\"']{re.escape(name)}[\"']", text)) == 1:
                yield UnreadParameter(file, name, given)


def _declared(syntax: Syntax) -> Iterator[Located]:
    """The names of declarations whose result nobody uses."""
    for call in syntax.calls:
        name = call.args[0] if call.args else None
        if not isinstance(call.func, ast.Attribute) or call.func.attr != "declare_parameter":
            continue
        if not isinstance(name, ast.Constant) or not isinstance(name.value, str) or name.value in _OF_ROS:
            continue
        outer = next(syntax.above(call), None)
        if outer is not None and isinstance(outer[0], ast.Expr):
            yield Located(name.value, syntax.file.span_of(name))


class _Given:
    """The values in the parameter files that launch files give to programs."""

    def __init__(self, nodes: Nodes, params: Params) -> None:
        self._nodes = nodes
        self._params = params

    def of(self, file: NodeSource, name: str) -> list[Parameter]:
        by_action = self._by_action(name)
        places = {at for each in self._nodes.launched(file) for at in by_action.get(id(each.action), ())}
        return [self._params.named(name)[at][1] for at in sorted(places)]

    @memo
    def _by_action(self, name: str) -> dict[int, list[int]]:
        """The action of a launch file -> which values of a parameter are in the files that it loads."""
        found: dict[int, list[int]] = {}
        for at, (file, _) in enumerate(self._params.named(name)):
            for load in self._params.loads(file):
                found.setdefault(id(load.node.action), []).append(at)
        return found
