"""What names stand for while a launch file is evaluated: model values, and the objects of its own code."""

from __future__ import annotations

import ast
from typing import Any

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.model.launch import Action
from bringup_lint.model.launch_values import Condition
from bringup_lint.model.launch_values import Value
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Span

Guards = tuple[Condition, ...]


@dataclass(eq=False, slots=True)
class Sequence:
    """A list, tuple or set. Items carry the conditions under which they are there."""

    items: list[tuple[Guards, Any]]
    span: Span
    base: Guards = ()
    """The conditions under which the object itself was made."""
    open: bool = False
    """It may hold more than is known."""

    def plain(self) -> list[Any] | None:
        """The items when nothing about them is conditional, else None."""
        if self.open or any(guards for guards, _ in self.items):
            return None
        return [item for _, item in self.items]


@dataclass(eq=False, slots=True)
class Mapping:
    """A dictionary: literal keys by their value, others in a list."""

    span: Span
    entries: dict[Any, tuple[Value, Any]] = field(default_factory=dict)
    others: list[tuple[Any, Any]] = field(default_factory=list)
    open: bool = False
    base: Guards = ()
    """The conditions under which the object itself was made."""

    def pairs(self) -> list[tuple[Any, Any]]:
        return [*self.entries.values(), *self.others]


@dataclass(eq=False, slots=True)
class Description(Sequence):
    """``LaunchDescription``: a sequence of actions."""


@dataclass(eq=False, slots=True)
class Symbol:
    """A module, or something in one, by its full name."""

    name: str
    span: Span


@dataclass(eq=False, slots=True)
class Bound:
    """An attribute of an object, before it is called."""

    owner: Any
    name: str
    span: Span


@dataclass(eq=False, slots=True)
class Frame:
    """The variables of a function or module."""

    names: dict[str, Any]
    parent: Frame | None = None
    outer: dict[str, Frame] = field(default_factory=dict)
    """Names declared ``global`` or ``nonlocal``, with the frame they live in."""
    returns: list[tuple[Guards, Any]] = field(default_factory=list)
    yielded: Sequence | None = None
    """What a generator has given so far."""


class Jump(NamedTuple):
    """A branch that leaves the code after it: its ``continue``, ``break``, ``return`` or ``raise``, the conditions that
    lead there, and the variables as they are there."""

    signal: str
    guards: Guards
    names: dict[str, Any]


@dataclass(eq=False, slots=True)
class Function:
    node: ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda
    frame: Frame
    name: str
    defaults: tuple[Any, ...] = ()
    keyword_defaults: dict[str, Any] = field(default_factory=dict)


@dataclass(eq=False, slots=True)
class Options:
    """Several possible objects, by condition."""

    options: list[tuple[Guards, Any]]
    span: Span


@dataclass(eq=False, slots=True)
class Placed:
    """An object with the conditions of its place in a launch description: ``IfCondition(...)``."""

    condition: Condition
    span: Span


@dataclass(eq=False, slots=True)
class LaunchSource:
    """``PythonLaunchDescriptionSource(path)`` and its kin."""

    file: Value
    span: Span


@dataclass(eq=False, slots=True)
class Handler:
    """An event handler, or an event, before an action carries it."""

    name: str
    target: Action | None
    arguments: dict[str, Any]
    span: Span


@dataclass(eq=False, slots=True)
class Context:
    """The launch context that an opaque function gets."""

    span: Span
