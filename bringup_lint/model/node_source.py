"""A Python source of ROS 2 nodes: its classes, what they publish and subscribe, and with which quality of service."""

from __future__ import annotations

import ast
from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator
from typing import Any
from typing import TypedDict

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.dataclass import replace
from bringup_lint.model.python import FunctionNode
from bringup_lint.model.python import PlacedNode
from bringup_lint.model.python import walk
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source
from bringup_lint.source import Span

INFINITE = float("inf")
"""A deadline or lease duration that is not set."""


TIMED = frozenset(
    f"{package}/msg/{name}"
    for package, names in {
        "nav_msgs": ("Odometry",),
        "sensor_msgs": (
            "Imu",
            "JointState",
            "LaserScan",
            "MagneticField",
            "NavSatFix",
            "PointCloud2",
            "Range",
            "Image",
        ),
        "geometry_msgs": ("TransformStamped", "TwistWithCovarianceStamped"),
    }.items()
    for name in names
)
"""Readings whose receivers place them in time. Commands and goals are left out: there, 0 means now."""
MEASURED = frozenset(
    "LaserScan PointCloud2 Image CompressedImage CameraInfo Imu Range Detection2DArray Detection3DArray "
    "AprilTagDetectionArray".split()
)
"""Types of readings that say when they were taken."""
DERIVED = MEASURED | frozenset(
    "PoseStamped PoseArray PointStamped PoseWithCovarianceStamped TransformStamped Odometry".split()
)
"""Types of what is computed from a reading, and placed in time like it."""
TRANSFORM = "geometry_msgs/msg/TransformStamped"
JOINTS = "sensor_msgs/msg/JointState"
"""A reading on ``joint_states``, and a command on other topics."""


def _unread(*_: object) -> Any:
    """Stands for the questions about a file whose syntax was not read."""
    return None


LINEAGE = 100
"""Classes that build on one another; more are read as if the last one built on nothing."""


@dataclass(frozen=True, slots=True)
class Qos:
    """A profile as far as it is known. None: not known. Policies by the names of ``rclpy.qos``: ``RELIABLE``,
    ``TRANSIENT_LOCAL``, ``KEEP_LAST``, ``AUTOMATIC``, ``SYSTEM_DEFAULT``, ``BEST_AVAILABLE``."""

    span: Span
    """Where the profile, or the number that stands for one, is written."""
    reliability: str | None = None
    durability: str | None = None
    history: str | None = None
    depth: int | None = None
    deadline: float | None = None
    """Seconds; ``INFINITE`` when none is offered or asked for."""
    liveliness: str | None = None
    lease: float | None = None
    """Seconds; ``INFINITE`` when not set."""


class QosChange(TypedDict, total=False):
    """The policies that something changes in a profile; None: to a value that is not known."""

    reliability: str | None
    durability: str | None
    history: str | None
    depth: int | None
    deadline: float | None
    liveliness: str | None
    lease: float | None


def with_policy(qos: Qos, name: str, value: str | None) -> Qos:
    """``name``: that of a policy whose values are names."""
    match name:
        case "reliability":
            return replace(qos, reliability=value)
        case "durability":
            return replace(qos, durability=value)
        case "history":
            return replace(qos, history=value)
        case "liveliness":
            return replace(qos, liveliness=value)
    raise ValueError(name)


def with_seconds(qos: Qos, name: str, value: float | None) -> Qos:
    """``name``: ``deadline`` or ``lease``."""
    return replace(qos, deadline=value) if name == "deadline" else replace(qos, lease=value)


class Group(NamedTuple):
    """A callback group: ``key`` is equal for the callbacks that share it."""

    key: str
    reentrant: bool | None
    """None when its type is not known."""


@dataclass(frozen=True, slots=True)
class Function:
    """A function or method of a source."""

    name: Located
    node: FunctionNode
    span: Span
    decorators: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Callback:
    """A function that an executor calls. ``role``: ``subscription``, ``timer``, ``service``, ``action`` (the goal is
    executed), ``action-step`` (accepted, cancelled), ``client``, ``parameters``, ``shutdown``."""

    role: str
    name: str | None
    """The method or function; None for a lambda or what is not known."""
    span: Span
    """Where it is handed over."""
    group: Group | None = None
    """None: the default group of the node."""
    function: ast.Lambda | None = None
    """The lambda itself."""

    @property
    def kind(self) -> str:
        """The role in a sentence: ``an action``."""
        return f"{'an' if self.role[0] == 'a' else 'a'} {self.role}"


@dataclass(frozen=True, slots=True)
class Endpoint:
    role: str
    """``publisher``, ``subscription``, ``client``, ``service``, ``action-client`` or ``action-server``."""
    type: str | None
    """``geometry_msgs/msg/Twist``, resolved through the imports of the file."""
    name: Located | None
    """As written, not expanded; the default of the parameter when the name comes from one."""
    parameter: Located | None
    """The declared parameter that gives the name."""
    qos: Qos | None
    """None for services and actions, and when nothing of it is known."""
    callback: str | None
    """The method or function that takes the messages."""
    callback_group: Group | None
    attribute: str | None
    """Where it is kept: ``self.pub``, or a variable."""
    lifecycle: bool
    """A lifecycle publisher, silent while its node is not active."""
    span: Span
    """The call."""
    conditional: bool = False
    """Under an ``if``, in a loop or in an exception handler."""
    method: str | None = None
    """The function in which it is made."""
    implied: bool = False
    """Made inside a library class, such as the publisher of a ``TransformBroadcaster``."""


def reports_joints(endpoints: Iterable[Endpoint]) -> bool:
    """Whether joint states are published, and no command of their type."""
    names = [str(each.name or "") for each in endpoints if each.role == "publisher" and each.type == JOINTS]
    return bool(names) and all(name.rpartition("/")[2] == "joint_states" for name in names)


@dataclass(frozen=True, slots=True)
class Timer:
    period: float | None
    """Seconds; None when not known."""
    callback: str | None
    attribute: str | None
    group: Group | None
    span: Span
    conditional: bool = False
    method: str | None = None


@dataclass(frozen=True, slots=True)
class Parameter:
    """``declare_parameter``. ``default`` is the literal value; ``known`` tells a literal None from one that is not."""

    name: Located
    default: str | int | float | bool | list[object] | None
    known: bool
    span: Span


class Misread(NamedTuple):
    """A parameter that is read as another type than it has."""

    place: Span
    """Where it is read."""
    name: Located
    """Where it is declared."""
    declared: str
    """``double``, ``integer``, ``bool`` or ``string``."""
    read: str
    call: str
    """The method or field by which it is read: ``as_int()``, ``integer_value``."""
    is_empty: bool = False
    """The read gives an empty value; else it throws."""


def type_of_default(value: object) -> str | None:
    """The type that a parameter gets from its default; None for lists and what is not known."""
    return {bool: "bool", int: "integer", float: "double"}.get(
        type(value), "string" if isinstance(value, str) else None
    )


@dataclass(eq=False, slots=True)
class NodeClass:
    """A class of nodes, or a single node that a function makes with ``rclpy.create_node`` or ``Node(...)``."""

    source: Source
    name: Located | None
    """The class; None for a node without one."""
    span: Span
    bases: tuple[str, ...] = ()
    """Dotted names, through the imports of the file; a class of the same file by its bare name."""
    base: NodeClass | None = None
    """The class it builds on, when that is in the same file or was found in the same package."""
    is_node: bool | None = None
    """True: a class of rclpy is among its bases. None: a base is not known."""
    is_lifecycle: bool = False
    node_name: Located | None = None
    """The literal name that the node gives itself."""
    namespace: Located | None = None
    endpoints: list[Endpoint] = field(default_factory=list)
    timers: list[Timer] = field(default_factory=list)
    parameters: dict[str, Parameter] = field(default_factory=dict)
    callbacks: list[Callback] = field(default_factory=list)
    methods: dict[str, Function] = field(default_factory=dict)
    variable: str | None = None
    """For a node without a class: the variable that holds it."""
    node: ast.ClassDef | None = None
    _inner: list[ast.AST] | None = field(default=None, init=False)

    @property
    def inner(self) -> list[ast.AST]:
        """All syntax of the class, as ``walk`` gives it; nothing of a node without one."""
        if self._inner is None:
            self._inner = list(walk(self.node)) if self.node is not None else []
        return self._inner

    @property
    def lineage(self) -> Iterator[NodeClass]:
        """The class itself, then those it builds on as far as they are known; no more than ``LINEAGE``."""
        seen: set[int] = set()
        current: NodeClass | None = self
        while current is not None and id(current) not in seen and len(seen) < LINEAGE:
            seen.add(id(current))
            yield current
            current = current.base

    @property
    def all_endpoints(self) -> list[Endpoint]:
        """Its own endpoints and those of the classes it builds on."""
        return [endpoint for each in self.lineage for endpoint in each.endpoints]

    @property
    def all_timers(self) -> list[Timer]:
        return [timer for each in self.lineage for timer in each.timers]

    def parameter(self, name: str) -> Parameter | None:
        """The declaration of a parameter in the class, or in the nearest that it builds on."""
        return next((each.parameters[name] for each in self.lineage if name in each.parameters), None)

    def method(self, name: str) -> Function | None:
        return next((each.methods[name] for each in self.lineage if name in each.methods), None)


@dataclass(eq=False, slots=True)
class NodeSource:
    source: Source
    classes: list[NodeClass] = field(default_factory=list)
    """All classes of nodes, also those of which a base is not known, and the nodes that functions make."""
    functions: dict[str, Function] = field(default_factory=dict)
    """The functions of the module."""
    imports: dict[str, str | None] = field(default_factory=dict)
    """Name in the file -> dotted name; None when several imports give it different meanings."""
    stars: list[str] = field(default_factory=list)
    """Modules of which everything is imported, as ``from x import *``."""
    strays: list[Endpoint] = field(default_factory=list)
    """Endpoints whose node is not known: made through a helper, or for a node that is handed over."""
    main: str | None = None
    """The function that ``if __name__ == "__main__"`` calls; ``main`` when there is one and no such block."""
    problems: list[Problem] = field(default_factory=list)
    tree: ast.Module | None = None
    nodes: list[ast.AST] = field(default_factory=list)
    """All syntax of the tree, as ``ast.walk`` gives it."""
    span_of: Callable[[PlacedNode], Span] = field(default=_unread)
    qualified: Callable[[ast.AST], str | None] = field(default=_unread)
    """The dotted name of a name or attribute, through the imports: ``rclpy.spin``."""
    constant: Callable[..., object] = field(default=_unread)
    """``constant(expression, function)``: the literal value of an expression that is in a function, or None."""
    named: Callable[..., str | None] = field(default=_unread)
    """``named(expression, function)``: the dotted name of what was imported, or called to make the value, or None."""
    joined: Callable[[Callable[[str], Any]], NodeSource] = field(default=_unread)
    """``joined(imported)``: the file read with the values of what it imports from other files; ``imported`` gives them
    by dotted names."""
    exported: Callable[[list[str], Callable[[str], Any]], Any] = field(default=_unread)
    """``exported(path, imported)``: the value of a name of the file, or of a class in it, for the files that import
    it."""
    is_alone: bool = True
    """Whether all that is said here follows from the text of the file."""
    let_go: Callable[[], None] = field(default=_unread)
    """Takes the syntax apart when nobody asks for it any more: its parts know each other, so that they would wait for
    a search for garbage."""

    def class_named(self, name: str) -> NodeClass | None:
        return next((each for each in self.classes if each.name == name), None)
