"""Lists and dictionaries while they are built up."""

from __future__ import annotations

from typing import Any

from bringup_lint.model.launch_values import Condition
from bringup_lint.model.launch_values import Literal
from bringup_lint.parsers.launch_python import budget
from bringup_lint.parsers.launch_python.objects import Bound
from bringup_lint.parsers.launch_python.objects import Context
from bringup_lint.parsers.launch_python.objects import Mapping
from bringup_lint.parsers.launch_python.objects import Options
from bringup_lint.parsers.launch_python.objects import Sequence
from bringup_lint.parsers.launch_python.state import State
from bringup_lint.parsers.launch_python.state import relative


def append(state: State, target: Sequence, item: Any) -> None:
    """Append one item under the conditions that hold here and did not when the list was made."""
    if len(target.items) >= budget.ITEMS:
        target.open = True
    else:
        target.items.append((relative(state.guards, target.base), item))


def extend(state: State, target: Sequence, more: Any, guards: tuple[Condition, ...]) -> None:
    """Append what an iterable holds."""
    if isinstance(more, Sequence):
        state.tick(len(more.items))
        if len(target.items) + len(more.items) > budget.ITEMS:
            target.open = True
            return
        target.items += [(guards + own, item) for own, item in more.items]
        target.open = target.open or more.open
    elif isinstance(more, Mapping):
        target.items += [(guards, key) for key, _ in more.pairs()]
        target.open = target.open or more.open
    elif isinstance(more, Options):
        for own, option in more.options:
            extend(state, target, option, guards + own)
    else:
        note_read_all(state, more)
        target.open = True


def put(state: State, mapping: Mapping, key: Any, value: Any) -> None:
    if isinstance(key, Literal) and len(mapping.entries) < budget.ITEMS:
        mapping.entries[key.value] = (key, value)
    elif len(mapping.others) < budget.ITEMS:
        mapping.others.append((key, value))


def merge(state: State, mapping: Mapping, other: Any) -> None:
    if isinstance(other, Mapping):
        state.tick(len(other.entries) + len(other.others))
        mapping.entries.update(other.entries)
        mapping.others += other.others
        mapping.open = mapping.open or other.open
    else:
        mapping.open = True


def iterate(state: State, thing: Any) -> list[tuple[tuple[Condition, ...], Any]] | None:
    """The items of an iterable with their conditions; None when they are not known."""
    if isinstance(thing, Sequence):
        return None if thing.open else list(thing.items)
    if isinstance(thing, Mapping):
        return None if thing.open else [((), key) for key, _ in thing.pairs()]
    if isinstance(thing, Options):
        result = []
        for guards, option in thing.options:
            items = iterate(state, option)
            if items is None:
                return None
            result += [(guards + own, item) for own, item in items]
        return result
    note_read_all(state, thing)
    return None


def note_read_all(state: State, thing: Any) -> None:
    """All launch configurations are looked at, when the thing is their dictionary or the context."""
    if isinstance(thing, Context) or (isinstance(thing, Bound) and thing.name == "launch_configurations"):
        state.file.reads_all = True
