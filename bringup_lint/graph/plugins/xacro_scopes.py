"""What the robot descriptions that include each other define for xacro."""

from __future__ import annotations

import fnmatch
from collections.abc import Callable
from collections.abc import Iterable
from functools import cache
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.graph.plugins.described import descriptions
from bringup_lint.graph.plugins.unread_descriptions import refused_xml
from bringup_lint.graph.plugins.xacro_includes import included
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.xml import parse
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.spelling import WordSlips

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.workspace import Workspace
    from bringup_lint.model.xml import Element
    from bringup_lint.source import Source

BUILT_IN = frozenset("arg attribute call element if include insert_block macro property unless targetNamespace".split())
_FILES = 600
"""Descriptions of one tree that are read."""
_COMPUTED = regex(r"\$\{[^{}]*\}|\$\([^()]*\)")
_PARAMETER = regex(
    r"\s*(?P<name>[^\s:=]+)(?:\s*:?=\s*(?P<forward>\^\|?)?(?P<default>\$\{[^}]*\}|\$\([^)]*\)"
    r"|(?:'[^']*'|\"[^\"]*\"|[^\s'\"])*))?(?=\s|\Z)"
)
_BLANK = str.maketrans("\t\r\n", "   ")


class Macro(NamedTuple):
    element: Element
    name: Located
    needed: tuple[str, ...]
    """The parameters without a default."""
    optional: tuple[str, ...]
    blocks: int


@dataclass(eq=False)
class Scope:
    """Descriptions of which each includes another one or is included by it."""

    files: list[tuple[Source, Element]] = field(default_factory=list)
    names: dict[str, Located] = field(default_factory=dict)
    """Properties and parameters of macros."""
    blocks: dict[str, Located] = field(default_factory=dict)
    macros: dict[str, list[Macro]] = field(default_factory=dict)
    arguments: dict[str, Located] = field(default_factory=dict)
    called: set[str] = field(default_factory=set)
    is_open: bool = False
    """More may be defined elsewhere."""
    is_opaque: bool = False
    """Macros have parameters or names that are not known."""
    _slips: dict[str, WordSlips] = field(default_factory=dict)

    def slips(self, what: str) -> WordSlips:
        """The known ``names``, ``macros`` or ``arguments``, by which misspelt ones are found."""
        if what not in self._slips:
            known: dict[str, Iterable[str]] = {
                "names": self.names,
                "macros": (*self.macros, *BUILT_IN),
                "arguments": self.arguments,
            }
            self._slips[what] = WordSlips(known[what])
        return self._slips[what]


def scopes(tree: Tree, workspace: Workspace) -> list[Scope]:
    """Those of all descriptions of the tree, each description in one."""
    known: dict[str, tuple[Source, Element]] = {}
    joined: dict[str, str] = {}
    opened: set[str] = set()
    every = descriptions(tree)

    @cache
    def matching(pattern: str) -> list[str]:
        return [each for each in every if fnmatch.fnmatchcase(each.rpartition("/")[2], pattern)]

    todo = list(every)
    while todo and len(known) < _FILES:
        path = todo.pop()
        source = tree.at(path) if path not in joined else None
        if source is None or "xacro" not in source.text:
            continue
        joined[path] = path
        root = parse(source).root if not source.template else None
        if root is None:
            opened.add(path)
            continue
        if refused_xml(source) is not None:
            opened.add(path)
        known[path] = source, root
        includes = (element for element in root.walk() if element.name == "xacro:include")
        for filename in dict.fromkeys(str(each.get("filename") or "") for each in includes):
            paths = _included(tree, workspace, source, filename, matching)
            if not paths:
                opened.add(path)
            todo += (each for each in paths if each not in joined)
            joined.update((f"\0{each}\0{path}", path) for each in paths)
    _join(joined)
    found: dict[str, Scope] = {}
    for path, (source, root) in known.items():
        scope = found.setdefault(_root(joined, path), Scope(is_open=bool(todo)))
        scope.files.append((source, root))
        scope.is_open = scope.is_open or path in opened
        _take(scope, root)
    return list(found.values())


def _join(joined: dict[str, str]) -> None:
    """Put what includes and what is included below one root."""
    for key in [each for each in joined if each.startswith("\0")]:
        path = joined.pop(key)
        one = key.split("\0")[1]
        if one in joined:
            joined[_root(joined, one)] = _root(joined, path)


def _root(joined: dict[str, str], path: str) -> str:
    while joined[path] != path:
        joined[path] = path = joined[joined[path]]
    return path


def _included(
    tree: Tree, workspace: Workspace, source: Source, filename: str, matching: Callable[[str], list[str]]
) -> list[str]:
    """The files that one include may lead to; nothing when they are not known. ``matching`` gives the descriptions
    whose names match a pattern."""
    found = included(workspace, source, filename) if filename else None
    if found is not None:
        return [found.file] if found.file is not None else []
    base = _COMPUTED.sub("*", filename).rpartition("/")[2]
    if not base.strip("*.") or "$" in base:
        return []
    if "*" not in base:
        return list(tree.named(base))
    return matching(base)


def _take(scope: Scope, root: Element) -> None:
    for element in root.walk():
        if not element.name.startswith("xacro:"):
            continue
        name = element.get("name")
        match element.local:
            case "property" if name is not None:
                scope.is_open = scope.is_open or "$" in name
                scope.names.setdefault(str(name), name)
                scope.blocks.setdefault(str(name), name)
            case "arg" if name is not None:
                scope.arguments.setdefault(str(name), name)
            case "macro" if name is not None:
                _add_macro(scope, element, name)
            case "include":
                space = element.get("ns")
                if space is not None:
                    scope.names.setdefault(str(space), space)
            case "call":
                scope.is_opaque = True
            case local:
                scope.called.add(local.rpartition(".")[2])


def _add_macro(scope: Scope, element: Element, name: Located) -> None:
    needed: list[str] = []
    optional: list[str] = []
    blocks = 0
    given = element.get("params")
    scope.is_opaque = scope.is_opaque or (given is None and len(element.attributes) > 1)
    text = given.translate(_BLANK) if given is not None else ""
    at = 0
    while given is not None and text[at:].strip():
        match = _PARAMETER.match(text, at)
        if match is None:
            scope.is_opaque = True
            break
        at = match.end()
        each = given.part(*match.span("name"))
        if each.startswith("*"):
            blocks += 1
            scope.blocks.setdefault(each.lstrip("*"), each)
            continue
        scope.names.setdefault(str(each), each)
        has_default = bool(match["default"] or match["forward"])
        (optional if has_default else needed).append(str(each))
    macro = Macro(element, name, tuple(needed), tuple(optional), blocks)
    scope.macros.setdefault(name.removeprefix("xacro:"), []).append(macro)
