"""Lifecycle managers of nav2 against the nodes that they bring up."""

from __future__ import annotations

from collections.abc import Iterator
from collections.abc import Sequence
from functools import cached_property

from bringup_lint.dataclass import dataclass
from bringup_lint.facts.ros.node_roles import Role
from bringup_lint.facts.ros.node_roles import lifecycle_names
from bringup_lint.graph.launch.expansion import Expansion
from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.launch.resolve import truth
from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.workspace import place
from bringup_lint.model.launch import ComposableNode
from bringup_lint.model.launch import Emit
from bringup_lint.model.launch import Node
from bringup_lint.model.launch import Other
from bringup_lint.model.launch_values import DictValue
from bringup_lint.model.launch_values import ListValue
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import TypedValue
from bringup_lint.model.launch_values import Value
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located

MANAGERS = ("lifecycle_manager", "nav2_lifecycle_manager::LifecycleManager")
NAV2_INCLUDES = ("nav2_bringup",)
"""Packages whose launch files start nodes of nav2 only."""

_LIST = regex(r"\[[\w/,\s'\"]*\]\Z")
_NAME = regex(r"([\w/]+)")


class Setting(NamedTuple):
    value: Value | None
    known: bool
    """False when a parameter file or an unknown source may say otherwise."""
    name: Located | None = None
    """The key, where it is written."""


class Managed(NamedTuple):
    name: Located
    """As the manager lists it."""
    fqn: str


def _written_list(value: Value) -> list[Located] | None:
    """The names of ``value="[one, other]"`` in XML, which launch reads as YAML; None of anything else."""
    text = literal_text(value)
    match = _LIST.match(text) if text is not None else None
    if text is None or match is None:
        return None
    return [text.part(*each.span(1)) for each in _NAME.finditer(text)]


@dataclass(eq=False)
class Manager:
    node: Started

    @cached_property
    def names(self) -> Setting:
        return setting(self.node, "node_names")

    @cached_property
    def managed(self) -> list[Managed] | None:
        """The nodes in order; None when the list is not known to the end."""
        value = self.names.value
        written = _written_list(value) if value is not None else None
        if written is not None:
            return self.called(written)
        if not isinstance(value, ListValue) or value.open:
            return None
        return self.called([literal_text(item) for item in value.items])

    def called(self, names: Sequence[Located | None]) -> list[Managed] | None:
        """The nodes of these names, as the manager looks for them; None when one is not known."""
        if self.node.namespace is None:
            return None
        result = []
        for name in names:
            if name is None:
                return None
            result.append(Managed(name, name if name.startswith("/") else f"{self.node.namespace.rstrip('/')}/{name}"))
        return result

    @cached_property
    def autostart(self) -> Setting:
        return setting(self.node, "autostart")

    @cached_property
    def bond_timeout(self) -> Setting:
        return setting(self.node, "bond_timeout")

    @property
    def watches(self) -> bool | None:
        """Whether it notices that a node dies; None when that is not known."""
        value, known, _ = self.bond_timeout
        if value is None:
            return True if known else None
        try:
            return float(text_of(value) or "") > 0
        except ValueError:
            return None

    def parameters(self) -> Iterator[tuple[Located, Value]]:
        """The literal keys given in the launch file itself."""
        action = self.node.action
        if not isinstance(action, (Node, ComposableNode)):
            return
        for source in action.parameters:
            if isinstance(source, DictValue):
                for key, value in source.items:
                    name = literal_text(key)
                    if name is not None:
                        yield name, value


def setting(node: Started, key: str) -> Setting:
    """A parameter as the launch file gives it; the last source wins."""
    for source in reversed(node.parameters):
        if not isinstance(source, DictValue):
            return Setting(None, False)
        for name, value in reversed(source.items):
            if text_of(name) == key:
                inner = value.value if isinstance(value, TypedValue) else value
                return Setting(inner, True, literal_text(name))
        if source.open or any(not isinstance(name, Literal) for name, _ in source.items):
            return Setting(None, False)
    return Setting(None, True)


def managers(expansion: Expansion) -> list[Manager]:
    return [
        Manager(node)
        for node in expansion.nodes
        if literal_text(node.package) == "nav2_lifecycle_manager"
        and (literal_text(node.executable) in MANAGERS or literal_text(node.plugin) in MANAGERS)
    ]


def full_name(node: Started, role: Role) -> str | None:
    """The node's fully qualified name; without ``name=`` that of its code, where this is known."""
    if node.name is None and node.namespace is not None and role.role:
        executable = literal_text(node.executable)
        if executable is not None and executable in lifecycle_names():
            return f"{node.namespace.rstrip('/')}/{executable}"
    return node.fqn


def transitions_elsewhere(expansion: Expansion, node: Started) -> bool:
    """Whether something else than a manager configures a node, or may do so."""
    action = node.action
    if isinstance(action, Node) and action.autostart is not None and truth(action.autostart) is not False:
        return True
    for other, _ in expansion.actions:
        if isinstance(other, Emit) and other.event in ("change-state", ""):
            if other.target == action.key or other.target is None:
                return True
    for process in expansion.nodes:
        words = [text_of(word) or "" for word in process.arguments]
        if any("lifecycle" in word for word in words) and not process.is_node:
            return True
    return False


def outside(expansion: Expansion) -> bool:
    """Whether nodes may start that are not known; launch files of nav2 start nodes of nav2 only."""
    if any(isinstance(action, Other) for action, _ in expansion.actions):
        return True
    for include in expansion.includes:
        target = place(include.file)
        if include.target is None and (target is None or target.package not in NAV2_INCLUDES):
            return True
    return False
