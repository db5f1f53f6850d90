"""A C++ source of nodes: what it makes, declares, opens and waits for."""

from __future__ import annotations

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.model.declared_again import DeclaredAgain
from bringup_lint.model.node_source import Callback
from bringup_lint.model.node_source import Endpoint
from bringup_lint.model.node_source import Misread
from bringup_lint.model.node_source import Parameter
from bringup_lint.model.node_source import Timer
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source
from bringup_lint.source import Span

UNTIL_OTHER_NODE = "until the other node appears"
"""How long a wait for a service without a timeout lasts."""
FOREVER = "forever"


class Lookup(NamedTuple):
    """A transform that is looked up outside every ``try``."""

    span: Span
    callback: Callback
    """The callback that does it."""


class Waiting(NamedTuple):
    """A call or loop that gives the executor nothing back for a while."""

    span: Span
    what: str
    """What it is, in words: ``sleep_for(2 s)``."""
    how_long: str
    """``for 2 s``, ``as long as the program runs``; empty when it lasts forever."""
    callback: Callback
    """The callback that runs it."""
    is_certain: bool = False
    """What it waits for is in the callback group that it blocks: several threads do not help."""


class DeafLoop(NamedTuple):
    """A loop that asks neither rclcpp nor anything else whether the program is to end."""

    span: Span
    function: str
    """``main``, or the class that is made."""
    is_forever: bool
    """It has no condition at all."""


class Unstamped(NamedTuple):
    """A reading that is published with the time 0."""

    made: Span
    """Where the message is made."""
    type: str
    """``nav_msgs/msg/Odometry``."""
    sent: Span
    """The call that publishes it."""


class Restamped(NamedTuple):
    """A message that takes the frame of the reading it is made of, and the time of now."""

    stamped: Span
    frame: Span
    """Where it takes the frame."""
    name: str
    type: str
    message: str
    """The reading."""


class Canceled(NamedTuple):
    """A goal that ends as canceled without having been asked to."""

    span: Span
    asked: Span
    """The condition after which it is not one that is to be canceled; or the function that ends it."""
    runs: str | None
    """What calls that function while the goal is executed: ``a subscription``; None for a condition."""
    decides: bool = False
    """The function answers whether the goal may be canceled, which it only is afterwards."""


class ComponentEnd(NamedTuple):
    """A call of a component that ends the process which it was loaded into, or all nodes of its context."""

    place: Span
    call: str
    component: str
    """As it is registered: ``rover::Camera``; else the class."""
    step: str | None
    """The transition of a lifecycle node that calls it; None in a class that the file registers as a component."""
    is_context: bool
    """``rclcpp::shutdown``."""
    is_made: bool
    """It is called while the component is made, so that an exception would do."""


class WrongDuration(NamedTuple):
    """A duration that is much shorter than what is written there means."""

    place: Span
    kind: str
    """``cast`` and ``cut``: whole seconds are made of a fraction; ``small``: it is a few nanoseconds; ``milli``: of
    milliseconds it makes nanoseconds; ``throttle``: a log takes it as milliseconds."""
    number: str


class UnreadAnswer(NamedTuple):
    """``return false`` of a callback of a service."""

    place: Span
    registered: Span
    callback: str
    has_data: bool
    """It answers with data when it does not fail."""


class FormatText(NamedTuple):
    """A text in the place of a format."""

    place: Span
    macro: str
    text: str
    is_foreign: bool
    """Another node sent it."""


class StuckJoin(NamedTuple):
    """A join of a thread that runs as long as rclcpp does."""

    place: Span
    loop: Span
    """The condition of its loop."""
    thread: str
    function: str
    """What joins it: ``on_cleanup``, ``~Receiver``."""
    is_destructor: bool


class BusySpin(NamedTuple):
    """A loop that only calls ``spin_some``."""

    place: Span
    loop: Span
    """Its condition."""


class Swallowed(NamedTuple):
    """A failure after which the program ends with status 0."""

    place: Span
    """What the handler takes; or the loop that is left out."""
    spin: Span
    """What throws; or the branch that logs the failure."""
    is_caught: bool = True


class Dropped(NamedTuple):
    """What is destroyed before an executor can call it."""

    made: Span
    kind: str
    """``subscription``, ``service``, ``timer``, ``action server`` or ``callback group``."""
    variable: str | None
    """The local variable that alone keeps it; None when nothing does."""


class Divisor(NamedTuple):
    """A velocity of a command by which something is divided."""

    place: Located
    is_zero_by_zero: bool
    """What is divided is another velocity of the same command, which is 0 too where the robot is to stop."""


class Unset(NamedTuple):
    """A local number that is added to before it has a value."""

    declared: Span
    used: Span
    name: str
    is_kept: bool = False
    """What is added is computed from its own value, and no loop adds it again: it is meant to last between calls."""


class UnsetMember(NamedTuple):
    """A number or truth value of a node that a callback reads, and that only callbacks set."""

    declared: Span | None
    """None when another file declares it."""
    read: Span
    name: str
    owner: str
    """The class whose member it is."""
    callback: str
    """What reads it, in a sentence: ``on_timer()``, ``a lambda``."""
    set_later: Span | None
    """Where another callback sets it; None when only the same one does, after it has read it."""


class BareMember(NamedTuple):
    """A number or truth value that a class of nodes declares without a value, and that its file does not name again."""

    declared: Located
    owner: str


class RepeatedBranch(NamedTuple):
    """A condition of a chain that one before it has as well."""

    place: Span
    earlier: Span


class MessageRace(NamedTuple):
    """A member that a callback replaces by a message while another thread reads it."""

    replaced: Span
    read: Span
    name: str
    callback: str
    """In a sentence: ``on_odom()``, ``a lambda``."""
    reader: str
    """The function that the other thread runs."""
    is_update: bool
    """The other thread is that of the controller manager."""


class GivenUp(NamedTuple):
    """A return of the constructor of a node that has nothing which could run."""

    left: Span
    lost: Span
    """What the constructor would make after it."""
    owner: str
    """The class that is made."""
    is_setting: bool
    """The value of a parameter alone decides: the next start would end in the same way."""


class EarlyMember(NamedTuple):
    """A member that is made of one which is made after it."""

    used: Span
    declared: Span
    later: Span
    """Where the other is declared."""
    name: str


class EarlyPointer(NamedTuple):
    """``shared_from_this()`` while the object is made."""

    asked: Span
    owner: str
    """The class whose constructor asks."""
    through: Span | None
    """The call of the constructor that leads there; None when it asks itself."""


class LateJoin(NamedTuple):
    """A thread of a node that only callbacks join, so that nothing does after the executor has ended."""

    thread: str
    joins: tuple[Span, ...]
    callback: str
    """In a sentence: ``on_start()``, ``a lambda``."""
    is_step: bool
    """It is a transition of a lifecycle node."""


class MakingLoop(NamedTuple):
    """A loop that keeps the constructor of a node from returning as long as rclcpp runs."""

    span: Span
    owner: str
    """The class that is made."""
    through: Span | None
    """The call of the constructor that leads there; None when the loop is in the constructor itself."""


class FewHandles(NamedTuple):
    """An executor of rclc that is made for fewer handles than are added to it."""

    place: Span
    """Where the number is written."""
    room: int
    added: int
    refused: Span
    """The first call that adds one too many."""


class TimeMember(NamedTuple):
    """A member that holds the system time 0 until something sets it."""

    name: Located
    owner: str
    """Its class."""


class TimeUse(NamedTuple):
    """The difference of a member and a ROS time, which throws when the member holds a system time."""

    place: Span
    name: str
    owner: str
    """The class whose member it is."""
    callback: Callback
    """The callback that computes it."""
    set_later: Span | None
    """Where a message sets the member; None when only the callback itself does, after the difference."""


class NestedSpin(NamedTuple):
    """A callback that spins its own node, which an executor has already."""

    span: Span
    call: str
    """``rclcpp::spin_some``."""
    callback: str
    """In a sentence: ``on_scan()``, ``a lambda``."""
    is_caught: bool
    """A ``try`` takes the exception."""


class MissingReturn(NamedTuple):
    """A function with a type whose end may be reached."""

    name: Span
    """Where its definition names it."""
    function: str
    when: str
    """When that is, in words; empty: whenever it is called."""
    left: Span | None
    """The statement by which the end is reached then."""
    is_open: bool
    """It is not known whether the statement always returns."""


class EndlessAnswer(NamedTuple):
    """A wait without a timeout for the answer of a server that nobody has looked for."""

    waiting: Span
    asked: Span
    client: str
    call: str
    """``async_send_request``."""


class UncheckedElement(NamedTuple):
    """An element of an array that a callback takes from its message without a look at the size."""

    place: Span
    field: str
    number: int
    """The index; -1 where it is not known."""


class UncheckedElements(NamedTuple):
    """Those of one callback."""

    first: Span
    type: str
    """``sensor_msgs/msg/Joy``."""
    told: list[UncheckedElement]
    """One for each array, the one that is most surely not there."""


class Read(NamedTuple):
    """``get_parameter`` of a literal name."""

    name: Located
    required: bool
    """It raises an exception when the parameter is not declared."""


class TextAsBool(NamedTuple):
    parameter: Located | None
    """None when its name is not a literal."""
    default: Located
    is_declared: bool
    """A statement before it has surely declared the parameter already."""


@dataclass(eq=False, slots=True)
class CppNode:
    """All that ``parsers.cpp_node`` finds in one file."""

    source: Source
    endpoints: list[Endpoint] = field(default_factory=list)
    """In the order of the text; without a name where it is not a literal."""
    timers: list[Timer] = field(default_factory=list)
    callbacks: list[Callback] = field(default_factory=list)
    names: list[Located] = field(default_factory=list)
    """The literal names that nodes give themselves."""
    classes: list[str] = field(default_factory=list)
    """Classes that build on a node."""
    components: list[str] = field(default_factory=list)
    """Classes that are registered as components."""
    parameters: list[Parameter] = field(default_factory=list)
    """What it declares under a literal name."""
    endless_answers: list[EndlessAnswer] = field(default_factory=list)
    reads: list[Read] = field(default_factory=list)
    texts_as_bool: list[TextAsBool] = field(default_factory=list)
    """The defaults of truth values that are written as texts."""
    declares_others: bool = False
    """It may declare parameters under names that are not literal, or all that it is given."""
    waits: list[Waiting] = field(default_factory=list)
    lookups: list[Lookup] = field(default_factory=list)
    kept: dict[int, frozenset[str]] = field(default_factory=dict)
    """Where the callback of a subscription is handed over -> the members that it alone fills, from its message."""
    sent: dict[int, frozenset[str]] = field(default_factory=dict)
    """Where the callback of a timer that publishes or writes something is handed over -> the words of what it runs."""
    passed_on: dict[int, frozenset[str]] = field(default_factory=dict)
    """The same for the callback of a subscription."""
    called: dict[int, frozenset[str]] = field(default_factory=dict)
    """Where a callback is handed over -> the functions that it calls, itself and through methods of the file."""
    executors: bool = False
    """It makes an executor of several threads, or callback groups."""
    devices: list[Located] = field(default_factory=list)
    """Literal paths below ``/dev`` that a call opens."""
    threads: list[Located] = field(default_factory=list)
    """Variables and members to which it gives a thread, each where it does."""
    late_joins: list[LateJoin] = field(default_factory=list)
    deaf_loops: list[DeafLoop] = field(default_factory=list)
    busy_spins: list[BusySpin] = field(default_factory=list)
    unstamped: list[Unstamped] = field(default_factory=list)
    restamped: list[Restamped] = field(default_factory=list)
    declared_again: list[DeclaredAgain] = field(default_factory=list)
    stuck_joins: list[StuckJoin] = field(default_factory=list)
    component_ends: list[ComponentEnd] = field(default_factory=list)
    durations: list[WrongDuration] = field(default_factory=list)
    service_answers: list[UnreadAnswer] = field(default_factory=list)
    format_texts: list[FormatText] = field(default_factory=list)
    swallowed: list[Swallowed] = field(default_factory=list)
    dropped: list[Dropped] = field(default_factory=list)
    given_up: list[GivenUp] = field(default_factory=list)
    early_members: list[EarlyMember] = field(default_factory=list)
    early_pointers: list[EarlyPointer] = field(default_factory=list)
    second_owners: list[Located] = field(default_factory=list)
    """Where a shared pointer is made of ``this``, which is a node."""
    few_handles: list[FewHandles] = field(default_factory=list)
    making_loops: list[MakingLoop] = field(default_factory=list)
    time_members: list[TimeMember] = field(default_factory=list)
    time_uses: list[TimeUse] = field(default_factory=list)
    activation: Located | None = None
    """The one ``on_activate`` that it defines for a lifecycle node."""
    misread: list[Misread] = field(default_factory=list)
    nested_spins: list[NestedSpin] = field(default_factory=list)
    missing_returns: list[MissingReturn] = field(default_factory=list)
    unset: list[Unset] = field(default_factory=list)
    unset_members: list[UnsetMember] = field(default_factory=list)
    bare_members: list[BareMember] = field(default_factory=list)
    races: list[MessageRace] = field(default_factory=list)
    repeated_branches: list[RepeatedBranch] = field(default_factory=list)
    canceled: list[Canceled] = field(default_factory=list)
    unchecked_elements: list[UncheckedElements] = field(default_factory=list)
    divisors: list[Divisor] = field(default_factory=list)
    """Velocities of commands by which something is divided unseen."""
    problems: list[Problem] = field(default_factory=list)
