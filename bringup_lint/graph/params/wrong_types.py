"""Values of a parameter file that have another type than their node declares."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.params.public import of_wrong_public_type
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.params.params import Params
    from bringup_lint.graph.params.values import Item
    from bringup_lint.model.params import Parameter


class WrongType(NamedTuple):
    parameter: Parameter
    items: list[Item]
    """Those of an array; a single value is one."""
    package: str = ""
    """The public package of which a node declares it; empty for a node of the workspace."""
    declared: Located | None = None
    """Where the workspace declares it."""

    @property
    def node(self) -> str:
        return self.package or "the node"


def wrong_types(params: Params, launch: Launch, given: str, declared: str) -> Iterator[WrongType]:
    """The values of one type that a node of the workspace or a public one declares as another; arrays of them too."""
    for parameter, found, items in params.of_wrong_type(given, declared):
        yield WrongType(parameter, items, declared=found.place)
    for parameter, node, items in of_wrong_public_type(params, launch, given, declared):
        yield WrongType(parameter, items, node.package)
