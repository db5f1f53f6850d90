"""Parameters that C++ nodes declare and never read."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.questions.parameters.given_in_package import given_in_package
from bringup_lint.graph.nodes.questions.parameters.heard_parameters import package_texts
from bringup_lint.model.cpp_text import plain_of
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Source
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.model.node_source import Parameter

_READS_OTHERS = regex(
    r"\b(?:get_parameters|get_parameters_by_prefix|list_parameters|declare_parameters|ParameterEventHandler"
    r"|AsyncParametersClient|SyncParametersClient|ParamListener|set_parameters?|set_parameters_atomically"
    r"|add_(?:on|post|pre)_set_parameters_callback|pluginlib|ClassLoader|get_node_parameters_interface)\b"
    r"|\bget_parameter(?:_or)?\s{0,3}(?:<[\w:<> ]{1,60}>)?\s{0,3}\((?!\s{0,40}\")"
)
"""What may read parameters by names that are not literal, or in code of another package."""
_OF_ROS = ("use_sim_time", "qos_overrides", "robot_description")

_NEAR = 400
"""Blanks and comments around a declaration, at most."""


class UnreadInCpp(NamedTuple):
    source: Source
    parameter: Parameter
    given: Span
    """Where a launch or parameter file of the package sets it."""


def unread_in_cpp(nodes: Nodes) -> Iterator[UnreadInCpp]:
    for node in nodes.cpp:
        if node.declares_others or not node.parameters or nodes.launch.workspace.is_vendored(node.source):
            continue
        texts = package_texts(nodes, node.source)
        if any(_READS_OTHERS.search(text) for text in texts):
            continue
        for parameter in node.parameters:
            name = str(parameter.name)
            if not name.startswith(_OF_ROS) and _is_dropped(node.source, parameter):
                named = sum(text.count(f'"{name}"') for text in texts)
                given = given_in_package(nodes, node.source, name) if named == 1 else None
                if given is not None:
                    yield UnreadInCpp(node.source, parameter, given)


def _is_dropped(source: Source, parameter: Parameter) -> bool:
    """Whether a declaration is a statement of its own, whose value nobody takes."""
    start, end = parameter.span.start, parameter.span.end
    plain = plain_of(source)
    before, after = plain[max(start - _NEAR, 0) : start].rstrip(), plain[end : end + _NEAR].lstrip()
    return before.endswith((";", "{", "}")) and after.startswith(";")
