"""The numbers and switches that parameter files give nodes, to be compared with what the nodes have."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.params.loads import RCL
from bringup_lint.model.params import Value
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.params.params import Params

_TYPES = ("bool", "integer", "double")
"""Texts and lists are left out: a text may be a secret."""


class Given(NamedTuple):
    """What one file says, where nothing else says otherwise."""

    node: str
    """Fully qualified."""
    name: str
    value: Value
    where: Span

    def is_like(self, text: str) -> bool:
        """Whether a running node has the same value; also for what cannot be compared."""
        if self.value.type == "bool":
            return text not in ("true", "false") or text == str(self.value.data).lower()
        try:
            return math.isclose(float(text), float(str(self.value.data)), rel_tol=1e-9)
        except ValueError:
            return True


def given(params: Params) -> list[Given]:
    """The values that surely reach a node, by node and name; none for which files disagree."""
    found: dict[tuple[str, str], Given] = {}
    disputed = set()
    for each in _all(params):
        key = (each.node, each.name)
        if found.setdefault(key, each).value != each.value:
            disputed.add(key)
    return [each for key, each in found.items() if key not in disputed]


def _all(params: Params) -> Iterator[Given]:
    for file, parameter in params.parameters:
        value = params.winner(file, parameter)
        if value is None or value.type not in _TYPES or not file.accepted:
            continue
        for load in params.effective(file, parameter):
            node = load.node.fqn
            plain = load.how == RCL and load.certain and load.root_key is None and not load.substitutes
            if node is not None and plain:
                yield Given(node, parameter.name, value, parameter.span)
