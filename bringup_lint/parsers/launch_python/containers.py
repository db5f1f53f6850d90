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
        known = keys(more)
        target.items += [(guards + own, key) for own, key in known or ()]
        target.open = target.open or known is None
    elif isinstance(more, Options):
        for own, option in more.options:
            extend(state, target, option, guards + own)
    else:
        note_read_all(state, more)
        target.open = True


def put(state: State, mapping: Mapping, key: Any, value: Any) -> None:
    """Set an entry, under the conditions that hold here and did not when the dictionary was made."""
    if isinstance(key, Literal) and len(mapping.entries) < budget.ITEMS:
        guards = relative(state.guards, mapping.base)
        if guards:
            before = mapping.entries.get(key.value)
            value = Options([*([((), before[1])] if before else []), (guards, value)], key.span)
        mapping.entries[key.value] = (key, value)
    elif len(mapping.others) < budget.ITEMS:
        mapping.others.append((key, value))


def merge(state: State, mapping: Mapping, other: Any) -> None:
    if isinstance(other, Mapping):
        state.tick(len(other.entries) + len(other.others))
        for key, value in other.entries.values():
            put(state, mapping, key, value)
        mapping.others += other.others
        mapping.open = mapping.open or other.open
    else:
        mapping.open = True


def presence(entry: Any) -> tuple[Condition, ...] | None:
    """The conditions under which a value of a dictionary is there; None when they are not one row of conditions."""
    if not isinstance(entry, Options) or not entry.options:
        return ()
    guards, value = entry.options[0]
    if not guards:
        return None if presence(value) != () else ()
    return guards if len(entry.options) == 1 else ()


def keys(mapping: Mapping) -> list[tuple[tuple[Condition, ...], Any]] | None:
    """The keys with their conditions; None when they are not known."""
    found = [(presence(value), key) for key, value in mapping.pairs()]
    known = [(guards, key) for guards, key in found if guards is not None]
    return None if mapping.open or len(known) < len(found) else known


def in_order(sequence: Sequence, backwards: bool = False) -> Sequence:
    """The same list with its items sorted, where these are known."""
    plain = sequence.plain()
    if plain is None or not all(isinstance(item, Literal) for item in plain):
        return sequence
    try:
        plain.sort(key=lambda item: item.value, reverse=backwards)
    except TypeError:
        return sequence
    sequence.items = [((), item) for item in plain]
    return sequence


def iterate(state: State, thing: Any) -> list[tuple[tuple[Condition, ...], Any]] | None:
    """The items of an iterable with their conditions; None when they are not known."""
    if isinstance(thing, Sequence):
        return None if thing.open else list(thing.items)
    if isinstance(thing, Mapping):
        return keys(thing)
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
