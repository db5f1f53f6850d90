"""Messages whose content a callback takes for granted: text that may be malformed, and arrays that may be empty."""

from __future__ import annotations

import ast
from collections.abc import Iterable
from collections.abc import Iterator
from functools import partial
from itertools import islice
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.short_arrays import COMMON
from bringup_lint.facts.ros.short_arrays import EMPTY
from bringup_lint.facts.ros.short_arrays import JOYSTICK
from bringup_lint.facts.ros.short_arrays import SEEN
from bringup_lint.graph.memo import memo
from bringup_lint.graph.nodes.sources.callback_code import code_of
from bringup_lint.graph.nodes.sources.stored_values import module_values
from bringup_lint.graph.nodes.sources.stored_values import stored
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.uncaught import Uncaught
from bringup_lint.model.node_source import Endpoint
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.node_source import NodeSource
from bringup_lint.model.python import is_own
from bringup_lint.model.python import walk
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.graph.nodes.sources.message_types import MessageTypes


class Reader(NamedTuple):
    """What takes a text apart."""

    raises: str
    what: str
    """What the text then is, in a sentence."""
    names: frozenset[str]
    """Further exceptions whose handlers take what it raises."""


_NUMBER = Reader("ValueError", "is not a number", frozenset({"ValueError"}))
_READERS = {
    "json.loads": Reader("JSONDecodeError", "is not JSON", frozenset({"JSONDecodeError", "ValueError"})),
    "ast.literal_eval": Reader(
        "SyntaxError or ValueError", "is not a Python literal", frozenset({"ValueError", "SyntaxError"})
    ),
    "yaml.safe_load": Reader("YAMLError", "is not YAML", frozenset({"YAMLError", "ScannerError", "ParserError"})),
    "float": _NUMBER,
    "int": _NUMBER,
}
_CLEANED = ("strip", "lower", "upper", "rstrip", "lstrip", "replace")
_MOST = 10
_ROLES = ("subscription", "service")
_KEY_ERRORS = frozenset({"KeyError", "LookupError"})
_INDEX_ERRORS = frozenset({"IndexError", "LookupError"})
_MOST_ERRORS = frozenset({"ValueError"})
_CONDITIONAL = (ast.If, ast.While, ast.IfExp, ast.BoolOp, ast.Match, ast.comprehension, ast.Lambda, ast.ExceptHandler)


class Fault(NamedTuple):
    """What raises for some message, and for which."""

    node: ast.expr
    fields: list[str]
    """The field, as it is written."""
    when: str
    """``whose data is not JSON``."""
    raises: str
    is_text: bool


class Unchecked(NamedTuple):
    file: NodeSource
    endpoint: Endpoint
    name: str
    """The callback."""
    fault: Fault
    others: list[ast.expr]
    """Further places of the callback that raise the same."""


def unchecked_messages(nodes: Nodes) -> Iterator[Unchecked]:
    """For each subscription the first place at which one message ends its callback with an exception."""
    encoded = _encoded_topics(nodes)
    for types in nodes.message_types:
        for cls in types.file.classes:
            if cls.is_node is True:
                yield from _in_class(nodes, types, cls, encoded)


def _in_class(nodes: Nodes, types: MessageTypes, cls: NodeClass, encoded: frozenset[str]) -> Iterator[Unchecked]:
    ending = nodes.ending(types.file)
    looks = _looks(types, cls)
    heard = {each.callback: each for each in cls.endpoints if each.role in _ROLES and each.callback is not None}
    seen: set[ast.AST] = set()
    for callback in cls.callbacks:
        endpoint = heard.get(callback.name or "") if callback.role in _ROLES else None
        if endpoint is None or _last_word(endpoint) in encoded:
            continue
        name, body = code_of(ending, cls, callback)
        new = (each for each in _faults(types.syntax, looks, body) if each.node not in seen)
        faults = list(islice(new, _MOST))
        if faults:
            fault, *others = faults
            seen.update(each.node for each in faults)
            alike = [each.node for each in others if each.raises == fault.raises]
            yield Unchecked(types.file, endpoint, name, fault, alike)


def _last_word(endpoint: Endpoint) -> str:
    return str(endpoint.name or "").rpartition("/")[2]


def _encoded_topics(nodes: Nodes) -> frozenset[str]:
    """The last words of the names of topics on which programs that make JSON publish: their text is proper."""
    files = (file for file in nodes.judged if "dumps" in file.source.text)
    endpoints = (each for file in files for node in file.classes for each in node.endpoints)
    return frozenset(_last_word(each) for each in endpoints if each.role == "publisher") - {""}


def _looks(types: MessageTypes, cls: NodeClass) -> list[Uncaught[Fault]]:
    """The looks for what raises for some message, outside a ``try``."""
    readers = [each for each in _READERS if each.rpartition(".")[2] in types.syntax.file.source.text]
    looks = [(_READERS[each].names, partial(_reading, types, each)) for each in readers]
    looks += [
        (_KEY_ERRORS, partial(_lookup, types, cls)),
        (_INDEX_ERRORS, partial(_element, types)),
        (_MOST_ERRORS, partial(_most, types)),
    ]
    return [Uncaught(types.syntax, cls, names, look) for names, look in looks]


def _faults(syntax: Syntax, looks: list[Uncaught[Fault]], body: list[ast.AST]) -> Iterator[Fault]:
    """What raises for some message, where the function asks nothing of the field before."""
    found = (fault for look in looks for fault in look.of(body))
    return (fault for fault in found if not _is_asked(syntax, fault))


def _reading(types: MessageTypes, reader: str, node: ast.AST) -> Fault | None:
    """A call that takes the text of a message apart."""
    if not isinstance(node, ast.Call) or len(node.args) != 1:
        return None
    is_built_in = isinstance(node.func, ast.Name) and node.func.id == reader
    field = _text_of(node) if is_built_in or types.syntax.qualified(node) == reader else None
    if field is None or types.of(field) != "string":
        return None
    kind = _READERS[reader]
    return Fault(node, [written(field)], f"whose {field.attr} {kind.what}", kind.raises, True)


def _lookup(types: MessageTypes, cls: NodeClass, node: ast.AST) -> Fault | None:
    """A subscript that takes the entry for a text of a message from a dictionary that the file writes out."""
    if not isinstance(node, ast.Subscript) or not isinstance(node.ctx, ast.Load):
        return None
    key = node.slice
    if not isinstance(key, ast.Attribute) or not _is_taken(key) or types.of(key) != "string":
        return None
    values = _values(types.syntax, cls, node.value)
    if len(values) != 1 or not _is_written_out(values[0]):
        return None
    names = [written(key), written(node.value)]
    return Fault(node, names, f"whose {key.attr} is no key of {names[1]}", "KeyError", True)


def _values(syntax: Syntax, cls: NodeClass, node: ast.expr) -> list[ast.expr | None]:
    """What an attribute of the node, or a variable of the module, gets."""
    if isinstance(node, ast.Name):
        return module_values(syntax).get(node.id, [])
    if not is_own(node):
        return []
    body = cls.node.body if cls.node is not None else []
    constants = [each.value for each in body if isinstance(each, ast.Assign) and _is_named(each.targets, node.attr)]
    return [*constants, *stored(syntax, cls, node)]


def _is_named(targets: list[ast.expr], name: str) -> bool:
    return any(isinstance(each, ast.Name) and each.id == name for each in targets)


def _is_written_out(value: ast.expr | None) -> bool:
    return isinstance(value, ast.Dict) and bool(value.keys) and all(isinstance(key, ast.Constant) for key in value.keys)


def _text_of(call: ast.Call) -> ast.Attribute | None:
    """The field of a message that a call takes, perhaps without its blanks."""
    given = call.args[0]
    while isinstance(given, ast.Call) and isinstance(given.func, ast.Attribute) and given.func.attr in _CLEANED:
        given = given.func.value
    return given if isinstance(given, ast.Attribute) else None


def _element(types: MessageTypes, node: ast.AST) -> Fault | None:
    """A subscript that takes a certain element of an array that may be empty."""
    if not isinstance(node, ast.Subscript) or not isinstance(node.ctx, ast.Load):
        return None
    index = node.slice.operand if isinstance(node.slice, ast.UnaryOp) else node.slice
    if not isinstance(index, ast.Constant) or not isinstance(index.value, int):
        return None
    return _of_joystick(types, node, index.value) or _of_array(types, node, node.value, "IndexError")


def _of_joystick(types: MessageTypes, node: ast.Subscript, index: int) -> Fault | None:
    """A button or axis that gamepads need not have."""
    field = node.value
    if not isinstance(field, ast.Attribute) or index < COMMON.get(field.attr, index + 1) or not _is_taken(field):
        return None
    if types.of(field.value) != JOYSTICK:
        return None
    return Fault(node, [written(field)], f"with {index} {field.attr} or fewer", "IndexError", False)


def _most(types: MessageTypes, node: ast.AST) -> Fault | None:
    """A call that looks for the least or greatest element of such an array."""
    if not isinstance(node, ast.Call) or not isinstance(node.func, ast.Name) or node.func.id not in ("max", "min"):
        return None
    if len(node.args) != 1 or any(each.arg in ("default", None) for each in node.keywords):
        return None
    return _of_array(types, node, node.args[0], "ValueError")


def _of_array(types: MessageTypes, node: ast.expr, array: ast.expr, raises: str) -> Fault | None:
    field = _array(types, array)
    if field is None:
        return None
    return Fault(node, [written(array), written(field)], f"without {field.attr}", raises, False)


def _array(types: MessageTypes, node: ast.expr) -> ast.Attribute | None:
    """The field of a message that an expression means, where the array in it is often empty."""
    if isinstance(node, ast.Name):
        bound = types.bound(node)
        node = bound if bound is not None else node
    if not isinstance(node, ast.Attribute) or not _is_taken(node):
        return None
    owner = types.of(node.value)
    if owner is None:
        return None
    if node.attr in EMPTY.get(owner, ()):
        return node
    return node if SEEN.match(node.attr) and (types.of(node) or "").endswith("[]") else None


def _is_taken(node: ast.Attribute) -> bool:
    """Whether a field is that of a variable, and not of what the node keeps."""
    inner = node.value
    while isinstance(inner, ast.Attribute):
        inner = inner.value
    return isinstance(inner, ast.Name) and inner.id != "self"


def _is_asked(syntax: Syntax, fault: Fault) -> bool:
    """Whether the function around a place asks for the field in a condition, counts it or goes through it, and not only
    in a branch that is over before."""
    function = syntax.function(fault.node)
    if function is None:
        return True
    asked = syntax.once(_Asked)
    if asked.of(function).isdisjoint(fault.fields):
        return False
    is_in_branch = any(isinstance(outer, _CONDITIONAL) for outer, _ in syntax.within(fault.node))
    return is_in_branch or not asked.lastingly(function).isdisjoint(fault.fields)


class _Asked:
    """The variables and fields that functions ask for, as they are written."""

    def __init__(self, _: Syntax) -> None:
        """It does not keep the syntax, which keeps it."""

    @memo
    def of(self, function: ast.AST) -> frozenset[str]:
        return _named(part for asked in _asked(walk(function)) for part in walk(asked))

    @memo
    def lastingly(self, function: ast.AST) -> frozenset[str]:
        """Those of which more is asked than whether to run a branch that neither leaves nor changes anything of the
        same name."""
        branches = (each for each in walk(function) if isinstance(each, ast.If) and not _leaves(each))
        over = {id(part) for each in branches for part in walk(each.test)}
        nodes = (each for each in walk(function) if id(each) not in over)
        return _named(part for asked in _asked(nodes) for part in walk(asked) if id(part) not in over)


def _named(parts: Iterator[ast.AST]) -> frozenset[str]:
    return frozenset(written(part) for part in parts if isinstance(part, (ast.Name, ast.Attribute)))


def _leaves(branch: ast.If) -> bool:
    """Whether a branch may leave, or sets what its condition asks for."""
    asked = {each.id for each in walk(branch.test) if isinstance(each, ast.Name)}
    for each in walk(branch):
        if isinstance(each, (ast.Return, ast.Raise, ast.Continue, ast.Break)):
            return True
        if isinstance(each, (ast.Name, ast.Attribute)) and isinstance(each.ctx, ast.Store) and _root(each) in asked:
            return True
    return False


def _root(node: ast.expr) -> str:
    while isinstance(node, ast.Attribute):
        node = node.value
    return node.id if isinstance(node, ast.Name) else ""


def _asked(nodes: Iterable[ast.AST]) -> Iterator[ast.AST]:
    for node in nodes:
        if isinstance(node, (ast.If, ast.While, ast.IfExp, ast.Assert)):
            yield node.test
        elif isinstance(node, (ast.For, ast.comprehension)):
            yield node.iter
            yield from getattr(node, "ifs", ())
        elif isinstance(node, ast.BoolOp):
            yield from node.values[:-1]
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in ("len", "bool", "any"):
            yield from node.args
        elif isinstance(node, ast.Match):
            yield node.subject
