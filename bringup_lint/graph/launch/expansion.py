"""What one entry leads to: nodes, includes, declarations, and what is read without being there."""

from __future__ import annotations

from functools import cached_property

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.graph.launch.scope import Binding
from bringup_lint.graph.launch.started import Started
from bringup_lint.model.launch import Action
from bringup_lint.model.launch import DeclareArgument
from bringup_lint.model.launch import EventHandler
from bringup_lint.model.launch import Include
from bringup_lint.model.launch import LaunchFile
from bringup_lint.model.launch import LoadComponents
from bringup_lint.model.launch_values import Argument
from bringup_lint.model.launch_values import Condition
from bringup_lint.model.launch_values import Value
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Span


class Included(NamedTuple):
    """An include as it happens: the target is None when the file is not in the tree."""

    action: Include
    file: Value
    source: LaunchFile
    target: LaunchFile | None
    arguments: dict[str, Value]
    values: dict[str, Value]
    """The arguments as they are when launched without any."""
    conditions: tuple[Condition, ...]
    chain: tuple[Span, ...]
    known: frozenset[str]
    """The launch configurations that exist before the include, without those that it passes."""
    context: tuple[Action, ...] = ()
    """The timers and handlers that it waits for."""


class Loaded(NamedTuple):
    """A request to load components into a container, as it happens."""

    action: LoadComponents
    target: Value | None
    """The container's name."""
    file: LaunchFile
    conditions: tuple[Condition, ...]
    by_default: bool | None
    """Whether it happens when no argument is passed."""


class Declared(NamedTuple):
    """A declaration as it happens."""

    action: DeclareArgument
    file: LaunchFile
    name: str
    before: Binding | None
    """The value that the configuration already had, so that the default is not used."""
    conditions: tuple[Condition, ...]
    chain: tuple[Span, ...]


class Failed(NamedTuple):
    """A Python expression in a condition that ends with an exception."""

    span: Span
    """The substitution."""
    text: str
    """What launch evaluates."""
    error: str
    names: frozenset[str]
    """The launch configurations in it."""
    file: LaunchFile
    by_default: bool | None
    """Whether launch comes here when no argument is passed."""
    chain: tuple[Span, ...]


class Used(NamedTuple):
    """A launch configuration that does not exist where it is read."""

    argument: Argument
    file: LaunchFile
    chain: tuple[Span, ...]
    conditions: tuple[Condition, ...]
    certain: bool
    """Nothing before it could have set the configuration unseen."""


@dataclass(eq=False)
class Expansion:
    """Everything that one entry leads to."""

    entry: LaunchFile
    nodes: list[Started] = field(default_factory=list)
    """Nodes, components and other processes, in the order in which they start."""
    includes: list[Included] = field(default_factory=list)
    loads: list[Loaded] = field(default_factory=list)
    declared: list[Declared] = field(default_factory=list)
    unbound: list[Used] = field(default_factory=list)
    failed: list[Failed] = field(default_factory=list)
    handlers: list[tuple[EventHandler, LaunchFile]] = field(default_factory=list)
    actions: list[tuple[Action, LaunchFile]] = field(default_factory=list)
    """Every action that was visited."""
    cycle: list[Included] = field(default_factory=list)
    """Includes that come back to a file that is still being read."""
    opaque: bool = False
    """Something is not understood: more may start, and more arguments may be read."""
    leaves_tree: bool = False
    """A file is included that is not in the tree."""
    is_lost: bool = False
    """Nothing is known of such a file, and so not what arguments it reads and declares."""
    outside: set[str] = field(default_factory=set)
    """The arguments of such files that are known."""
    arguments: dict[str, Binding] = field(default_factory=dict)
    """The launch configurations at the end."""

    @property
    def open(self) -> bool:
        """Something is not understood or not in the tree: more may start, and more arguments may be read."""
        return self.opaque or self.leaves_tree

    @cached_property
    def files(self) -> list[LaunchFile]:
        """Every file that is read; ask only when the expansion is done."""
        found = {id(file): file for _, file in self.actions}
        found.setdefault(id(self.entry), self.entry)
        return list(found.values())
