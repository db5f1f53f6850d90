"""What a launch file says before it runs: values that may still depend on arguments, the environment or packages.

Every value knows its span. ``Unknown`` says why the evaluator gave up; rules stay silent about it.
"""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterator
from typing import Any
from typing import TypeGuard
from typing import Union
from typing import get_args

from bringup_lint.dataclass import dataclass
from bringup_lint.source import Located
from bringup_lint.source import Span

Scalar = Union[str, int, float, bool, None]


@dataclass(eq=False, slots=True)
class Literal:
    """A value that is in the file. A string value is a ``Located``."""

    value: Scalar
    span: Span

    @property
    def text(self) -> Located:
        """The value as launch would print it, with its place."""
        if isinstance(self.value, Located):
            return self.value
        return Located(str(self.value), self.span)


@dataclass(eq=False, slots=True)
class Concat:
    """Text made of parts that follow each other."""

    parts: tuple[Value, ...]
    span: Span


@dataclass(eq=False, slots=True)
class PathJoin:
    """Path components; an absolute component forgets what is before it."""

    parts: tuple[Value, ...]
    span: Span


@dataclass(eq=False, slots=True)
class Argument:
    """A launch configuration, read by name."""

    name: Located
    default: Value | None
    span: Span
    performed: bool = False
    """Already text, as ``perform(context)`` gives it, and not a substitution object."""


@dataclass(eq=False, slots=True)
class Env:
    """An environment variable of the launch process, or of the launch context when ``scoped``."""

    name: Located
    default: Value | None
    span: Span
    scoped: bool = False


@dataclass(eq=False, slots=True)
class PackageShare:
    """The share folder of an installed package."""

    package: Value
    span: Span


@dataclass(eq=False, slots=True)
class PackagePrefix:
    """The folder a package is installed in."""

    package: Value
    span: Span


@dataclass(eq=False, slots=True)
class FileDir:
    """The folder of the launch file that the span lies in; the file itself when ``itself``."""

    span: Span
    itself: bool = False


@dataclass(eq=False, slots=True)
class ListValue:
    items: tuple[Value, ...]
    span: Span
    open: bool = False
    """More items may exist than are known."""


@dataclass(eq=False, slots=True)
class DictValue:
    items: tuple[tuple[Value, Value], ...]
    span: Span
    open: bool = False

    def get(self, key: str) -> Value | None:
        """The last value under a literal key."""
        for name, value in reversed(self.items):
            if isinstance(name, Literal) and name.value == key:
                return value
        return None


@dataclass(eq=False, slots=True)
class Operation:
    """A computed value: ``==`` and ``!=`` as Python compares, ``equals`` and ``not-equals`` as launch does, ``and``,
    ``or``, ``not``, ``if`` (condition, then, else), ``as-bool``, ``lower``, ``upper``, ``strip``, ``exists``, and
    ``python`` (one text: an expression)."""

    name: str
    operands: tuple[Value, ...]
    span: Span


@dataclass(eq=False, slots=True)
class Choice:
    """One of several: the last one whose conditions hold."""

    options: tuple[tuple[tuple[Condition, ...], Value], ...]
    span: Span


@dataclass(eq=False, slots=True)
class DerivedFile:
    """A parameter file that a helper writes from another one (``RewrittenYaml``, ``ReplaceString``)."""

    base: Value
    helper: str
    rewrites: Value | None
    root_key: Value | None
    span: Span


@dataclass(eq=False, slots=True)
class ParameterFile:
    file: Value
    allow_substs: Value | None
    span: Span


@dataclass(eq=False, slots=True)
class TypedValue:
    """A parameter value with a forced type (``str``, ``bool``, ...; empty when it is not literal)."""

    value: Value
    type: str
    span: Span


@dataclass(eq=False, slots=True)
class Command:
    """The output of a command, such as xacro."""

    command: Value
    span: Span


@dataclass(eq=False, slots=True)
class Unknown:
    """Not understood; ``why`` in a few words."""

    why: str
    span: Span


SIZE = 1_000
"""Values inside one computed value."""

Value = Union[
    Literal,
    Concat,
    PathJoin,
    Argument,
    Env,
    PackageShare,
    PackagePrefix,
    FileDir,
    ListValue,
    DictValue,
    Operation,
    Choice,
    DerivedFile,
    ParameterFile,
    TypedValue,
    Command,
    Unknown,
]
VALUE_TYPES = get_args(Value)


def is_value(thing: object) -> TypeGuard[Value]:
    return isinstance(thing, VALUE_TYPES)


@dataclass(eq=False, slots=True)
class Condition:
    """A predicate and the outcome for which the action happens."""

    predicate: Value
    wanted: bool
    kind: str
    """``if`` and ``unless`` (checked by launch), ``python`` (a branch of the file's own code), ``loop`` (any number of
    times)."""
    span: Span


def children(value: Value) -> tuple[Value, ...]:
    """The values directly inside."""
    inner = _CHILDREN.get(type(value))
    return inner(value) if inner is not None else ()


def bounded(value: Value) -> Value:
    """The value itself, or Unknown when it holds too much to be walked again and again."""
    if isinstance(value, Literal):
        return value
    count = 1
    todo: list[Value] = [value]
    while todo:
        inner = children(todo.pop())
        count += len(inner)
        if count > SIZE:
            return Unknown("too large", value.span)
        todo += [each for each in inner if not isinstance(each, Literal)]
    return value


def _present(*values: Value | None) -> tuple[Value, ...]:
    return tuple(value for value in values if value is not None)


_CHILDREN: dict[type, Callable[[Any], tuple[Value, ...]]] = {
    Concat: lambda value: value.parts,
    PathJoin: lambda value: value.parts,
    ListValue: lambda value: value.items,
    DictValue: lambda value: tuple(inner for pair in value.items for inner in pair),
    Operation: lambda value: value.operands,
    Choice: lambda value: tuple(option for _, option in value.options),
    Argument: lambda value: _present(value.default),
    Env: lambda value: _present(value.default),
    PackageShare: lambda value: (value.package,),
    PackagePrefix: lambda value: (value.package,),
    DerivedFile: lambda value: _present(value.base, value.rewrites, value.root_key),
    ParameterFile: lambda value: _present(value.file, value.allow_substs),
    TypedValue: lambda value: (value.value,),
    Command: lambda value: (value.command,),
}


def walk(value: Value) -> Iterator[Value]:
    """The value and everything inside it."""
    todo = [value]
    while todo:
        value = todo.pop()
        yield value
        todo.extend(reversed(children(value)))


def understood(value: Value | None) -> bool:
    """True when nothing inside is Unknown."""
    return value is None or not any(isinstance(inner, Unknown) for inner in walk(value))


def text(value: Value | None) -> str | None:
    """A literal as the text that launch makes of it, else None."""
    return str(value.value) if isinstance(value, Literal) and value.value is not None else None


def literal(value: Value | None) -> Located | None:
    """The text of a string literal, else None."""
    if isinstance(value, Literal) and isinstance(value.value, str):
        return value.text
    return None


def same(first: Value | None, second: Value | None) -> bool:
    """Whether two values are written alike, wherever they are."""
    if first is second:
        return True
    if first is None or second is None or type(first) is not type(second):
        return False
    if isinstance(first, Literal) and isinstance(second, Literal):
        return first.value == second.value and type(first.value) is type(second.value)
    if isinstance(first, Unknown):
        return False
    if isinstance(first, (Argument, Env)) and isinstance(second, (Argument, Env)):
        return str(first.name) == str(second.name)
    if isinstance(first, Operation) and isinstance(second, Operation) and first.name != second.name:
        return False
    if isinstance(first, Choice) or (isinstance(first, FileDir) and first.span.source is not second.span.source):
        return False
    ours, theirs = children(first), children(second)
    return len(ours) == len(theirs) and all(map(same, ours, theirs))
