"""Answers that C++ nodes wait for without end, from servers that they never look for."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.questions.with_header import with_header
from bringup_lint.model.cpp_source import EndlessAnswer
from bringup_lint.model.cpp_text import blanked
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

_LOOKS = regex(r"wait_for_(?:service|action_server)|(?:service|server)_is_ready|get_service_names")


def endless_answers(nodes: Nodes) -> Iterator[list[EndlessAnswer]]:
    """Those of one file together, where it or its header makes the clients and neither asks whether a server is
    there. Waits that block the executor which brings the answer are left to the question about these."""
    for node in nodes.cpp:
        text = blanked(with_header(nodes, node.source)) if node.endless_answers else ""
        if not text or _LOOKS.search(text):
            continue
        blocking = {each.span for each in node.waits}
        found = [
            each
            for each in node.endless_answers
            if each.waiting not in blocking
            and re.search(rf"\b{re.escape(each.client)}\s*=\s*[^;]{{0,200}}\bcreate_client\b", text)
        ]
        if found:
            yield found
