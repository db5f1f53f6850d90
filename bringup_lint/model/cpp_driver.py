"""A C++ source of a node or of a driver beside it: what it does with devices, locks and the answers of the system."""

from __future__ import annotations

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source
from bringup_lint.source import Span


class UncheckedIndex(NamedTuple):
    """``ioctl(socket, SIOCGIFINDEX, &request)`` whose result nobody looks at."""

    asked: Span
    bound: Span
    """The ``bind`` that takes the index."""
    is_zero: bool
    """The request is made as zero, so that the index is 0 without the interface."""
    is_blind: bool
    """Nobody looks at the result of the ``bind`` either."""


class IdleRead(NamedTuple):
    """A read of a serial port in a loop that goes on at once whatever the read returns."""

    read: Span
    loop: Span


class Relock(NamedTuple):
    """A mutex that a thread locks while it holds it."""

    place: Span
    """The call that leads to the second lock, or that lock."""
    held: Span
    again: Span
    mutex: str
    through: str | None
    """The method that is called; None when the function itself locks twice."""
    is_typed: bool
    """The guard names the type of the mutex."""


class BlindWait(NamedTuple):
    """A wait for a condition variable that looks at nothing before."""

    place: Span
    lock: Span
    name: str


class LeftLocked(NamedTuple):
    """A mutex that an early ``return`` leaves locked."""

    left: Span
    locked: Span
    mutex: str


class UncheckedDevice(NamedTuple):
    """A device or file that is opened, and whose failure nothing of the source notices."""

    opened: Span
    used: Span
    function: str
    name: str
    """What holds it."""
    is_pointer: bool
    """NULL when it failed; else a negative number."""
    is_optional: bool
    """Each use is in a branch that a flag decides about, such as that of a log for debugging."""


class EndlessWalk(NamedTuple):
    """A loop through a linked list that goes on without its step."""

    skips: Span
    """The ``continue``."""
    step: Span
    name: str


class TakenTarget(NamedTuple):
    """The endpoint to which a socket sends, and into which it writes the sender of each packet."""

    received: Span
    sent: Span
    name: str


class Thrown(NamedTuple):
    """What is thrown and is no exception."""

    place: Span
    kind: str
    """``a text`` or ``a number``."""


class CutAnswer(NamedTuple):
    """A part of an answer that is cut off at what was sought in it, found or not."""

    place: Span
    given: Span
    """What leaves the answer empty when nothing comes."""
    name: str
    function: str
    reads: str
    """What makes a number of the part: ``atoi``."""


class WaitingHandler(NamedTuple):
    """A function that waits for a lock, and that a signal may call."""

    place: Located
    """The log call, or the lock."""
    name: str
    is_log: bool


class LostTransform(NamedTuple):
    """A transform that a function uses although it may not have got it."""

    looked_up: Span
    handled: Span
    """The handler, which only logs."""
    used: Span
    name: str


class ThreadThrow(NamedTuple):
    """An exception that leaves the function of a thread."""

    thrown: Span
    started: Span
    function: str
    """What throws."""
    queue: str
    """The container without whose elements the thread does not start; empty where there is none."""


class ShutContext(NamedTuple):
    """A function that goes on after it has shut the context down."""

    shutdown: Span
    behind: Span
    name: str
    """What makes something there: ``create_publisher``; or what is used although it is of no use."""
    owner: str | None
    """The class whose constructor makes something; None where something is used."""
    is_null: bool
    """It is a null pointer that is followed: the process ends there."""


class BlindWrite(NamedTuple):
    """A file that is written unseen, and the answer that it was."""

    opened: Span
    answered: Span
    name: str
    """The stream."""


class ShutPort(NamedTuple):
    """A serial port that is used whether it could be opened or not."""

    opened: Span
    handled: Span
    """The handler, which only logs."""
    used: Span
    name: str


class ShortAnswer(NamedTuple):
    """A part of an answer that is taken however short it is."""

    places: tuple[Span, ...]
    name: str
    """What is taken apart at the first place."""
    function: str
    is_field: bool
    """It is a field of a line that is split; else what is cut off from a fixed place on."""


class LostCamera(NamedTuple):
    """A read of a camera after whose failure a timer or loop goes on, where nothing opens it again."""

    read: Span
    test: Span
    opened: Span
    is_logged: bool


class ShellText(NamedTuple):
    """A shell command that holds text of a message, a request or a goal."""

    call: Span
    read: Span
    """Where the text is taken: ``request->name``."""


@dataclass(eq=False, slots=True)
class CppDriver:
    source: Source
    unchecked_indexes: list[UncheckedIndex] = field(default_factory=list)
    idle_reads: list[IdleRead] = field(default_factory=list)
    relocks: list[Relock] = field(default_factory=list)
    blind_waits: list[BlindWait] = field(default_factory=list)
    left_locked: list[LeftLocked] = field(default_factory=list)
    unchecked_devices: list[UncheckedDevice] = field(default_factory=list)
    endless_walks: list[EndlessWalk] = field(default_factory=list)
    taken_targets: list[TakenTarget] = field(default_factory=list)
    thrown: list[Thrown] = field(default_factory=list)
    cut_answers: list[CutAnswer] = field(default_factory=list)
    waiting_handlers: list[WaitingHandler] = field(default_factory=list)
    lost_transforms: list[LostTransform] = field(default_factory=list)
    thread_throws: list[ThreadThrow] = field(default_factory=list)
    shut_contexts: list[ShutContext] = field(default_factory=list)
    blind_writes: list[BlindWrite] = field(default_factory=list)
    shut_ports: list[ShutPort] = field(default_factory=list)
    short_answers: list[ShortAnswer] = field(default_factory=list)
    lost_cameras: list[LostCamera] = field(default_factory=list)
    shell_texts: list[ShellText] = field(default_factory=list)
    problems: list[Problem] = field(default_factory=list)
