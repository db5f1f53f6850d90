"""One model for Python, XML and YAML launch files: actions in the order in which launch visits them."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import count

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.model.launch_tag import Tag
from bringup_lint.model.launch_values import Argument
from bringup_lint.model.launch_values import Choice
from bringup_lint.model.launch_values import Condition
from bringup_lint.model.launch_values import DictValue
from bringup_lint.model.launch_values import Operation
from bringup_lint.model.launch_values import Value
from bringup_lint.model.launch_values import understood
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source
from bringup_lint.source import Span

_keys = count()


@dataclass(eq=False, slots=True, kw_only=True)
class Action:
    """Something launch does. ``key`` stays the same when the same object is placed at several spots."""

    span: Span
    conditions: tuple[Condition, ...] = ()
    key: int = field(default_factory=_keys.__next__)


@dataclass(eq=False, slots=True, kw_only=True)
class DeclareArgument(Action):
    name: Value
    default: Value | None = None
    description: Value | None = None
    choices: tuple[Value, ...] | None = None


@dataclass(eq=False, slots=True, kw_only=True)
class SetArgument(Action):
    """``SetLaunchConfiguration`` or ``<let>``."""

    name: Value
    value: Value


@dataclass(eq=False, slots=True, kw_only=True)
class UnsetArgument(Action):
    """``UnsetLaunchConfiguration``; every argument is unset when there is no name."""

    name: Value | None = None


@dataclass(eq=False, slots=True, kw_only=True)
class Include(Action):
    file: Value
    arguments: tuple[tuple[Value, Value], ...] = ()
    open: bool = False
    """More arguments may be passed than are known."""


class OldKeyword(NamedTuple):
    """A keyword argument that only old distributions have."""

    owner: str
    """The class that is called."""
    name: Located
    now: str
    """What it is called today."""
    is_doubled: bool
    """Whether the call has that keyword, too."""


class UnboundName(NamedTuple):
    """A name that Python code looks up, and that no statement of its file binds."""

    name: Located
    is_conditional: bool
    """The code that looks it up runs only under a condition."""
    arguments: tuple[str, ...] = ()
    """The launch arguments of which that condition is made."""


class UnplacedAction(NamedTuple):
    """An action that Python code keeps in a variable which nothing reads, or makes and keeps nowhere."""

    variable: Located
    """Or the class of what is not kept."""
    owner: str
    """The class of the action."""
    name: str
    """The first argument, or ``name=``, where it is a text."""
    executable: str = ""
    is_kept: bool = True


class RefusedCall(NamedTuple):
    """A call of a class of launch or launch_ros that ends with an exception, in every distribution."""

    code: str
    """``keyword`` (not known), ``missing``, ``positional`` (given without a name), or what the value should be:
    ``text``, ``words``, ``pairs``, ``seconds``, ``truth``, ``actions``, ``action``, ``registered``, ``function``,
    ``condition``, and further ones of parsers/launch_python/value_checks.py."""
    owner: str
    """The class that is called."""
    word: str
    """The keyword, or those that are missing, with commas."""
    where: Span
    given: str = ""
    """The number, truth value or None where a text is needed, as Python writes it."""


@dataclass(eq=False, slots=True, kw_only=True)
class Process(Action):
    """A process. ``options`` holds the further keywords by their Python names: ``respawn``, ``output``, ``prefix``."""

    cmd: tuple[Value, ...] = ()
    name: Value | None = None
    env: tuple[tuple[Value, Value], ...] | None = None
    """Replaces the whole environment when given."""
    additional_env: tuple[tuple[Value, Value], ...] = ()
    options: dict[str, Value] = field(default_factory=dict)
    on_exit: tuple[Action, ...] = ()
    open: bool = False
    """Further keywords may exist than are known (``**options``)."""


@dataclass(eq=False, slots=True, kw_only=True)
class Node(Process):
    package: Value | None = None
    executable: Value | None = None
    namespace: Value | None = None
    parameters: tuple[Value, ...] = ()
    """In order; later ones win: ``ParameterFile``, ``DictValue``, or a value that names a file."""
    remappings: tuple[tuple[Value, Value], ...] = ()
    arguments: tuple[Value, ...] = ()
    ros_arguments: tuple[Value, ...] = ()
    lifecycle: bool = False
    """Started as ``LifecycleNode``: launch itself offers its transitions."""
    autostart: Value | None = None
    container: bool = False
    components: tuple[ComposableNode | Other, ...] = ()


@dataclass(eq=False, slots=True, kw_only=True)
class ComposableNode(Action):
    """A component that a container loads."""

    package: Value | None = None
    plugin: Value | None = None
    name: Value | None = None
    namespace: Value | None = None
    parameters: tuple[Value, ...] = ()
    remappings: tuple[tuple[Value, Value], ...] = ()
    extra_arguments: tuple[Value, ...] = ()
    lifecycle: bool = False
    autostart: Value | None = None
    open: bool = False


@dataclass(eq=False, slots=True, kw_only=True)
class LoadComponents(Action):
    """``LoadComposableNodes``; the target is a name, or the key of a container action."""

    target: Value | None = None
    target_key: int | None = None
    components: tuple[ComposableNode | Other, ...] = ()


@dataclass(eq=False, slots=True, kw_only=True)
class Group(Action):
    actions: tuple[Action, ...] = ()
    scoped: Value | None = None
    forwarding: Value | None = None
    arguments: tuple[tuple[Value, Value], ...] = ()


@dataclass(eq=False, slots=True, kw_only=True)
class SetRemap(Action):
    src: Value
    dst: Value


@dataclass(eq=False, slots=True, kw_only=True)
class SetParameter(Action):
    name: Value
    value: Value


@dataclass(eq=False, slots=True, kw_only=True)
class SetParametersFromFile(Action):
    file: Value


@dataclass(eq=False, slots=True, kw_only=True)
class PushNamespace(Action):
    namespace: Value


@dataclass(eq=False, slots=True, kw_only=True)
class SetEnv(Action):
    name: Value
    value: Value
    mode: str = "set"
    """``set``, ``append`` or ``prepend``."""
    separator: Value | None = None
    """What is between the old text and the new; a colon when it is not given."""


@dataclass(eq=False, slots=True, kw_only=True)
class UnsetEnv(Action):
    """One variable, or the whole environment when there is no name."""

    name: Value | None = None


@dataclass(eq=False, slots=True, kw_only=True)
class Scope(Action):
    """``PushEnvironment``, ``PopLaunchConfigurations`` and the like: ``what`` is ``environment`` or ``arguments``."""

    what: str
    push: bool


@dataclass(eq=False, slots=True, kw_only=True)
class Timer(Action):
    period: Value
    actions: tuple[Action, ...] = ()


@dataclass(eq=False, slots=True, kw_only=True)
class EventHandler(Action):
    """``event`` is the class name (``OnProcessExit``); ``target`` the key of the action it waits for."""

    event: str
    target: int | None = None
    actions: tuple[Action, ...] = ()
    options: dict[str, Value] = field(default_factory=dict)


@dataclass(eq=False, slots=True, kw_only=True)
class Emit(Action):
    """``event`` is ``shutdown``, ``change-state`` or the class name of another event."""

    event: str
    target: int | None = None
    names: tuple[Value, ...] = ()
    """For ``change-state``: the lifecycle nodes by name, when not by action."""
    transition: Value | None = None


@dataclass(eq=False, slots=True, kw_only=True)
class Log(Action):
    message: Value | None = None


@dataclass(eq=False, slots=True, kw_only=True)
class Opaque(Action):
    """A function that the run calls; its actions as far as they could be followed."""

    function: str
    actions: tuple[Action, ...] = ()


@dataclass(eq=False, slots=True, kw_only=True)
class Other(Action):
    """An action that is not understood; it may start or set anything."""

    why: str
    actions: tuple[Action, ...] = ()


class Import(NamedTuple):
    """``from module import name``."""

    module: str
    name: Located


class Call(NamedTuple):
    """A call of interest in a launch file's own code, such as ``open`` or ``os.path.expanduser``."""

    name: str
    span: Span
    arguments: tuple[Value, ...]
    deferred: bool
    """Inside a function that only the run calls, not while the description is built."""


class Wait(NamedTuple):
    """A call in a launch file's own code that holds up the whole launch."""

    name: str
    """The function that pauses, or the program that is run to its end."""
    span: Span
    seconds: float | None = None
    """Of a pause, all rounds of its loop together; None for a program, whose failure is an exception."""
    is_before: bool = False
    """It is over before launch has anything to start: code of the module, or of generate_launch_description."""


class ObjectAsValue(NamedTuple):
    """A ``LaunchConfiguration`` that code takes for its text."""

    how: str
    """``compared``, ``compared with nothing``, ``condition``, ``text``, ``path``, ``number``, ``added``, ``looked-up``,
    ``argument-name`` or ``configuration-name``."""
    span: Span
    argument: Argument


@dataclass(eq=False, slots=True)
class Coverage:
    """How much of a launch file was understood."""

    nodes: int = 0
    understood: int = 0
    """Nodes whose package, executable, name and parameter sources hold nothing Unknown."""
    unknown_actions: int = 0

    @property
    def share(self) -> float:
        """0 to 1; an unknown action counts like a node that was not understood."""
        total = self.nodes + self.unknown_actions
        return self.understood / total if total else 1.0


@dataclass(eq=False, slots=True)
class LaunchFile:
    source: Source
    format: str
    """``python``, ``xml`` or ``yaml``."""
    actions: tuple[Action, ...] = ()
    problems: list[Problem] = field(default_factory=list)
    entry: Span | None = None
    """The entry function's name, or the root of the document."""
    reads: list[Argument] = field(default_factory=list)
    """Every launch configuration that the file mentions, also in code that was not followed to the end."""
    expressions: list[Operation] = field(default_factory=list)
    """Every Python expression of a Python launch file that launch evaluates."""
    bound: list[tuple[Argument, str]] = field(default_factory=list)
    """Those of them that Python code only assigns to a variable, with its name."""
    reads_all: bool = False
    """Looks at launch configurations by names that are not known, or at the words of the command line."""
    imports: list[Import] = field(default_factory=list)
    calls: list[Call] = field(default_factory=list)
    keywords: list[OldKeyword] = field(default_factory=list)
    """Keyword arguments of nodes that only old distributions have."""
    refused: list[Problem] = field(default_factory=list)
    """What launch_ros does not take: ``not-a-list``, ``action``, ``key``, ``nested-list``, ``list-of-maps`` and
    ``nothing`` in ``parameters=``, ``remapping``."""
    calls_refused: list[RefusedCall] = field(default_factory=list)
    """What the constructors of launch and launch_ros do not take."""
    objects: list[ObjectAsValue] = field(default_factory=list)
    bare_excepts: list[Span] = field(default_factory=list)
    waits: list[Wait] = field(default_factory=list)
    unbound: list[UnboundName] = field(default_factory=list)
    """Names that Python code looks up and that nothing binds."""
    unplaced: list[UnplacedAction] = field(default_factory=list)
    """Actions that Python code makes and hands to nothing."""
    idle: list[Span] = field(default_factory=list)
    """Values that Python code keeps in variables which nothing uses."""
    tag: Tag | None = None
    """The root of an XML or YAML file, as it is written."""
    ros1: list[Located] = field(default_factory=list)
    """Names that only ROS 1 launch knows."""

    @property
    def coverage(self) -> Coverage:
        result = Coverage()
        for action in walk_actions(self.actions):
            if isinstance(action, (Node, ComposableNode)):
                result.nodes += 1
                result.understood += node_understood(action)
            elif isinstance(action, Other):
                result.unknown_actions += 1
        return result


def node_understood(node: Node | ComposableNode) -> bool:
    """True when package, executable, name, namespace and parameter sources are understood."""
    program = node.executable if isinstance(node, Node) else node.plugin
    identity = (node.package, program, node.name, node.namespace)
    return not node.open and all(map(understood, identity)) and all(map(_source_understood, node.parameters))


def _source_understood(parameters: Value) -> bool:
    """Which file, or which names; the value of an inline parameter may be anything."""
    if isinstance(parameters, DictValue):
        return not parameters.open and all(understood(name) for name, _ in parameters.items)
    if isinstance(parameters, Choice):
        return all(_source_understood(option) for _, option in parameters.options)
    return understood(parameters)


def nested(action: Action) -> tuple[Action, ...]:
    """The actions directly inside: of groups, timers, handlers, containers."""
    if isinstance(action, Node):
        return (*action.components, *action.on_exit)
    if isinstance(action, Process):
        return action.on_exit
    if isinstance(action, LoadComponents):
        return action.components
    return getattr(action, "actions", ())


def walk_actions(actions: tuple[Action, ...]) -> Iterator[Action]:
    """All actions, depth first, in the order of the description."""
    todo = list(reversed(actions))
    while todo:
        action = todo.pop()
        yield action
        todo.extend(reversed(nested(action)))
