"""Answers that C++ nodes wait for without end, from servers that they never look for."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.sources.with_header import with_header
from bringup_lint.model.cpp_source import EndlessAnswer
from bringup_lint.model.cpp_text import blanked
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

_LOOKS = regex(
    r"(?:(?P<client>\b\w{1,80})\s{0,4}(?:->|\.)\s{0,4})?"
    r"\b(?:wait_for_(?:service|action_server)|service_is_ready|action_server_is_ready|get_service_names)"
)
_MAKES = regex(r"\b(?P<client>\w{1,80})\s{0,4}=[^;=]{0,200}\bcreate_client\b")


def endless_answers(nodes: Nodes) -> Iterator[list[EndlessAnswer]]:
    """Those of one file together, where it or its header makes the clients, and neither asks whether the server of
    each is there. Waits that block the executor which brings the answer are left to the question about these."""
    for node in nodes.cpp:
        unlooked = _unlooked(blanked(with_header(nodes, node.source))) if node.endless_answers else frozenset()
        blocking = {each.span for each in node.waits}
        found = [each for each in node.endless_answers if each.client in unlooked and each.waiting not in blocking]
        if found:
            yield found


def _unlooked(text: str) -> frozenset[str]:
    """The clients that a text makes and looks for no server of; none where it may look for those of all."""
    made = frozenset(found["client"] for found in _MAKES.finditer(text))
    looked = frozenset(found["client"] for found in _LOOKS.finditer(text))
    return made - looked if looked <= made else frozenset()
