"""A C++ source that opens a CAN bus or a serial port: what it does with the answers of the system."""

from __future__ import annotations

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.named_tuple import NamedTuple
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


class IdleRead(NamedTuple):
    """A read of a serial port in a loop that goes on at once whatever the read returns."""

    read: Span
    loop: Span


@dataclass(eq=False, slots=True)
class CppDriver:
    source: Source
    unchecked_indexes: list[UncheckedIndex] = field(default_factory=list)
    idle_reads: list[IdleRead] = field(default_factory=list)
    problems: list[Problem] = field(default_factory=list)
