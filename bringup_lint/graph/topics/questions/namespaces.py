"""Topics that leave the namespace of their node."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.graph.topics.questions.unmatched import EVERYWHERE
from bringup_lint.graph.topics.resolved.endpoint_use import Running
from bringup_lint.graph.topics.resolved.endpoint_use import Use
from bringup_lint.source import Located
from bringup_lint.source import Span


def shared_by_namespaces(running: Running) -> Iterator[list[Use]]:
    """The uses, from one place in a source, of an absolute topic by nodes in several namespaces, when no node outside
    these uses the topic: then nothing says that it is meant for all."""
    for topic, uses in running.by_topic().items():
        if topic in EVERYWHERE or any(use.node.namespace in (None, "/") for use in uses):
            continue
        places: dict[Span, list[Use]] = {}
        for use in uses:
            plain = isinstance(use.written, Located) and use.remapping is None and use.given is None
            sure = use.node.started.by_default is True and not use.implied
            if plain and sure and not use.of_table and use.written.startswith("/"):
                places.setdefault(use.where, []).append(use)
        yield from (same for same in places.values() if len({use.node.namespace for use in same}) > 1)
