"""Cyclone DDS configuration: read as a version of the library reads it, with every remark that it would make.

The library refuses a configuration on the first error: no participant, so no ROS node, can be created. This
reader goes on,
so that all errors are found at once.
"""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Mapping

from bringup_lint.model.cyclonedds import Configuration
from bringup_lint.model.cyclonedds import Domain
from bringup_lint.model.cyclonedds import Item
from bringup_lint.model.cyclonedds import Remark
from bringup_lint.model.cyclonedds import Setting
from bringup_lint.model.xml import Document
from bringup_lint.model.xml import Element
from bringup_lint.parsers.cyclonedds_checks import check
from bringup_lint.parsers.cyclonedds_checks import interfaces_twice
from bringup_lint.parsers.cyclonedds_schema import match
from bringup_lint.parsers.cyclonedds_schema import schema
from bringup_lint.parsers.cyclonedds_values import complaint
from bringup_lint.parsers.environment import ExpansionError
from bringup_lint.parsers.environment import UnknownVariable
from bringup_lint.parsers.environment import expand
from bringup_lint.parsers.xml import parse as parse_xml
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span

DEFAULT_VERSION = "0.10"
"""What Humble and Jazzy ship."""
ALL_FEATURES = frozenset({"security", "ssl", "tcp", "shm", "network_partitions", "topic_discovery"})
"""Compile-time features of the library as ROS packages it."""

TOLERATED = frozenset(
    {
        "bad-comment",
        "cdata-end",
        "control-character",
        "doctype",
        "encoding",
        "late-declaration",
        "bad-declaration",
        "bad-instruction",
        "empty-document",
        "less-than-in-value",
        "missing-blank",
        "duplicate-attribute",
        "undeclared-prefix",
    }
)
"""XML problems that the library's own reader does not mind; duplicate attributes it reports as duplicate
settings."""
INLINE_TOLERATED = TOLERATED | {"unclosed-element", "second-root", "text-outside-root"}
"""Inline XML may be cut off, and other documents may follow it."""


def parse(
    source: Source,
    version: str = DEFAULT_VERSION,
    *,
    inline: bool = False,
    environment: Mapping[str, str] | None = None,
    features: frozenset[str] = ALL_FEATURES,
    region: tuple[int, int] | None = None,
) -> Configuration:
    """Read a configuration, or the stretch of a source that holds one. ``environment`` None means that
    variables are not known: such values are not judged."""
    document = parse_xml(source, *(region or ()))
    return read(document, version, inline=inline, environment=environment, features=features)


def read(
    document: Document,
    version: str = DEFAULT_VERSION,
    *,
    inline: bool = False,
    environment: Mapping[str, str] | None = None,
    features: frozenset[str] = ALL_FEATURES,
) -> Configuration:
    """Read a document that is already parsed as XML."""
    configuration = Configuration(document.source, document, version, inline)
    tolerated = INLINE_TOLERATED if inline else TOLERATED
    for problem in document.problems:
        fatal = problem.code not in tolerated or (problem.code == "doctype" and _has_subset(document))
        if problem.code == "duplicate-attribute":
            configuration.remarks.append(Remark("duplicate", problem.where, True, problem.detail))
        elif fatal or problem.code == "doctype":
            configuration.remarks.append(Remark("xml", problem.where, fatal, f"{problem.code}: {problem.detail}"))
    if inline and document.root is not None and "</>" in document.root.span.text:
        # the shorthand end tag of inline XML is not read
        configuration.remarks.clear()
        return configuration
    _refused_by_its_xml_reader(document, configuration)
    if document.root is not None:
        _Reader(configuration, environment, features).document(document.root)
    for domain in configuration.domains:
        domain.remarks.extend(check(domain, version))
    interfaces_twice(configuration.domains)
    return configuration


def _refused_by_its_xml_reader(document: Document, configuration: Configuration) -> None:
    """What is well-formed XML, and yet not for this library."""
    if document.source.text.startswith("\ufeff"):
        mark = document.source.span(0, 1)
        configuration.remarks.append(Remark("xml", mark, True, "byte-order-mark: it stands before the first <"))
    for instruction in document.instructions:
        inside = [each for each in document.elements if each.span.start < instruction.start < each.span.end]
        if inside and inside[-1].text:
            detail = "instruction: a processing instruction inside a value"
            configuration.remarks.append(Remark("xml", instruction, True, detail))


def _has_subset(document: Document) -> bool:
    return document.doctype is not None and "[" in document.doctype.text


class _Reader:
    def __init__(self, configuration: Configuration, environment: Mapping[str, str] | None, features: frozenset[str]):
        self.configuration = configuration
        self.environment = environment
        self.features = features
        self.inline = configuration.inline
        self.schema = schema(configuration.version)
        self.domain = Domain(None)
        self.counts: dict[tuple[str, int], int] = {}

    def remark(self, code: str, where: Located | Span, fatal: bool, detail: str = "", item: Item | None = None) -> None:
        self.domain.remarks.append(Remark(code, where, fatal, detail, item))

    def document(self, root: Element) -> None:
        top = self.schema.root
        if root.name.lower() == "cyclonedds":
            self.attributes(root, top, root, into=self.configuration.remarks.append)
            self.text(root, top, root)
            for child in root.children:
                self.block(child, root)
        elif self.inline:
            self.block(root, None)
        else:
            self.configuration.remarks.append(Remark("root", root.name, True, root.name))
            for child in root.find_all("Domain"):
                self.block(child, root)
        if self.domain.element is None and (self.domain.settings or self.domain.remarks or self.domain.elements):
            self.configuration.domains.append(self.domain)

    def block(self, element: Element, parent: Element | None) -> None:
        """A Domain, or a group that stands where Domain should."""
        if element.name.lower() == "domain" or (not self.inline and parent is None):
            before, self.domain = self.domain, Domain(element)
            self.counts = {}
            self.configuration.domains.append(self.domain)
            self.inside(element, self.schema.by_path["CycloneDDS/Domain"], element)
            self.domain = before
            return
        items = self.schema.root.children
        if parent is None:
            items = self.schema.by_path["CycloneDDS/Domain"].children
        self.child(element, items, self.schema.root, parent or element)

    def child(self, element: Element, items: list[Item], inside: Item, owner: Element) -> None:
        """Match one element and read it. ``owner`` is the nearest list element: what must be unique, is so
        inside it."""
        found = match(items, element.name, self.inline)
        item = found.item
        if item is None or (found.how == "prefix" and not self.inline):
            self.unknown(
                "unknown-element" if found.how != "ambiguous" else "ambiguous-name",
                element.name,
                found.item,
                inside,
            )
            return
        self.named(element.name, item, found.how)
        if item.moved_to:
            self.remark("moved", element.name, False, item.moved_to, item)
            item = self.schema.by_path[item.moved_to]
        self.inside(element, item, element if item.many else owner)

    def unknown(self, code: str, name: Located, near: Item | None, inside: Item) -> None:
        if near is not None:
            self.remark("abbreviated", name, True, near.name, near)
        else:
            self.remark(code, name, True, name, inside)

    def named(self, name: Located, item: Item, how: str) -> None:
        if how == "prefix":
            self.remark("abbreviated", name, False, item.name, item)
        elif how == "alias":
            self.remark("alias", name, False, item.name, item)
        elif item.deprecated:
            self.remark("deprecated", name, False, item.name, item)
        if item.build - self.features:
            self.remark("build", name, True, ", ".join(sorted(item.build - self.features)), item)

    def inside(self, element: Element, item: Item, owner: Element) -> None:
        if item.is_attribute:
            # an element that became an attribute, such as Domain/Id
            for attribute in element.attributes:
                self.remark("unknown-attribute", attribute.name, True, attribute.name, item)
            for child in element.children:
                self.remark("unknown-element", child.name, True, child.name, item)
            if element.text:
                self.value(element.name, element.text, item, element, owner)
            return
        self.domain.elements.append((item, element))
        before = len(self.domain.settings)
        self.attributes(element, item, owner)
        for child in element.children:
            self.child(child, item.children, item, owner)
        self.text(element, item, owner)
        if item.many or item.name == "Security":
            self.required(element, item, self.domain.settings[before:])

    def attributes(
        self, element: Element, item: Item, owner: Element, into: Callable[[Remark], None] | None = None
    ) -> None:
        for attribute in element.attributes:
            found = match(item.attributes, attribute.name, self.inline)
            if found.item is None or (found.how == "prefix" and not self.inline):
                if into is not None:
                    into(Remark("unknown-attribute", attribute.name, True, attribute.name, item))
                else:
                    self.unknown("unknown-attribute", attribute.name, found.item, item)
                continue
            self.named(attribute.name, found.item, found.how)
            self.value(attribute.name, attribute.value, found.item, element, owner if not item.many else element)

    def text(self, element: Element, item: Item, owner: Element) -> None:
        text = element.text
        if not text:
            return
        if item.type == "group" or element.children:
            self.remark("unexpected-text", text, True, text, item)
        else:
            self.value(element.name, text, item, element, owner)

    def value(self, name: Located, value: Located, item: Item, element: Element, owner: Element) -> None:
        if item.type == "ignored":
            return
        key = (item.path, id(owner))
        self.counts[key] = self.counts.get(key, 0) + 1
        if self.counts[key] > 1 and item.path != "CycloneDDS/Domain@Id":
            self.remark("duplicate", name, True, item.name, item)
        setting = Setting(item, name, value, self.effective(value, item), element)
        if item.path == "CycloneDDS/Domain@Id":
            self.domain.id = value
        self.domain.add(setting)
        if setting.effective is None:
            return
        problem = complaint(item, setting.effective, self.configuration.version)
        if problem:
            self.remark(problem.code, value, problem.fatal, problem.detail, item)

    def effective(self, value: Located, item: Item) -> str | None:
        try:
            return expand(value, self.environment)
        except UnknownVariable:
            return None
        except ExpansionError as error:
            self.remark("expansion", value, True, str(error), item)
            return None

    def required(self, element: Element, item: Item, settings: list[Setting]) -> None:
        """What has no default must be there: attributes and children, also below groups that are left out."""
        held = {setting.path for setting in settings}
        for needed in _required(item):
            if needed.path not in held:
                self.remark("missing", element.name, True, needed.name, needed)


def _required(item: Item) -> list[Item]:
    found = [each for each in (*item.attributes, *item.children) if each.required and each.type != "group"]
    for child in item.children:
        if not child.many:
            found += [each for each in _required(child) if each not in found]
    return found
