"""What the sources of the tree say about a launched program: its endpoints, and whether these are all."""

from __future__ import annotations

from dataclasses import dataclass
from dataclasses import field
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.topics.sources.self_registration import hands_itself_over
from bringup_lint.model.node_source import Endpoint
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.topics.sources.cpp_code import CppCode
    from bringup_lint.model.node_source import NodeClass
    from bringup_lint.robot import Robot


@dataclass(eq=False)
class Code:
    name: Located | None = None
    """What the node calls itself, when that is literal and the program makes only one node."""
    namespace: Located | None = None
    endpoints: list[Endpoint] = field(default_factory=list)
    complete: bool = False
    """There are no other endpoints."""
    node_class: NodeClass | None = None
    source: Source | None = None
    several: bool = False
    """The program may make more than one node."""


def code_of(robot: Robot, started: Started, cpp: CppCode) -> Code | None:
    """None when the sources are not in the tree."""
    program = robot.nodes.program_of(started)
    if program is not None:
        return _python(robot, program)
    package = robot.launch.workspace.packages.get(str(literal_text(started.package)))
    word = literal_text(started.plugin) or literal_text(started.executable)
    return cpp.code(package, str(word)) if package is not None and word is not None else None


def _python(robot: Robot, program) -> Code:
    code = Code(source=program.file.source, several=len(program.classes) != 1)
    for node in program.classes:
        code.endpoints += node.all_endpoints
    if len(program.classes) == 1:
        node = code.node_class = program.classes[0]
        code.name, code.namespace = node.node_name, node.namespace
        lineage = list(node.lineage)
        known = all(each.is_node is True for each in lineage) and all(e.name is not None for e in code.endpoints)
        files = {id(each.source): robot.nodes.file_of(each) for each in lineage}
        whole = known and not any(file.strays for file in files.values())
        code.complete = whole and not any(hands_itself_over(each, robot.nodes.file_of(each)) for each in lineage)
    return code
