"""A topic as one launched node uses it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.topics.resolved.remapping import Remapping
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.topics.resolved.parameters import Given
    from bringup_lint.graph.topics.resolved.parameters import GivenParameters
    from bringup_lint.model.node_source import NodeClass
    from bringup_lint.model.node_source import Qos


@dataclass(eq=False, slots=True)
class Use:
    role: str
    """``publisher`` or ``subscription``; of a service or action ``service``, ``client``, ``action-server`` or
    ``action-client``."""
    topic: str
    """The full name, after namespace, parameters and remappings."""
    type: str | None
    """``geometry_msgs/msg/Twist``; None when it is not known, or depends on something."""
    qos: Qos | None
    node: LaunchedNode
    where: Span
    """The call in the source, or the node in the launch file when only the table knows its topics."""
    written: Located | str
    """The name before it was expanded."""
    remapping: Remapping | None = None
    given: Span | None = None
    """The parameter's value that gives the name."""
    type_given: Span | None = None
    """The parameter's value that decides its type."""
    of_table: bool = False
    shown: bool = False
    """A display of RViz: only a person looks at it."""
    implied: bool = False
    """Made inside a library class, such as a ``TransformListener``."""
    conditional: bool = False
    lifecycle: bool = False
    method: str | None = None
    """The function that makes it."""
    qos_parameter: Span | None = None
    """The value in the configuration that decides its quality of service."""

    @property
    def verb(self) -> str:
        return "publishes" if self.role == "publisher" else "subscribes to"

    @property
    def qos_place(self) -> Span:
        """Where its quality of service is written: a parameter, the profile, or the node in the launch file."""
        if self.qos_parameter is not None:
            return self.qos_parameter
        return self.where if self.of_table or self.qos is None else self.qos.span

    @property
    def conditional_source(self) -> bool:
        """Whether the source makes it only under some condition; what C++ does is not known."""
        return self.conditional and self.node.node_class is not None

    @property
    def name_place(self) -> Span | None:
        """Where its name comes from: a parameter, a remapping, or the text in the source."""
        if self.remapping is not None:
            return self.remapping.where
        if self.given is not None:
            return self.given
        return self.written.span if isinstance(self.written, Located) else None


@dataclass(eq=False, slots=True)
class LaunchedNode:
    started: Started
    name: str | None
    """The bare name; None when it is not known."""
    namespace: str | None
    node_class: NodeClass | None = None
    """Its class, when its source is in the tree."""
    given: GivenParameters | None = None
    uses: list[Use] = field(default_factory=list)
    calls: list[Use] = field(default_factory=list)
    """Its services and actions, and those that it calls, as far as the sources of the tree tell their names."""
    complete: bool = False
    """It uses no other topics than these, as far as launch files and sources can tell."""
    refused: list[Given] = field(default_factory=list)
    """Parameters that give a topic a name which rcl does not take."""

    @property
    def fqn(self) -> str | None:
        if self.name is None or self.namespace is None:
            return None
        return f"{self.namespace.rstrip('/')}/{self.name}"

    def label(self) -> str:
        """What to call it in a message."""
        return self.fqn or self.started.label()


class Pair(NamedTuple):
    publisher: Use
    subscription: Use


@dataclass(eq=False)
class Running:
    """Nodes that run together: those of one launch file, of the units of one boot, or of one compose project."""

    label: str
    nodes: list[LaunchedNode] = field(default_factory=list)
    complete: bool = False
    """All topics of all nodes are known."""
    whole: bool = False
    """Nothing else of ROS runs beside them."""
    simulated: bool = False
    """For a simulator, a test or a look at a model."""

    @property
    def uses(self) -> Iterator[Use]:
        for node in self.nodes:
            yield from node.uses

    @property
    def calls(self) -> Iterator[Use]:
        for node in self.nodes:
            yield from node.calls

    def by_topic(self) -> dict[str, list[Use]]:
        found: dict[str, list[Use]] = {}
        for use in self.uses:
            found.setdefault(use.topic, []).append(use)
        return found
