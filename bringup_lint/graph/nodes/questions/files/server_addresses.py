"""The address on which a server in a node source listens, also where a parameter, option or variable gives it."""

from __future__ import annotations

import ast
import re
from collections import defaultdict
from collections.abc import Iterable
from typing import TYPE_CHECKING

from bringup_lint.addresses import is_wildcard
from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.graph.memo import memo
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.model.python import last_name
from bringup_lint.model.python import walk
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.python_node.values import argument
from bringup_lint.parsers.python_node.values import keyword
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.source import Span

_SETTERS = (
    *("params", *LAUNCH, "systemd-unit", "systemd-dropin"),
    *("compose", "dockerfile", "shell-script", "env-file", "supervisord"),
)
"""Kinds of files that may give a program another address than its default."""
_ENVIRONMENT = ("os.environ.get", "os.getenv")
_DECLARED = ("declare_parameter", "get_parameter", "get_parameter_or")
_VALUE = regex(
    r"[\"']?\s{0,3}[,:= ]\s{0,3}(?:default_value\s{0,3}=\s{0,3}|value\s{0,3}=\s{0,3})?"
    r"[\"']?(?P<host>[^\s\"',(){}\[\]]+)"
)
_HANDED_ON = ("LaunchConfiguration", "default_value", "os.environ.get", "os.getenv")
_DEPTH = 4
"""Assignments through which an address is followed."""


class Address(NamedTuple):
    text: str
    default: Span | None = None
    """Where it is the default of a parameter, an option or a variable of the environment."""


class Setting(NamedTuple):
    """What may be given from outside, and its default."""

    name: str
    default: ast.expr


class Settings:
    """The addresses that files of the tree give to programs."""

    def __init__(self, files: Files) -> None:
        self._files = files

    @memo
    def limits(self, name: str) -> bool:
        """Whether one gives a setting an address that is not the wildcard, or one that is not known."""
        return any(_limits(source.text, name) for source in self._files.of_kind(*_SETTERS) if name in source.text)


def address_of(settings: Settings, syntax: Syntax, node: ast.expr) -> Address | None:
    """The address that an expression gives unless somebody starts the program in another way; None when not known."""
    if isinstance(node, ast.Tuple) and node.elts:
        node = node.elts[0]
    literal = syntax.file.constant(node, syntax.function(node))
    if isinstance(literal, str):
        return Address(literal)
    setting = _setting(syntax, node, _DEPTH)
    if setting is None:
        return None
    text = syntax.file.constant(setting.default, syntax.function(setting.default))
    if not isinstance(text, str) or settings.limits(setting.name):
        return None
    return Address(text, syntax.file.span_of(setting.default))


def _setting(syntax: Syntax, node: ast.expr, depth: int) -> Setting | None:
    """The parameter, option or variable that gives a value, with a default."""
    for each in walk(node):
        if isinstance(each, ast.Call) and (found := _given(syntax, each)) is not None:
            return found
    if isinstance(node, ast.Call) and len(node.args) == 1:
        node = node.args[0]
    name = last_name(node)
    settings = syntax.once(_settings)
    if name in settings:
        return settings[name]
    values = syntax.once(_assigned)[name] if name else []
    return _setting(syntax, values[0], depth - 1) if len(values) == 1 and depth else None


def _given(syntax: Syntax, call: ast.Call) -> Setting | None:
    name = syntax.qualified(call) or last_name(call.func)
    if name in _ENVIRONMENT:
        return _with_default(call, 1, "default")
    if name.rpartition(".")[2] in _DECLARED and call.args and isinstance(call.args[0], ast.Constant):
        return syntax.once(_settings).get(str(call.args[0].value)) or _with_default(call, 1, "value")
    return None


def _with_default(call: ast.Call, index: int, word: str) -> Setting | None:
    name, default = argument(call, 0), argument(call, index, word)
    return Setting(str(name.value), default) if isinstance(name, ast.Constant) and default is not None else None


def _settings(syntax: Syntax) -> dict[str, Setting]:
    """The parameters of the file by their names, and the options of its command line by the attributes for them."""
    found: dict[str, Setting] = {}
    for call in syntax.calls:
        what = last_name(call.func)
        if what == "declare_parameter" and (parameter := _with_default(call, 1, "value")) is not None:
            found[parameter.name] = parameter
        elif what == "add_argument":
            names = [each.value for each in call.args if isinstance(each, ast.Constant) and isinstance(each.value, str)]
            default = keyword(call, "default")
            if names and default is not None:
                found[names[-1].lstrip("-").replace("-", "_")] = Setting(names[-1], default)
    return found


def _assigned(syntax: Syntax) -> dict[str, list[ast.expr]]:
    """Name of a variable or attribute -> what the file gives it."""
    found: dict[str, list[ast.expr]] = defaultdict(list)
    for node in syntax.file.nodes:
        if isinstance(node, ast.Assign):
            for target in node.targets:
                found[last_name(target)].append(node.value)
        elif isinstance(node, ast.AnnAssign) and node.value is not None:
            found[last_name(node.target)].append(node.value)
    return found


def _limits(text: str, name: str) -> bool:
    return any(not is_wildcard(host) for host in _hosts(text, name))


def _hosts(text: str, name: str) -> Iterable[str]:
    for mention in re.finditer(rf"(?<![\w-]){re.escape(name)}(?![\w-])", text):
        value = _VALUE.match(text, mention.end())
        if value is not None and value["host"] not in _HANDED_ON:
            yield value["host"]
