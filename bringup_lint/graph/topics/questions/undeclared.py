"""Parameters that a launched node is given and does not declare, and those that a source asks for all the same."""

from __future__ import annotations

import re
from collections.abc import Callable
from collections.abc import Iterator
from operator import attrgetter
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.parameters import is_of_library
from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.memo import memo
from bringup_lint.graph.params.loads import path_of
from bringup_lint.graph.topics.resolved.velocity_types import NEEDED
from bringup_lint.graph.topics.resolved.velocity_types import switch
from bringup_lint.model.launch_values import Choice
from bringup_lint.model.launch_values import DerivedFile
from bringup_lint.model.launch_values import DictValue
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import ParameterFile
from bringup_lint.model.launch_values import TypedValue
from bringup_lint.model.launch_values import Value
from bringup_lint.model.parameter_words import Asked
from bringup_lint.model.params import matches
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.topics.resolved.endpoint_use import LaunchedNode
    from bringup_lint.graph.topics.topics import Topics
    from bringup_lint.model.params import Block


_REMARK = regex(r"//|#|<!--")
_UNNEEDED = regex(
    r"\b(?:(?:not|no longer|never) (?:needed|used|read|required)|unused|obsolete|ignored)\b",
    re.I,
    "needed used read required obsolete ignored",
)
"""What a comment says after the name."""
_FUNCTION = regex(r"^(?P<indent>[ \t]*)(?:async )?def (?P<name>\w+)", re.M)


class GivenName(NamedTuple):
    """A parameter that something gives to a node."""

    name: str
    place: Located
    group: Span
    """The block of the file, or the node in the launch file: what is given together."""
    certain: bool = True
    """It is given to this node, as far as the names are known."""


class Undeclared(NamedTuple):
    """Parameters of one block or launch action that no node which gets them declares."""

    node: LaunchedNode
    given: tuple[GivenName, ...]
    is_unneeded: bool
    """Comments of the package say that it does without them."""


def undeclared(topics: Topics) -> Iterator[Undeclared]:
    """What is given together, each once; silent where a node that may get it is not known, and where the file gives the
    same to another program that has the name of the node, as a simulation of the real one has."""
    verdicts: dict[Span, bool] = {}
    namesakes: dict[tuple[Source, str, str], bool] = {}
    found: dict[Span, tuple[LaunchedNode, GivenName]] = {}
    for node, given in given_together(topics):
        words = topics.parameter_words(node.started)
        span = given.place.span
        lacks = words is not None and not words.name(given.name) and not is_of_library(given.name)
        verdicts[span] = verdicts.get(span, True) and lacks
        key = (span.source, node.label(), given.name)
        namesakes[key] = namesakes.get(key, True) and lacks
        if given.certain:
            found.setdefault(span, (node, given))
    grouped: dict[Span, list[tuple[LaunchedNode, GivenName]]] = {}
    for span, (node, given) in found.items():
        lacks = verdicts[span] and namesakes[span.source, node.label(), given.name]
        if lacks and span.source.judged and not _is_read_by_launch(node, given):
            grouped.setdefault(given.group, []).append((node, given))
    for pairs in grouped.values():
        names = {given.name for _, given in pairs}
        yield Undeclared(pairs[0][0], tuple(given for _, given in pairs), _are_unneeded(topics, pairs[0][0], names))


def _are_unneeded(topics: Topics, node: LaunchedNode, names: set[str]) -> bool:
    """Whether comments beside all the names, in the launch file or in the sources of the package, say that nodes do
    without them."""
    own = (*_remarks_of(topics, literal_text(node.started.package) or ""), *_remarks(node.started.file.source))
    return all(any(name in line and _UNNEEDED.search(line.partition(name)[2]) for line in own) for name in names)


@memo
def _remarks_of(topics: Topics, package: str) -> list[str]:
    """What comments in the nodes of a package call unneeded; of none, in the nodes that are of no package."""
    workspace = topics.launch.workspace
    owner = workspace.packages.get(package)
    sources = (each for each in topics.files.of_kind("python-node", "cpp-node") if workspace.owner(each) is owner)
    return [line for each in sources for line in _remarks(each)]


def _remarks(source: Source) -> list[str]:
    """The lines of a file with a comment that calls something unneeded."""
    return source.once(_UNNEEDED, lambda: [*filter(_is_remark, source.text.splitlines())])


def _is_remark(line: str) -> bool:
    return _UNNEEDED.search(line) is not None and _REMARK.search(line) is not None


def _is_read_by_launch(node: LaunchedNode, given: GivenName) -> bool:
    """Whether the launch file reads a value of a parameter file itself, such as one that says whether to start it."""
    source = node.started.file.source
    quoted = (f"{quote}{given.name}{quote}" in source.text for quote in "\"'")
    return given.place.span.source is not source and any(quoted)


def is_called_nowhere(topics: Topics, place: Span) -> bool:
    """Whether a place is in a Python function that neither its own file nor one that names the module names again: code
    that never runs."""
    before = place.source.text[: place.start]
    indent = len(place.source.line_text(place.line)) - len(place.source.line_text(place.line).lstrip())
    around = [each for each in _FUNCTION.finditer(before) if len(each["indent"]) < indent]
    if not around or not place.source.name.endswith(".py"):
        return False
    name = around[-1]["name"]
    written = re.escape(name)
    word = regex(rf":{written}\b|(?<![\w\"'])(?<!def ){written}\b(?![\w\"'])")
    module = place.source.basename.removesuffix(".py")
    sources = (each for each in topics.files.sources if each.name.endswith(".py") and name in each.text)
    callers = (each for each in sources if each is place.source or module in each.text)
    return not name.startswith("__") and not any(word.search(each.text) for each in callers)


def asked_in_vain(topics: Topics) -> Iterator[Located]:
    """Where a program of the workspace asks its node for a parameter that nothing in it declares, and raises."""
    return _asked_and_lacking(topics, attrgetter("required"))


def asked_quietly(topics: Topics) -> Iterator[Located]:
    """The same where the call does not raise, but leaves a default in place whatever sets the parameter."""
    return _asked_and_lacking(topics, attrgetter("is_quiet"))


def _asked_and_lacking(topics: Topics, is_meant: Callable[[Asked], bool]) -> Iterator[Located]:
    verdicts: dict[Span, bool] = {}
    found: dict[Span, Located] = {}
    for words in topics.all_parameter_words:
        for asked in words.asked:
            lacks = is_meant(asked) and not words.name(asked.name) and not is_of_library(asked.name)
            verdicts[asked.name.span] = verdicts.get(asked.name.span, True) and lacks
            found[asked.name.span] = asked.name
    lacking = (name for span, name in found.items() if verdicts[span] and span.source.judged)
    return (name for name in lacking if not topics.may_be_declared_for(name))


def given_together(topics: Topics) -> Iterator[tuple[LaunchedNode, GivenName]]:
    """What each launch gives to its nodes; what is for one by its name, only to this one, and not to those whose names
    are not known: two of one name do not start together."""
    for expansion in topics.launch.expansions:
        nodes = [topics.node(each) for each in expansion.nodes if each.is_node]
        pairs = [(node, given) for node in nodes for given in _given_to(topics, node)]
        certain = {given.place.span for _, given in pairs if given.certain}
        yield from ((node, given) for node, given in pairs if given.certain or given.place.span not in certain)


def _launched(topics: Topics) -> Iterator[LaunchedNode]:
    for expansion in topics.launch.expansions:
        yield from (topics.node(each) for each in expansion.nodes if each.is_node)


def _given_to(topics: Topics, node: LaunchedNode) -> Iterator[GivenName]:
    for source in node.started.parameters:
        for value in _options(source):
            if isinstance(value, DictValue):
                yield from _inline(value, "", node.started.span)
            else:
                yield from _of_source(topics, value, node)


def _options(value: Value) -> Iterator[Value]:
    if isinstance(value, Choice):
        for _, option in value.options:
            yield from _options(option)
    else:
        yield value


def _of_source(topics: Topics, value: Value, node: LaunchedNode) -> Iterator[GivenName]:
    rewritten = False
    while isinstance(value, (ParameterFile, DerivedFile)):
        rewritten |= isinstance(value, DerivedFile)
        value = value.base if isinstance(value, DerivedFile) else value.file
    path = path_of(topics.launch, value)
    file = topics.params().at_path(path) if path is not None else None
    if file is None or not file.accepted or file.uncertain or file.source.template:
        return
    for block in file.blocks:
        if _may_reach(block, node, rewritten):
            certain = node.fqn is not None or block.name.strip("/") == "**"
            yield from (GivenName(each.name, each.key, block.span, certain) for each in block.parameters)


def _inline(values: DictValue, prefix: str, group: Span) -> Iterator[GivenName]:
    for key, value in values.items:
        name = text_of(key)
        inner = value.value if isinstance(value, TypedValue) else value
        if name is None or not isinstance(key, Literal) or not isinstance(key.text, Located):
            continue
        if isinstance(inner, DictValue):
            yield from _inline(inner, f"{prefix}{name}.", group)
        else:
            yield GivenName(prefix + name, key.text, group)


def _may_reach(block: Block, node: LaunchedNode, rewritten: bool) -> bool:
    """Whether a block may be for a node; a file that is rewritten may get another namespace."""
    if node.fqn is None:
        return True
    own = block.name.rpartition("/")[2]
    return matches(block.name, node.fqn) or (rewritten and (own == node.name or "*" in own))


class Unset(NamedTuple):
    """A launched node that ends because nothing gives it a parameter."""

    node: LaunchedNode
    declared: Located


def unset(topics: Topics) -> Iterator[Unset]:
    """Nodes that start by default, know all that they are given, and are not given what they need; each action once."""
    seen: set[tuple[Span, str]] = set()
    for node in _launched(topics):
        words = topics.parameter_words(node.started)
        if words is None or not words.unset or node.given is None or node.given.open:
            continue
        if node.started.by_default is not True or node.name is None:
            continue
        for declared in words.unset:
            key = (node.started.span, str(declared))
            if declared not in node.given.values and key not in seen:
                seen.add(key)
                yield Unset(node, declared)


class Switchless(NamedTuple):
    """A launched node of a public package that is not told which type its velocities have."""

    node: LaunchedNode
    parameter: str
    distribution: str


def switchless(topics: Topics) -> Iterator[Switchless]:
    """Nodes of which all parameters are known and that start by default; each action once."""
    distribution, seen = topics.params().distribution, set()
    for node in _launched(topics):
        package = str(literal_text(node.started.package))
        found = switch(package, distribution) if package not in topics.launch.workspace.packages else None
        if found is None or found.default != NEEDED or str(literal_text(node.started.executable)) != package:
            continue
        if node.given is None or node.given.open or node.name is None or node.started.by_default is not True:
            continue
        if found.parameter not in node.given.values and node.started.span not in seen:
            seen.add(node.started.span)
            yield Switchless(node, found.parameter, str(distribution))
