"""Values of messages in another unit than their definitions give."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.questions.messages.units_in_cpp import in_cpp
from bringup_lint.graph.nodes.questions.messages.units_in_python import in_python
from bringup_lint.graph.nodes.questions.messages.wrong_unit import WrongUnit

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes


def wrong_units(nodes: Nodes) -> Iterator[WrongUnit]:
    """Percentages where a share of 1 is meant, degrees where radians are, and what chips give in units of their own.

    A limit in percent is right where the tree itself publishes percentages: only what goes out is told then."""
    found = [each for types in nodes.message_types for each in in_python(nodes, types)]
    found += [each for source in nodes.cpp for each in in_cpp(source.source)]
    sent = {each.type for each in found if not each.is_read}
    yield from (each for each in found if not each.is_read or each.type not in sent)
