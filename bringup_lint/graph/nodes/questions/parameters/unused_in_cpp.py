"""Values of parameters that C++ nodes read into a variable, and then at most log."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from itertools import islice
from typing import TYPE_CHECKING

from bringup_lint.endings import CPP
from bringup_lint.graph.nodes.questions.parameters.given_in_package import given_in_package
from bringup_lint.graph.nodes.questions.parameters.unused_parameter import UnusedParameter
from bringup_lint.model.cpp_text import plain_of
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.graph.workspace import Package

_CALL = r"(?P<call>get_parameter(?:_or)?|declare_parameter)\s{0,4}(?:<[^;()]{1,80}>)?\s{0,4}\(\s{0,40}"
_NAME = r'(?:\w{1,40}\s{0,4}\+\s{0,4})?"\.?(?P<name>[^"\n]{1,80})"'
_ASKS = regex(_CALL + _NAME, hints="_parameter")
_INTO = regex(r"\s{0,4},\s{0,40}(?:this->)?(?P<variable>[A-Za-z_]\w{1,80})\s{0,4}(?P<end>[,)])")
"""After a call and its name: the variable that gets the value."""
_ENDS = {"get_parameter": (",", ")"), "get_parameter_or": (",",), "declare_parameter": ()}
"""Call -> what follows the second argument, where that gets the value."""
_ASSIGNED = regex(
    r"(?P<before>[;{})]\s{0,200}|[\w>&]\s{1,4})(?:this->)?(?P<variable>[A-Za-z_]\w{1,80})\s{0,4}=\s{0,40}"
    r"(?:static_cast<[^;()]{1,40}>\s{0,4}\(\s{0,4})?(?:\w{1,40}(?:\(\))?\s{0,4}(?:->|\.)\s{0,4}){0,3}\Z"
)
"""Before a call: the variable that its value is assigned to."""
_BEFORE = 600
"""Characters before a call that may belong to its statement."""
_LOG = regex(
    r"\b(?:RCLCPP_[A-Z_]{3,40}|f?printf)\s{0,4}\([^;]{0,600};|\bstd::c(?:out|err|log)\b[^;]{0,600};",
    hints="RCLCPP_ printf std::c",
)
_PLAIN = regex(r"\"(?:[^\"\\\n]|\\.)*\"|'(?:[^'\\\n]|\\.)'|//[^\n]*|/\*(?:[^*]|\*(?!/))*(?:\*/|\Z)")
"""A literal or a comment, whichever begins first: ``"tcp://"`` is no comment."""
_RAW = 'R"'
_IF = regex(r"\bif\s{0,4}\(\s{0,4}(?:\w{1,40}\s{0,4}(?:->|\.)\s{0,4})?\Z")
"""The condition is whether the parameter is there, which is an effect of its own."""
_STRING = regex(r'"(?:[^"\\\n]|\\.)*"', hints='"')
_WORD = regex(r"[A-Za-z_]\w*")
_HEARS = regex(
    r"\badd_(?:on|post|pre)_set_parameters_callback\b|\bParameterEventHandler\b",
    hints="_set_parameters_callback ParameterEventHandler",
)
_HEAD = regex(r"\s*(?:[A-Za-z_][\w:]{0,80}[\s<>,*&]{1,20}){1,12}\Z")
"""What a declaration has before the name: a type, and other names."""
_WORDS_OF_STATEMENTS = regex(r"\b(?:return|delete|using|typedef|extern|friend|goto|throw|case|new|else)\b")
_ACCESS = regex(r"\b(?P<access>public|protected|private)\s{0,4}:(?!:)")
_ENDS_HERE = regex(r"\b(?:PLUGINLIB_EXPORT_CLASS|RCLCPP_COMPONENTS_REGISTER_NODE|int\s{1,4}main)\s{0,4}\(")
"""The class is what is loaded or run: nothing of another package builds on it."""
_CONTAINER = regex(r"\b(?:class|struct|union|enum|namespace)\b")
_BRACES = regex(r"[{}]")
_READS = 200
"""Reads of one source that are looked at."""
_FILES = 300
"""Files of a package that are searched; one with more is left alone."""


class _Read(NamedTuple):
    name: Located
    variable: Located
    call: str
    is_declared: bool
    """The variable is declared there, too."""


class _Package(NamedTuple):
    texts: list[tuple[str, str]]
    """The path of each file, and its text without comments, logs and literals."""
    words: Counter[str]
    logged: set[str]
    literals: Counter[str]
    reads: Counter[str]
    """How often ``get_parameter`` asks for a name."""


def unused_in_cpp(nodes: Nodes) -> Iterator[UnusedParameter]:
    packages: dict[str, _Package | None] = {}
    for node in nodes.cpp:
        source = node.source
        owner = nodes.launch.workspace.owner(source)
        if owner is None or nodes.launch.workspace.is_vendored(source) or _HEARS.search(source.text):
            continue
        for read in islice(_reads(source), _READS):
            if owner.folder not in packages:
                packages[owner.folder] = _package(nodes, owner)
            package = packages[owner.folder]
            if package is not None and _is_unused(package, read, _ENDS_HERE.search(source.text) is not None):
                given = given_in_package(nodes, source, str(read.name))
                yield UnusedParameter(source, read.name, read.variable, given, str(read.variable) in package.logged)


def _reads(source: Source) -> Iterator[_Read]:
    if "_parameter" not in source.text:
        return
    plain = plain_of(source)
    for call in _ASKS.finditer(plain):
        into = _INTO.match(plain, call.end())
        asks = _IF.search(plain, max(call.start() - 100, 0), call.start())
        if into is not None and into["end"] in _ENDS[call["call"]] and not asks:
            yield _read(source, call, into, False)
        assigned = _ASSIGNED.search(plain, max(call.start() - _BEFORE, 0), call.start())
        if assigned is not None:
            yield _read(source, call, assigned, not assigned["before"].startswith((";", "{", "}", ")")))


def _read(source: Source, call: re.Match[str], found: re.Match[str], is_declared: bool) -> _Read:
    name = Located(call["name"], Span(source, *call.span("name")))
    variable = Located(found["variable"], Span(source, *found.span("variable")))
    return _Read(name, variable, call["call"], is_declared)


def _package(nodes: Nodes, owner: Package) -> _Package | None:
    paths = [path for path in nodes.files.tree.walked_below(owner.folder) if path.endswith(CPP)]
    if len(paths) > _FILES:
        return None
    package = _Package([], Counter(), set(), Counter(), Counter())
    for path in paths:
        file = nodes.files.tree.read(path, judged=False)
        if file is None:
            return None
        text = _PLAIN.sub(_without_comment, file.text)
        package.literals.update(each.strip('"') for each in _STRING.findall(text))
        for log in _LOG.findall(text):
            package.logged.update(_WORD.findall(_STRING.sub("", log)))
        package.reads.update(each["name"] for each in _ASKS.finditer(text) if each["call"] != "declare_parameter")
        bare = _LOG.sub(";", text) if _RAW in text else _STRING.sub('""', _LOG.sub(";", text))
        package.texts.append((path, bare))
        package.words.update(_WORD.findall(bare))
    return package


def _without_comment(found: re.Match[str]) -> str:
    return "" if found[0].startswith("/") else found[0] if found[0].startswith('"') else "0"


def _is_unused(package: _Package, read: _Read, is_last: bool) -> bool:
    """Whether the variable is only declared and read into, privately, and the parameter read once."""
    variable, name = str(read.variable), str(read.name)
    is_asked = read.call != "declare_parameter"
    if package.reads[name] != is_asked or package.literals[name] + package.literals[f".{name}"] != 1 + is_asked:
        return False
    if package.words[variable] != 2 - read.is_declared:
        return False
    texts = (each for each in package.texts if variable in each[1])
    return read.is_declared or any(_declares(path, text, variable, is_last) for path, text in texts)


def _declares(path: str, text: str, variable: str, is_last: bool) -> bool:
    """Whether a text declares the variable where nothing outside of the package can use it."""
    for at in re.finditer(rf"\b{re.escape(variable)}\b(?=\s{{0,4}}[;={{,])", text):
        start = max(text.rfind(each, 0, at.start()) for each in ";{}")
        head = _ACCESS.sub("", text[start + 1 : at.start()])
        if _HEAD.match(head) and not _WORDS_OF_STATEMENTS.search(head):
            hidden = ("private", "protected") if is_last else ("private",)
            return "/include/" not in path or _access(text, at.start()) in hidden
    return False


def _access(text: str, at: int) -> str:
    """Who may use what is declared at a place of a header; what is in the body of a function is private."""
    opened = [-1]
    for brace in _BRACES.finditer(text, 0, at):
        if brace[0] == "{":
            opened.append(brace.start())
        elif len(opened) > 1:
            opened.pop()
    end = max(opened[-1], 0)
    head = text[max(text.rfind(each, 0, end) for each in ";{}") + 1 : end]
    kind = _CONTAINER.search(head)
    if kind is None:
        return "private" if "(" in head else "public"
    labels = _ACCESS.findall(text[end:at])
    return labels[-1] if labels else {"class": "private"}.get(kind[0], "public")
