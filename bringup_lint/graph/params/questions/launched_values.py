"""The values that launch files give to nodes as parameters, with the types that launch_ros makes of them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.params.loads import path_of
from bringup_lint.graph.params.values import Item
from bringup_lint.model.launch import ComposableNode
from bringup_lint.model.launch import Node
from bringup_lint.model.launch import Process
from bringup_lint.model.launch_values import Argument
from bringup_lint.model.launch_values import DictValue
from bringup_lint.model.launch_values import ListValue
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import ParameterFile
from bringup_lint.model.launch_values import Value
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.launch.started import Started
    from bringup_lint.graph.params.params import Params

_NUMBER = regex(r"[+-]?(?:0|[1-9][0-9]*)(?P<real>\.[0-9]*)?\Z")
"""A text that YAML reads as a number, whoever reads it."""


_TYPES = ((str, "string"), (bool, "bool"), (int, "integer"), (float, "double"))


class LaunchedValue(NamedTuple):
    """A number, a boolean or a text, or a list of them."""

    node: Started
    name: str
    type: str
    """``integer``, ``double``, ``bool`` or ``string``, or an array of them."""
    items: list[Item]
    where: Span


def launched_values(params: Params) -> list[LaunchedValue]:
    """Those that arrive at the nodes of judged launch files, each place once for a node."""
    launch = params.launch()
    found: dict[tuple[Span, str, Span], LaunchedValue] = {}
    for expansion in launch.expansions:
        for node in expansion.nodes:
            for each in _values_of(params, launch, node):
                if each.where.source.judged:
                    found.setdefault((node.span, each.name, each.where), each)
    return list(found.values())


def _values_of(params: Params, launch: Launch, node: Started) -> Iterator[LaunchedValue]:
    """From the last source of parameters to the first, as long as all that comes later is known."""
    texts = _named_arguments(node.action)
    again: set[str] = set()
    for source in reversed(node.parameters):
        given = list(_flat(source, "")) if isinstance(source, DictValue) else []
        is_file = not isinstance(source, DictValue)
        names = _names_in_file(params, launch, source) if is_file else {name for name, _ in given}
        if None in names:
            return
        for name, value in given:
            items = _items(value, name in texts) if name not in again else []
            if items:
                yield LaunchedValue(node, str(name), _type(value, items), items, value.span)
        again |= {str(name) for name in names}


def _type(value: Value, items: list[Item]) -> str:
    """launch_ros makes a list of doubles of whole and other numbers."""
    types = {item.type for item in items}
    type_ = "double" if types == {"integer", "double"} else min(types)
    return f"{type_}_array" if isinstance(value, ListValue) else type_


def _names_in_file(params: Params, launch: Launch, source: Value) -> set[str | None]:
    """The parameters that a file sets, for whatever node; None among them when they are not known."""
    path = path_of(launch, source.file if isinstance(source, ParameterFile) else source)
    file = params.at_path(path) if path is not None else None
    if file is None or not file.accepted or file.uncertain or file.source.template:
        return {None}
    return {str(each.name) for each in file.parameters}


def _named_arguments(action: Node | ComposableNode | Process) -> frozenset[str | None]:
    """The parameters that get a launch configuration, of which launch_ros reads the text as YAML; in Python, a text
    stays a text."""
    sources = action.parameters if isinstance(action, (Node, ComposableNode)) else ()
    given = (pair for each in sources if isinstance(each, DictValue) for pair in _flat(each, ""))
    return frozenset(name for name, value in given if isinstance(value, Argument))


def _flat(values: DictValue, prefix: str) -> Iterator[tuple[str | None, Value]]:
    """The values of a dictionary and those in it, by the whole name; None for a name that is not known."""
    if values.open:
        yield None, values
    for key, value in values.items:
        name = text_of(key)
        if name is not None and isinstance(value, DictValue):
            yield from _flat(value, f"{prefix}{name}.")
        else:
            yield prefix + name if name is not None else None, value


def _items(value: Value, is_argument: bool) -> list[Item]:
    """The scalars of a value; empty when one of them is not known, or launch_ros refuses to mix them."""
    values = value.items if isinstance(value, ListValue) else (value,)
    found = [item for each in values if (item := _item(each, is_argument)) is not None]
    is_known = len(found) == len(values) and not (isinstance(value, ListValue) and value.open)
    types = {item.type for item in found}
    return found if is_known and (len(types) == 1 or types == {"integer", "double"}) else []


def _item(value: Value, is_argument: bool) -> Item | None:
    if not isinstance(value, Literal):
        return None
    data, text = value.value, str(value.value)
    if is_argument and isinstance(data, str):
        match = _NUMBER.match(text)
        return Item("double" if match["real"] else "integer", None, text, value.span, True) if match else None
    types = [name for kind, name in _TYPES if isinstance(data, kind)]
    if types[:1] == ["string"] and value.span.text.strip("\"'") != text:
        return None  # the outcome of a call, which may be no text
    return Item(types[0], data, text, value.span, value.span.text != text) if types else None
