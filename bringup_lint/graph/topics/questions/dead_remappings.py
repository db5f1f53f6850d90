"""Remappings of a name that a program does not use, or uses in another namespace only."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.node_names import node_names
from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.topics.resolved.names import expand
from bringup_lint.graph.topics.resolved.names import tail
from bringup_lint.graph.topics.resolved.remapping import remapping
from bringup_lint.model.launch_values import same
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.topics.resolved.endpoint_use import LaunchedNode
    from bringup_lint.graph.topics.sources.code import Code
    from bringup_lint.graph.topics.topics import Topics
    from bringup_lint.model.launch_values import Value
    from bringup_lint.model.parameter_words import ParameterWords
    from bringup_lint.source import Span

OF_LIBRARIES = regex(
    r"^(?:tf|tf_static|clock|rosout|parameter_events|bond|diagnostics|statistics|robot_description|(?:set_)?camera_info"
    r"|(?:describe|get|list|set)_parameters?(?:_types|_atomically)?|get_type_description|transition_event"
    r"|change_state|get_state|get_available_(?:states|transitions)|get_transition_graph)$"
)
"""Last parts of names that the client library, or a common one, gives to topics and services by itself."""
_NAMES_ITSELF = regex(
    r"\byaml\b|YAML::|\bjson\b|\bgetenv\b|\benviron\b|configparser|image_transport|[Gg]eneric_?(?:[Pp]ub|[Ss]ub)"
    r"|nav2_simple_commander|BasicNavigator|\bmoveit|interactive_markers|rosbag2",
    hints="yaml YAML:: json getenv environ configparser image_transport eneric nav2_simple BasicNavigator moveit "
    "interactive_markers rosbag2",
)
"""What a source may take names from, and libraries that make names of their own."""


class DeadRemapping(NamedTuple):
    node: LaunchedNode
    source: Located
    """The side of the rule that should match."""
    instead: tuple[str, ...]
    """Names that the program uses."""
    used: Located | None = None
    """Where the program uses the same name, in another namespace."""

    @property
    def target(self) -> Value | None:
        """The name that the rule would give."""
        pairs = self.node.started.remappings
        return next((target for source, target in pairs if literal_text(source) is self.source), None)

    @property
    def harmless(self) -> bool:
        """Whether the node uses the name that it should get all the same, or another rule gives it that name; or the
        rule would only take the namespace of the root away, as many are told to for all their nodes."""
        names = {str(self.source), *(str(use.written) for use in (*self.node.uses, *self.node.calls) if use.written)}
        if self.node.given is not None:
            names.update(str(each.value) for each in self.node.given.values.values())
        own = {name.lstrip("/") for name in names}
        target = text_of(self.target) if self.target is not None else None
        return (target is not None and target.lstrip("/") in own) or self._is_given_by_another

    @property
    def _is_given_by_another(self) -> bool:
        rules = ((literal_text(source), target) for source, target in self.node.started.remappings)
        return any(source in self.instead and same(target, self.target) for source, target in rules)


def dead_remappings(topics: Topics) -> Iterator[DeadRemapping]:
    """Each place once; one that reaches several programs matches in none of them."""
    found: dict[Span, list[DeadRemapping | None]] = {}
    for expansion in topics.launch.expansions:
        for started in expansion.nodes:
            own = len(getattr(started.action, "remappings", ()))
            for source, _ in started.remappings[len(started.remappings) - own :]:
                text = literal_text(source)
                if text is not None:
                    found.setdefault(text.span, []).append(_dead(topics, topics.node(started), text))
    for verdicts in found.values():
        if verdicts[0] is not None and all(verdicts):
            yield verdicts[0]


def _dead(topics: Topics, node: LaunchedNode, source: Located) -> DeadRemapping | None:
    rule = remapping(f"{source}:=x")
    if rule is None or rule.node is not None or rule.match.startswith("__") or OF_LIBRARIES.match(tail(rule.match)):
        return None
    code = topics.code(node.started)
    if code is None:
        return _of_public(topics, node, source, rule.match)
    words = topics.parameter_words(node.started)
    if words is None or not _says_all_names(node, code):
        return None
    if not _names(words, node, rule.match):
        return DeadRemapping(node, source, ())
    return _elsewhere(words, node, code, source, rule.match)


def _of_public(topics: Topics, node: LaunchedNode, source: Located, match: str) -> DeadRemapping | None:
    package = str(literal_text(node.started.package))
    workspace = topics.launch.workspace
    if package in workspace.packages or package in workspace.ambiguous:
        return None
    known = node_names(package, str(node.started.program))
    name = match.lstrip("~/")
    if known is None or known.has(name):
        return None
    if known.may_be_given(name) and (node.given is None or node.given.open or _is_value(node, name)):
        return None
    return DeadRemapping(node, source, tuple(known.plain))


def _is_value(node: LaunchedNode, name: str) -> bool:
    """Whether a parameter of the node holds a name, or what is called a topic has a value that is not known."""
    if node.given is None:
        return False
    return any(
        name in (each.where.text if each.value is None else str(each.value))
        or (each.value is None and "topic" in parameter)
        for parameter, each in node.given.values.items()
    )


def _says_all_names(node: LaunchedNode, code: Code) -> bool:
    """Whether the sources of a program say all names, as far as its parameters do not."""
    if node.given is None or node.given.open or code.source is None or code.source.matches(_NAMES_ITSELF):
        return False
    return all(each.name is not None or each.parameter is not None for each in code.endpoints)


def _names(words: ParameterWords, node: LaunchedNode, name: str) -> bool:
    """Whether a text of the program, or a value that it is given, may be a part of a name."""
    parts = [part for part in name.strip("~").split("/") if part]
    if any(part in text for part in parts for text in words.texts) or any(_is_value(node, part) for part in parts):
        return True
    pieces = (piece.strip("/_ ") for piece in words.joined)
    return any(piece and piece in name for piece in pieces)


def _elsewhere(
    words: ParameterWords, node: LaunchedNode, code: Code, source: Located, match: str
) -> DeadRemapping | None:
    """The one name in the program that ends like the remapped one, when both are known and differ."""
    alike = [each.name for each in code.endpoints if each.name is not None and tail(each.name) == tail(match)]
    others = [text for text in words.texts if tail(match) in text and text not in alike]
    if len(set(alike)) != 1 or others or not isinstance(alike[0], Located) or _is_value(node, tail(match)):
        return None
    ours, theirs = expand(match, node.name, node.namespace), expand(alike[0], node.name, node.namespace)
    if ours is None or theirs is None or ours == theirs:
        return None
    return DeadRemapping(node, source, (str(alike[0]),), alike[0])
