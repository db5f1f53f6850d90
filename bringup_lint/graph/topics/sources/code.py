"""What the sources of the tree say about a program: its endpoints, and whether these are all."""

from __future__ import annotations

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.model.node_source import Endpoint
from bringup_lint.model.node_source import NodeClass
from bringup_lint.source import Located
from bringup_lint.source import Source


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
