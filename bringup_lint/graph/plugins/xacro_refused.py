"""Names in robot descriptions that xacro does not know, so that it makes no description."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.graph.plugins.named_descriptions import is_used
from bringup_lint.graph.plugins.unread_descriptions import refused_xml
from bringup_lint.graph.plugins.xacro_scopes import BUILT_IN
from bringup_lint.graph.plugins.xacro_scopes import Macro
from bringup_lint.graph.plugins.xacro_scopes import Scope
from bringup_lint.graph.plugins.xacro_scopes import scopes
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.spelling import nearest

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.workspace import Workspace
    from bringup_lint.model.xml import Element
    from bringup_lint.source import Span

_GLOBAL = frozenset(
    "False True None abs_filename acos acosh asin asinh atan atan2 atanh bool cbrt ceil comb copysign cos cosh degrees"
    " dict dist dotify e erf erfc exp exp2 expm1 fabs factorial float floor fma fmod frexp fsum gamma gcd hypot inf int"
    " isclose isfinite isinf isnan isqrt lcm ldexp len lgamma list load_yaml log log10 log1p log2 map math max min modf"
    " nan nextafter perm pi pow prod python radians range remainder round sin sinh sorted sqrt str sumprod tan tanh tau"
    " trunc ulp xacro".split()
)
"""What xacro gives to every expression (create_global_symbols of xacro 2.1.1), with `math` of Python 3.13."""
_NEEDED = {
    "include": ("filename",),
    "property": ("name",),
    "macro": ("name",),
    "arg": ("name", "default"),
    "if": ("value",),
    "unless": ("value",),
    "insert_block": ("name",),
}
"""The attributes without which xacro ends."""
_OPTIONAL = {
    "include": ("ns", "optional"),
    "property": ("value", "default", "remove", "scope", "lazy_eval"),
    "macro": ("params",),
}
_EXPRESSION = regex(r"\$\$[{(]|\$\{(?P<code>[^}]{0,500})\}|\$\((?P<extension>[^)]{0,300})\)")
_EXTENSION = regex(r"\$\([^()]*\)")
_ARGUMENT = regex(r"arg\s+(?P<name>[^\s()$]+)\s*\Z")


class XacroRefused(NamedTuple):
    where: Located | Span
    what: str
    """``macro``, ``parameter``, ``missing``, ``block``, ``attribute``, ``ignored``, ``name`` or ``argument``."""
    name: str
    detail: str = ""
    near: str = ""
    """What is meant."""
    other: Located | None = None
    used: bool = True
    """A launch file or another description names the file."""
    again: tuple[Located | Span, ...] = ()
    """Other places of the file with the same name."""


def xacro_refused(files: Files, workspace: Workspace) -> Iterator[XacroRefused]:
    """What xacro refuses in the judged descriptions, each name once in a file."""
    judged = {each.name: each for each in files.of_kind("urdf") if each.judged and not each.template}
    if not any("xacro" in each.text for each in judged.values()):
        return
    all_scopes = scopes(files.tree, workspace)
    everywhere = _Everywhere(files, all_scopes)
    for scope in all_scopes:
        for source, root in scope.files:
            if source.name not in judged or refused_xml(source) is not None:
                continue
            found: dict[tuple[str, str, str], list[XacroRefused]] = {}
            for each in (one for element in root.walk() for one in _of_element(scope, everywhere, element)):
                found.setdefault((each.what, each.name, each.detail), []).append(each)
            used = bool(found) and is_used(files, source)
            for first, *others in found.values():
                yield first._replace(used=used, again=tuple(each.where for each in others))


class _Everywhere:
    """What any description of the tree defines: such a name is not misspelt."""

    def __init__(self, files: Files, all_scopes: list[Scope]) -> None:
        self._files = files
        self.names = {name for each in all_scopes for name in each.names}
        self.blocks = {name for each in all_scopes for name in each.blocks}
        self.macros = {name for each in all_scopes for name in each.macros}
        self.arguments = {name for each in all_scopes for name in each.arguments}

    def gives(self, argument: str) -> bool:
        """Whether a launch file has the name of an argument."""
        return any(argument in each.text for each in self._files.of_kind(*LAUNCH))


def _of_element(scope: Scope, everywhere: _Everywhere, element: Element) -> Iterator[XacroRefused]:
    if element.name.startswith("xacro:"):
        local = element.local
        yield from _built_in(element, str(local)) if local in BUILT_IN else _call(scope, everywhere, element)
    texts = [each.value for each in element.attributes if element.name != "xacro:macro"] + element.texts
    for text in texts:
        if "$" in text:
            yield from _expressions(scope, everywhere, element, text)


def _built_in(element: Element, local: str) -> Iterator[XacroRefused]:
    needed, optional = _NEEDED.get(local, ()), _OPTIONAL.get(local, ())
    given = {str(each.name): each.name for each in element.attributes}
    for attribute in needed:
        if attribute not in given:
            other = [each for each in given if each not in (*needed, *optional)]
            near = nearest(attribute, other)
            where = given[near[0]] if len(near) == 1 else element.tag
            yield XacroRefused(where, "attribute", attribute, str(element.name), near[0] if len(near) == 1 else "")
            return
    for name, located in given.items():
        near = nearest(name, [each for each in (*needed, *optional) if each not in given])
        if name not in (*needed, *optional) and optional and len(near) == 1:
            yield XacroRefused(located, "ignored", name, str(element.name), near[0])


def _call(scope: Scope, everywhere: _Everywhere, element: Element) -> Iterator[XacroRefused]:
    name = element.name.removeprefix("xacro:").rpartition(".")[2]
    macros = scope.macros.get(name)
    if macros is None:
        near = scope.slips("macros").meant(name) or "" if name not in everywhere.macros else ""
        if near or _is_certain(scope, element):
            other = scope.macros[near][0].name if near in scope.macros else None
            yield XacroRefused(element.name, "macro", str(element.name), near=near, other=other)
        return
    if not scope.is_opaque:
        yield from _parameters(element, name, macros)


def _parameters(element: Element, name: str, macros: list[Macro]) -> Iterator[XacroRefused]:
    given = [each.name for each in element.attributes if ":" not in each.name]
    taken = {parameter for each in macros for parameter in (*each.needed, *each.optional)}
    other = macros[0].name
    wrong = [each for each in given if each not in taken]
    if wrong:
        near = nearest(wrong[0], sorted(taken.difference(given)))
        yield XacroRefused(wrong[0], "parameter", str(wrong[0]), name, near[0] if len(near) == 1 else "", other)
        return
    missing = [[need for need in each.needed if need not in given] for each in macros]
    if all(missing):
        yield XacroRefused(element.tag, "missing", missing[0][0], name, other=other)
    elif all(each.blocks for each in macros) and not element.children:
        yield XacroRefused(element.tag, "block", name, other=other)


def _expressions(scope: Scope, everywhere: _Everywhere, element: Element, text: Located) -> Iterator[XacroRefused]:
    for match in _EXPRESSION.finditer(text):
        if match["code"] is not None:
            for name, at in _free_names(match["code"]):
                if name in _GLOBAL or name in scope.names:
                    continue
                near = scope.slips("names").meant(name) or "" if name not in everywhere.names else ""
                if near or _is_certain(scope, element):
                    start = match.start("code") + at
                    where = text.part(start, start + len(name))
                    yield XacroRefused(where, "name", name, near=near, other=scope.names.get(near))
        elif match["extension"]:
            argument = _ARGUMENT.match(match["extension"])
            name = argument["name"] if argument is not None else ""
            if argument is not None and name not in everywhere.arguments:
                like = scope.slips("arguments").meant(name)
                if like is not None and not everywhere.gives(name):
                    start = match.start("extension") + argument.start("name")
                    where = text.part(start, start + len(name))
                    yield XacroRefused(where, "argument", name, near=like, other=scope.arguments[like])


def _free_names(code: str) -> Iterator[tuple[str, int]]:
    """The names of an expression that it does not bind itself, each once with its place; of none that Python does not
    read."""
    import ast

    blanked = _EXTENSION.sub(lambda match: "0".ljust(len(match[0])), code)
    stripped = blanked.strip()
    try:
        tree = ast.parse(stripped, mode="eval")
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return
    names = [each for each in ast.walk(tree) if isinstance(each, ast.Name)]
    bound = {each.id for each in names if not isinstance(each.ctx, ast.Load)}
    bound |= {each.arg for each in ast.walk(tree) if isinstance(each, ast.arg)}
    offset = len(blanked) - len(blanked.lstrip())
    is_plain = stripped.isascii() and "\n" not in stripped
    seen = set(bound)
    for each in names:
        if each.id not in seen:
            seen.add(each.id)
            yield each.id, offset + each.col_offset if is_plain else max(code.find(each.id), 0)


def _is_certain(scope: Scope, element: Element) -> bool:
    """Whether xacro surely comes to an element, and nothing from elsewhere can define what it names. It evaluates a
    property when this is used."""
    if scope.is_open or scope.is_opaque or element.name == "xacro:property":
        return False
    for each in element.ancestors:
        if each.name in ("xacro:if", "xacro:unless"):
            return False
        name = each.get("name") if each.name == "xacro:macro" else None
        if name is not None and name.removeprefix("xacro:") not in scope.called:
            return False
    return True
