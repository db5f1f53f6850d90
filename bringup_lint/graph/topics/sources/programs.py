"""From what a launch file starts to the code that the tree holds of it, in Python or C++."""

from __future__ import annotations

from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.nodes.nodes import Nodes
from bringup_lint.graph.nodes.resolved.programs import Program
from bringup_lint.graph.topics.sources.code import Code
from bringup_lint.graph.topics.sources.cpp_code import CppCode
from bringup_lint.graph.topics.sources.self_registration import registers_itself
from bringup_lint.graph.workspace import Workspace
from bringup_lint.model.node_source import NodeClass


def code_of(started: Started, nodes: Nodes, workspace: Workspace, cpp: CppCode) -> Code | None:
    """None when the sources are not in the tree."""
    program = nodes.program_of(started)
    if program is not None:
        return _python(nodes, program)
    package = workspace.packages.get(str(literal_text(started.package)))
    word = started.program
    return cpp.code(package, str(word)) if package is not None and word is not None else None


def _python(nodes: Nodes, program: Program) -> Code:
    code = Code(source=program.file.source, several=len(program.classes) != 1)
    for node in program.classes:
        code.endpoints += node.all_endpoints
    if len(program.classes) == 1:
        node = code.node_class = program.classes[0]
        code.name, code.namespace = node.node_name, node.namespace
        code.complete = all(each.name is not None for each in code.endpoints) and _is_complete(nodes, node)
    return code


def _is_complete(nodes: Nodes, node: NodeClass) -> bool:
    """Whether the classes that a node builds on make no endpoints but those that are known."""
    for each in node.lineage:
        file = nodes.file_of(each)
        if each.is_node is not True or file.strays or registers_itself(each, file):
            return False
    return True
