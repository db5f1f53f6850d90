"""Publishers of lifecycle nodes that no transition activates."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.endings import CPP
from bringup_lint.graph.nodes.sources.with_header import with_header
from bringup_lint.model.cpp_text import COMMENT
from bringup_lint.model.node_source import Endpoint
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.model.cpp_source import CppNode
    from bringup_lint.source import Source

_ACTIVATES = regex(
    r"(?:->|\.)\s{0,4}on_activate\s{0,4}\(|\w\s{0,4}::\s{0,4}on_activate\s{0,4}\(\s{0,4}\w{0,80}\s{0,4}\)"
)
"""A call of a publisher, or of a base class under any name; what defines the method has a type before the name."""
_PLAIN = regex(r"\brclcpp::Publisher\s{0,4}<")
"""Through a pointer to the plain class ``publish`` is that of the plain class, which does not ask."""
_MOST = 200_000
"""Characters of a source that are looked at."""


class InactivePublisher(NamedTuple):
    source: Source
    transition: Located
    """``on_activate``, where it is defined."""
    publishers: list[Endpoint]


def inactive_publishers(nodes: Nodes) -> Iterator[InactivePublisher]:
    """The lifecycle nodes whose own ``on_activate`` neither calls that of rclpy or rclcpp nor those of publishers."""
    for file, node in nodes.node_classes:
        method = node.methods.get("on_activate") if node.is_lifecycle else None
        sent = [each for each in node.all_endpoints if each.role == "publisher" and each.lifecycle]
        if method is not None and sent and not any(".on_activate(" in each.source.text for each in node.lineage):
            yield InactivePublisher(file.source, method.name, sent)
    for source in nodes.cpp:
        if source.activation is not None:
            sent = list(_sent(nodes, source))
            if sent:
                yield InactivePublisher(source.source, source.activation, sent)


def _sent(nodes: Nodes, source: CppNode) -> Iterator[Endpoint]:
    """The lifecycle publishers of a file on which it publishes, when nothing activates any."""
    text = COMMENT.sub("", with_header(nodes, source.source))
    if _ACTIVATES.search(text) or _PLAIN.search(text) or "LifecyclePublisher" not in text:
        return
    activating = [other for other in _beside(nodes, source.source) if _ACTIVATES.search(other)]
    for each in source.endpoints:
        if any(each.attribute and each.attribute in other for other in activating):
            continue
        own = each.role == "publisher" and each.span.text.startswith(("create_publisher", "this->create_publisher"))
        if own and each.attribute and re.search(rf"\b{re.escape(each.attribute)}\s{{0,4}}->\s{{0,4}}publish\b", text):
            yield each


def _beside(nodes: Nodes, source: Source) -> Iterator[str]:
    """The code of the package that a file is in, or of its folder; also what does not look like that of a node."""
    owner = nodes.launch.workspace.owner(source)
    folder = owner.folder if owner is not None else os.path.dirname(source.absolute)
    for path in nodes.files.tree.walked_below(folder):
        if path.endswith(CPP):
            yield COMMENT.sub("", nodes.files.tree.head(path, _MOST))
