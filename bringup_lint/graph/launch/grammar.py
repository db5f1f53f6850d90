"""What launch refuses in XML and YAML launch files: a file with one such place is not loaded at all."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.facts.ros import launch_grammar
from bringup_lint.facts.ros.launch_grammar import Entity
from bringup_lint.facts.ros.launch_grammar import Grammar
from bringup_lint.graph.launch.grammar_values import parameter_problem
from bringup_lint.graph.launch.grammar_values import texts_of
from bringup_lint.graph.launch.grammar_values import value_problem
from bringup_lint.model.launch import LaunchFile
from bringup_lint.model.launch_tag import Tag
from bringup_lint.model.launch_tag import Written
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.launch_frontend.template import Refused
from bringup_lint.parsers.launch_frontend.template import template
from bringup_lint.parsers.launch_frontend.template import unbalanced
from bringup_lint.source import Located
from bringup_lint.source import Span
from bringup_lint.spelling import nearest

_LONG = 3
"""Letters of a name with which another begins."""
_PARSED = ("template", "command", "number", "truth")
"""Types of attributes in which launch looks for substitutions."""
_SHAPES = {
    "several-keys": "an item has more than one key: each item is one tag",
    "no-map": "a tag needs its attributes below it",
    "not-a-list": "children must be a list",
}


class Refusal(NamedTuple):
    """One place for which launch does not load the file."""

    code: str
    """``tag``, ``attribute``, ``missing``, ``value``, ``substitution`` or ``shape``."""
    where: Located | Span
    message: str
    """What is wrong, without the effect."""
    near: tuple[str, ...] = ()
    """The names that may have been meant."""
    extension: bool = False
    """An extension of launch could define the name."""
    is_spelling: bool = True
    """Only the name has to be written in another way; what it holds stays as it is."""

    @property
    def word(self) -> Located:
        """The place with its text."""
        return self.where if isinstance(self.where, Located) else Located(self.where.text, self.where)

    @property
    def effect(self) -> str:
        """What is wrong and what follows, as a sentence."""
        return f"{self.message[:1].upper()}{self.message[1:]}: launch refuses the file"


class Checker:
    """Compares the tags of one file with the grammar of a distribution."""

    def __init__(self, grammar: Grammar) -> None:
        self.grammar = grammar

    def file(self, root: Tag) -> Iterator[Refusal]:
        yield from self.shape(root)
        entity = self.grammar.entities["launch"]
        if root.form == "map" and root.actions is None and not root.problems:
            yield Refusal("shape", root.place, "'launch' needs a list of tags")
        yield from self.attributes(root, entity)
        yield from self.actions(root)

    def actions(self, tag: Tag, skipped: Iterable[str] = ()) -> Iterator[Refusal]:
        for child in tag.actions or ():
            if child.name in skipped:
                continue
            entity = self.grammar.entities.get(str(child.name))
            if entity is None or not entity.is_action:
                yield self.unknown_tag(child.name)
            else:
                yield from self.entity(child, entity)

    def unknown_tag(self, name: Located) -> Refusal:
        near = tuple(nearest(name, self.grammar.actions, 3))
        known = name in self.grammar.entities
        why = f"'{name}' is not allowed here" if known else f"launch has no tag '{name}'"
        return Refusal("tag", name, why, near, extension=not near and not known)

    def shape(self, tag: Tag) -> Iterator[Refusal]:
        for problem in tag.problems:
            if problem.code in _SHAPES:
                yield Refusal("shape", problem.where, _SHAPES[problem.code])

    def entity(self, tag: Tag, entity: Entity) -> Iterator[Refusal]:
        yield from self.shape(tag)
        if tag.problems:
            return
        own = list(self.attributes(tag, entity))
        if entity.name in ("param", "nested_param"):
            own += self.parameter(tag, nested=entity.name == "nested_param")
        is_misnamed = any(refusal.code == "attribute" for refusal in own)
        yield from (refusal for refusal in own if refusal.code != "missing" or not is_misnamed)
        yield from self.children(tag, entity)
        if entity.holds_actions:
            if tag.actions is None:
                yield Refusal("missing", tag.name, f"'{tag.name}' needs a list 'children'")
            yield from self.actions(tag, entity.children)

    def attributes(self, tag: Tag, entity: Entity) -> Iterator[Refusal]:
        for name, attribute in entity.attributes.items():
            written = tag.attributes.get(name)
            if written is not None:
                separated = f"{name}-sep" in tag.attributes and tag.form == "xml"
                if not (entity.name.endswith("param") and name == "value"):
                    yield from self.value(tag, attribute.type, written, separated=separated)
            elif attribute.required and name not in tag.lists:
                yield Refusal("missing", tag.name, f"'{tag.name}' needs the attribute '{name}'")
        if "if" in tag.attributes and "unless" in tag.attributes and "if" in entity.attributes:
            yield Refusal("value", tag.attributes["unless"].key, "'if' and 'unless' exclude each other")
        if entity.is_open:
            return
        known = {*entity.attributes, *entity.children} if tag.form != "xml" else set(entity.attributes)
        for name, written in tag.attributes.items():
            base = name.removesuffix("-sep")
            if name not in known and not (tag.form == "xml" and base in known and base in tag.attributes):
                yield self.unknown_attribute(tag, entity, written.key)

    def unknown_attribute(self, tag: Tag, entity: Entity, key: Located) -> Refusal:
        free = [name for name in entity.attributes if name not in tag.attributes]
        near = tuple(nearest(key, free, 3))
        meant = near or tuple(_meant(tag, entity, str(key), free))
        return Refusal("attribute", key, f"'{tag.name}' has no attribute '{key}'", meant, is_spelling=bool(near))

    def children(self, tag: Tag, entity: Entity) -> Iterator[Refusal]:
        for name, child in entity.children.items():
            inner = tag.lists.get(name, ())
            if child.required and not inner:
                yield Refusal("missing", tag.name, f"'{tag.name}' needs a '{name}'")
            for each in inner:
                yield from self.entity(each, self.grammar.entities[child.entity])
            if name in tag.attributes and name not in tag.keys and tag.form != "xml":
                yield Refusal("value", tag.attributes[name].key, f"'{name}' must be a list of maps")
        for name, key in tag.keys.items():
            if name not in entity.children and not entity.is_open and not (entity.holds_actions and tag.form == "xml"):
                near = tuple(nearest(name, entity.children, 3))
                yield Refusal("tag", key, f"'{tag.name}' takes no '{name}'", near)
            elif name in tag.attributes:
                yield Refusal("value", key, f"'{name}' is empty")
        if tag.form != "xml" and tag.actions is not None and not entity.holds_actions:
            yield Refusal("tag", tag.name, f"'{tag.name}' holds no tags")

    def value(self, tag: Tag, kind: str, written: Written, *, separated: bool = False) -> Iterator[Refusal]:
        found = value_problem(kind, written.value, tag.form, separated=separated)
        if found is not None:
            yield Refusal("value", written.text if written.text else written.key, f"'{written.key}' {found}")
        elif kind in _PARSED and isinstance(written.value, str):
            yield from self.template(written.text, command=kind == "command")

    def template(self, text: Located, *, command: bool = False) -> Iterator[Refusal]:
        """What the grammar of substitutions does not take in a text."""
        if "$" not in text and not command:
            return
        try:
            found = template(text)
        except Refused as error:
            at = min(error.at, len(text))
            yield Refusal("substitution", text.part(at, min(at + 1, len(text))), error.why)
            return
        for used in found.used:
            yield from self.substitution(text.part(used.start, used.end), used.arguments)
        if command:
            for why in unbalanced(found.texts):
                yield Refusal("value", text, f"the command cannot be split: {why}")

    def substitution(self, name: Located, arguments: int) -> Iterator[Refusal]:
        count = self.grammar.substitutions.get(str(name))
        if count is None:
            near = tuple(nearest(name, self.grammar.substitutions, 3))
            yield Refusal("substitution", name, f"launch has no substitution '{name}'", near, extension=not near)
        elif arguments < count.least or (count.most is not None and arguments > count.most):
            wanted = str(count.least) if count.least == count.most else f"{count.least} to {count.most}"
            plural = "" if wanted == "1" else "s"
            yield Refusal("substitution", name, f"'{name}' takes {wanted} argument{plural}, not {arguments}")

    def parameter(self, tag: Tag, *, nested: bool) -> Iterator[Refusal]:
        """The rules for a ``param``: from a file, with a value, or with parameters inside."""
        has = {*tag.attributes, *tag.lists}
        if not nested and "from" in has:
            for name in ("name", "value", "type", "param"):
                if name in has:
                    where = tag.attributes[name].key if name in tag.attributes else tag.keys[name]
                    yield Refusal("attribute", where, f"'{name}' and 'from' exclude each other")
            return
        if "name" not in has:
            if not nested:
                yield Refusal("missing", tag.name, "a 'param' needs the attribute 'name' or 'from'")
            return
        if "allow_substs" in tag.attributes:
            yield Refusal("attribute", tag.attributes["allow_substs"].key, "'allow_substs' goes with 'from' only")
        written = tag.attributes.get("value")
        inner = bool(tag.lists.get("param"))
        if written is None and not inner:
            yield Refusal("missing", tag.name, "a 'param' needs the attribute 'value'")
        for name in ("value", "type"):
            if inner and name in tag.attributes:
                yield Refusal("attribute", tag.attributes[name].key, f"'{name}' excludes parameters inside")
        if written is not None:
            yield from self.parameter_value(tag, written)

    def parameter_value(self, tag: Tag, written: Written) -> Iterator[Refusal]:
        kind = tag.attributes.get("type")
        separator = tag.attributes.get("value-sep") if tag.form == "xml" else None
        found = parameter_problem(
            written.value,
            str(kind.value) if kind else "yaml",
            tag.form,
            None if separator is None else str(separator.text),
        )
        if found is not None:
            yield Refusal("value", written.text if written.text else written.key, f"'value' {found}")
        elif isinstance(written.value, str) and separator is None:
            yield from self.template(written.text)
        else:
            for text in texts_of(written.value, None if separator is None else str(separator.text)):
                yield from self.template(Located(text, written.text.span))


def refusals(file: LaunchFile, distribution: str | None) -> list[Refusal]:
    """Everything for which launch of a distribution refuses an XML or YAML file that is well formed."""
    if file.tag is None:
        return []
    return list(Checker(launch_grammar.grammar(distribution)).file(file.tag))


def _meant(tag: Tag, entity: Entity, key: str, free: list[str]) -> Iterator[str]:
    """The name that a longer one stands for, as the Python API has some, or the one that the tag lacks."""
    names = [*free, *(() if tag.form == "xml" else entity.children)]
    for name in names:
        if name == key.replace("arguments", "args") or (len(name) >= _LONG and key.startswith(name)):
            yield name
    if entity.name == "param" and "value" in tag.attributes and tag.attributes.keys().isdisjoint(("name", "from")):
        yield "name"
