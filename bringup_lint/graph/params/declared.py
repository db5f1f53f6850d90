"""The types with which the workspace's sources declare their parameters, where name and type are literal."""

from __future__ import annotations

import ast
import os
import re
from collections.abc import Iterator
from itertools import islice
from typing import TYPE_CHECKING

from bringup_lint.endings import CPP
from bringup_lint.graph.memo import kept
from bringup_lint.graph.memo import memo
from bringup_lint.model.python import walk
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.python_syntax import tree_of
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.workspace import Package
    from bringup_lint.graph.workspace import Workspace

SUFFIXES = (".py", *CPP)
FILES = 600
"""Source files of one package that are read."""
_TESTS = regex(r"(?:^|/)(?:tests?|examples?|build|install)/")
_LOOSE = regex(
    r"automatically_declare_parameters_from_overrides|allow_undeclared_parameters",
    hints="automatically_declare_parameters_from_overrides allow_undeclared_parameters",
)
_UNKNOWN = regex(
    rf"{_LOOSE.pattern}|_parameters\.hpp|\bdeclare_parameter(?:<[^<>\n]{{0,80}}>)?\(\s{{0,80}}(?!name\b)[^\s\"']"
    r"|\bdeclare_parameters(?:<[^<>\n]{0,80}>)?\([^,()]{0,80},\s{0,80}(?:parameters\s{0,9}=\s{0,9})?[^\s\[{p]",
    hints="automatically_declare_parameters_from_overrides allow_undeclared_parameters _parameters.hpp "
    "declare_parameter",
)
"""What takes every parameter, the generated ones, or those whose names the source puts together."""
_DYNAMIC = "dynamic_typing"
_PYTHON_TYPES = {bool: "bool", int: "integer", float: "double", str: "string"}
_CPP_TYPES = {
    "bool": "bool",
    "int": "integer",
    "int32_t": "integer",
    "int64_t": "integer",
    "long": "integer",
    "uint16_t": "integer",
    "size_t": "integer",
    "double": "double",
    "float": "double",
    "std::double_t": "double",
    "std::string": "string",
}
_CPP_CALL = regex(
    r"\bdeclare_parameter\s*(?:<\s*(?P<type>[\w:]+(?:\s*<\s*[\w:]+\s*>)?)\s*>\s*)?\(\s*\"(?P<name>[\w./-]+)\"\s*"
    r"(?P<more>,\s*(?:(?P<call>(?=\S)[^,;(){}]*\([^(){};]*\))\s*|(?P<default>(?=\S)[^,;(){}]*))?)?[,)]"
    r"|\bdeclare_parameter_if_not_declared\s*\(\s*[\w.>-]+(?:\(\))?\s*,\s*\"(?P<other>[\w./-]+)\"\s*,\s*"
    r"(?P<value>rclcpp::ParameterValue\([^(){};]*\)|rclcpp::[\w:]+)\s*[,)]"
)
_CPP_SEVERAL = regex(
    r"\bdeclare_parameters\s{0,4}<\s{0,4}(?P<type>[\w:]+)\s{0,4}>\s{0,4}\(\s{0,40}\"(?P<prefix>[\w./-]*)\"\s{0,4},\s{0,40}\{"
)
_CPP_ENTRY = regex(r"\s{0,80}\{\s{0,40}\"(?P<name>[\w./-]+)\"\s{0,4},[^{};]{0,200}\}\s{0,40},?")
_CPP_DEFAULT = (
    (regex(r"(?:true|false)\Z"), "bool"),
    (regex(r"[+-]?(?:0|[1-9][0-9]*)[uUlL]*\Z"), "integer"),
    (regex(r"[+-]?(?:[0-9]+\.[0-9]*|\.[0-9]+|[0-9]+(?=[eE]))(?:[eE][+-]?[0-9]+)?[fF]?\Z"), "double"),
    (regex(r"(?:std::string\()?\"[^\"]*\"\)?\Z"), "string"),
    (regex(r"rclcpp::(?:ParameterType::)?PARAMETER_(BOOL|INTEGER|DOUBLE|STRING)\Z"), ""),
)
_COMMENT = regex(r"\"(?:\\.|[^\"\\\n])*\"|//[^\n]*|/\*.*?(?:\*/|\Z)", re.S)


class Declared(NamedTuple):
    type: str
    """``bool``, ``integer``, ``double``, ``string`` or a list of them."""
    place: Located
    """The name in the source."""


def declared_in(workspace: Workspace, package: Package) -> dict[str, Declared]:
    """Parameter -> type, for the names that a package declares with one type wherever it declares them."""
    found: dict[str, Declared | None] = {}
    for source in _sources(workspace, package):
        if source.matches(_LOOSE):
            return {}
        for each in _declarations(source):
            name = str(each.place)
            other = found.setdefault(name, each)
            if other is not None and other.type != each.type:
                found[name] = None
    return {name: each for name, each in found.items() if each is not None and each.type}


def declarations_in(workspace: Workspace, package: Package) -> Iterator[Declared]:
    """Every declaration in the sources of a package; the type is empty where it is not known."""
    for source in _sources(workspace, package):
        yield from _declarations(source)


def _declarations(source: Source) -> tuple[Declared, ...]:
    read = _of_python if source.name.endswith(".py") else _of_cpp
    return source.once(read, lambda: tuple(read(source)))


def mentions(files: Files, package: Package, word: str) -> bool:
    """Whether any source of a package holds a word: a parameter that is nowhere named is never declared there."""
    paths = (path for path in files.tree.walked_below(package.folder) if path.endswith(SUFFIXES))
    sources = (files.tree.read(path, judged=False) for path in paths)
    return any(source is not None and word in source.text for source in sources)


def may_declare(files: Files, workspace: Workspace, package: Package, executable: str, name: str) -> bool:
    """Whether a node of a package may declare a parameter: a source of the workspace, where its class may come from,
    names it, takes every name or one that it makes up, or nothing is known of its sources."""
    if not _sources(workspace, package) or _is_of_others(files, package, executable):
        return True
    return _is_declared(workspace, name)


@memo
def _is_declared(workspace: Workspace, name: str) -> bool:
    return any(name in source.text or source.matches(_UNKNOWN) for source in _declaring(workspace))


@kept
def _declaring(workspace: Workspace) -> tuple[Source, ...]:
    """The sources of all packages that declare parameters."""
    packages = workspace.packages.values()
    return tuple(source for each in packages for source in _sources(workspace, each))


def _is_of_others(files: Files, package: Package, executable: str) -> bool:
    """Whether the module of a program declares nothing: its class is that of another module, or of another package."""
    module = package.entry_points.get(executable, "").partition(":")[0].strip()
    source = files.tree.at(os.path.join(package.folder, f"{module.replace('.', '/')}.py")) if module else None
    return bool(module) and (source is None or "declare_parameter" not in source.text)


@memo
def _sources(workspace: Workspace, package: Package) -> tuple[Source, ...]:
    """The sources of a package that declare parameters, or may do so through another one."""
    paths = (path for path in workspace.tree.walked_below(package.folder) if path.endswith(SUFFIXES))
    own = (path for path in paths if not _TESTS.search(path[len(package.folder) :]))
    sources = (workspace.tree.at(path) for path in islice(own, FILES))
    return tuple(source for source in sources if source is not None and _may_be_of(workspace, package, source))


def _may_be_of(workspace: Workspace, package: Package, source: Source) -> bool:
    if "declare_parameter" in source.text:
        return workspace.owner(source) is package
    return source.matches(_LOOSE)


def _of_python(source: Source) -> Iterator[Declared]:
    tree = tree_of(source)
    if tree is None:
        return
    described = _dynamic_names(tree) if _DYNAMIC in source.text else None
    for node in walk(tree):
        if not isinstance(node, ast.Call) or not isinstance(node.func, ast.Attribute):
            continue
        if node.func.attr == "declare_parameter":
            given = _given(node, ("name", "value", "descriptor", "ignore_override"))
            if "name" in given:
                typed = "ignore_override" not in given and not _is_dynamic(node, described)
                yield from _python_one(source, given["name"], given.get("value"), "", typed)
        elif node.func.attr == "declare_parameters":
            yield from _python_several(source, _given(node, ("namespace", "parameters")), described)


def _given(call: ast.Call, names: tuple[str, ...]) -> dict[str, ast.expr]:
    """The arguments of a call by name; empty when ``*`` or ``**`` hides some."""
    if any(isinstance(argument, ast.Starred) for argument in call.args) or any(not each.arg for each in call.keywords):
        return {}
    return dict(zip(names, call.args)) | {str(each.arg): each.value for each in call.keywords}


def _python_several(source: Source, given: dict[str, ast.expr], described: set[str] | None) -> Iterator[Declared]:
    space, pairs = given.get("namespace"), given.get("parameters")
    if not isinstance(space, ast.Constant) or not isinstance(pairs, (ast.List, ast.Tuple)):
        return
    prefix = f"{space.value!s}." if space.value else ""
    for pair in pairs.elts:
        if isinstance(pair, ast.Tuple) and pair.elts:
            default = pair.elts[1] if len(pair.elts) > 1 else None
            yield from _python_one(source, pair.elts[0], default, prefix, not _is_dynamic(pair, described))


def _dynamic_names(tree: ast.Module) -> set[str]:
    """Variables, attributes and functions that hold or return a descriptor with ``dynamic_typing``, or get it set."""
    found = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef) and _mentions_dynamic(node) and _returns(node):
            found |= {node.name, f"self.{node.name}"}
        if not isinstance(node, ast.Assign):
            continue
        for target in node.targets:
            if isinstance(target, ast.Attribute) and target.attr == _DYNAMIC:
                found.add(written(target.value))
            elif _mentions_dynamic(node.value):
                found.add(written(target))
    return found


def _mentions_dynamic(node: ast.AST) -> bool:
    inside = list(ast.walk(node))
    return any(isinstance(each, ast.keyword) and each.arg == _DYNAMIC for each in inside) or any(
        isinstance(each, ast.Attribute) and each.attr == _DYNAMIC for each in inside
    )


def _returns(function: ast.FunctionDef) -> bool:
    return any(isinstance(each, ast.Return) and each.value is not None for each in ast.walk(function))


def _is_dynamic(declaration: ast.AST, described: set[str] | None) -> bool:
    """Whether a declaration takes any type, directly or by a descriptor from a variable; ``described`` is None where
    the file does not know the word."""
    if described is None:
        return False
    if _mentions_dynamic(declaration):
        return True
    names = (each for each in ast.walk(declaration) if isinstance(each, (ast.Name, ast.Attribute)))
    return bool(described) and any(written(each) in described for each in names)


def _python_one(
    source: Source, name: ast.expr, default: ast.expr | None, prefix: str, typed: bool
) -> Iterator[Declared]:
    if isinstance(name, ast.Constant) and isinstance(name.value, str):
        start = source.line_starts[name.lineno - 1] + _column(source, name)
        span = source.span(start, min(start + len(name.value) + 2, len(source.text)))
        yield Declared(_python_type(default) if typed else "", Located(prefix + name.value, span))


def _column(source: Source, node: ast.expr) -> int:
    """The column in code points; ``ast`` counts bytes."""
    line = source.line_text(node.lineno)
    return len(line.encode()[: node.col_offset].decode("utf-8", "ignore"))


def _python_type(default: ast.expr | None) -> str:
    if isinstance(default, ast.Attribute):
        words = written(default).rpartition("Type.")
        return words[2].lower() if words[1] and words[2].isupper() else ""
    try:
        value = ast.literal_eval(default) if default is not None else None
    except (ValueError, TypeError, SyntaxError, MemoryError, RecursionError):
        return ""
    if isinstance(value, (list, tuple)):
        types = {type(item) for item in value}
        inner = _PYTHON_TYPES.get(types.pop(), "") if len(types) == 1 else ""
        return f"{inner}_array" if inner else ""
    return _PYTHON_TYPES.get(type(value), "")


def _of_cpp(source: Source) -> Iterator[Declared]:
    text = _COMMENT.sub(
        lambda found: found[0] if found[0].startswith('"') else re.sub(r"[^\n]", " ", found[0]), source.text
    )
    loose = _DYNAMIC in text
    for found in _CPP_CALL.finditer(text):
        group = "name" if found["name"] is not None else "other"
        name = source.located(*found.span(group))
        if loose:
            yield Declared("", name)
        elif found["type"]:
            yield Declared(_cpp_type(found["type"]), name)
        else:
            yield Declared(_cpp_default(found["call"] or found["default"] or found["value"] or ""), name)
    for call in _CPP_SEVERAL.finditer(text):
        entry = _CPP_ENTRY.match(text, call.end())
        while entry is not None:
            span = source.located(*entry.span("name")).span
            prefix = f"{call['prefix']}." if call["prefix"] else ""
            yield Declared("" if loose else _cpp_type(call["type"]), Located(prefix + entry["name"], span))
            entry = _CPP_ENTRY.match(text, entry.end())


def _cpp_type(text: str) -> str:
    text = re.sub(r"\s+", "", text)
    vector = re.fullmatch(r"std::vector<([\w:]+)>", text)
    inner = _CPP_TYPES.get(vector[1] if vector else text, "")
    return f"{inner}_array" if vector and inner else inner


def _cpp_default(text: str) -> str:
    text = text.strip()
    wrapped = re.fullmatch(r"rclcpp::ParameterValue\((.*)\)", text, re.S)
    text = wrapped[1].strip() if wrapped else text
    for pattern, type_ in _CPP_DEFAULT:
        match = pattern.match(text)
        if match:
            return type_ or match[1].lower()
    return ""
