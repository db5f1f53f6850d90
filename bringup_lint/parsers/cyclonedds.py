"""Cyclone DDS configuration: read as a version of the library reads it, with every remark that it would make.

The library refuses a configuration on the first error: no participant, so no ROS node, can be created. This reader goes
on, so that all errors are found at once.
"""

from __future__ import annotations

from collections.abc import Iterator
from collections.abc import Mapping

from bringup_lint.model.cyclonedds import Configuration
from bringup_lint.model.cyclonedds import Domain
from bringup_lint.model.cyclonedds import Setting
from bringup_lint.model.schema import Code
from bringup_lint.model.schema import Item
from bringup_lint.model.schema import Remark
from bringup_lint.model.xml import Document
from bringup_lint.model.xml import Element
from bringup_lint.parsers.cyclonedds_checks import check
from bringup_lint.parsers.cyclonedds_checks import interfaces_twice
from bringup_lint.parsers.cyclonedds_schema import IN_FILES
from bringup_lint.parsers.cyclonedds_schema import INLINE
from bringup_lint.parsers.cyclonedds_schema import features_of
from bringup_lint.parsers.cyclonedds_schema import repeats
from bringup_lint.parsers.cyclonedds_schema import schema
from bringup_lint.parsers.cyclonedds_values import fault_of
from bringup_lint.parsers.environment import ExpansionError
from bringup_lint.parsers.environment import UnknownVariable
from bringup_lint.parsers.environment import expand
from bringup_lint.parsers.xml import parse as parse_xml
from bringup_lint.schema.walk import level
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
        "misplaced-declaration",
        "bad-declaration",
        "bad-instruction",
        "empty-document",
        "less-than-in-value",
        "missing-blank",
        "duplicate-attribute",
        "undeclared-prefix",
    }
)
"""XML problems that the library's own reader does not mind; it reports duplicate attributes as duplicate settings."""
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
            configuration.remarks.append(Remark(Code.DUPLICATE, problem.where, problem.detail))
        elif fatal or problem.code == "doctype":
            configuration.remarks.append(Remark(Code.XML, problem.where, problem.detail, fatal, xml=problem.code))
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
        configuration.remarks.append(Remark(Code.XML, mark, "it appears before the first <", xml="byte-order-mark"))
    for instruction in document.instructions:
        inside = [each for each in document.elements if each.span.start < instruction.start < each.span.end]
        if inside and inside[-1].text:
            detail = "a processing instruction inside a value"
            configuration.remarks.append(Remark(Code.XML, instruction, detail, xml="instruction"))


def _has_subset(document: Document) -> bool:
    return document.doctype is not None and "[" in document.doctype.text


DOMAIN = "CycloneDDS/Domain"


class _Reader:
    def __init__(self, configuration: Configuration, environment: Mapping[str, str] | None, features: frozenset[str]):
        self.configuration = configuration
        self.environment = environment
        self.features = features
        self.inline = configuration.inline
        self.spelling = INLINE if self.inline else IN_FILES
        self.items = schema(configuration.version).items
        self.domain = Domain(None)
        self.counts: dict[tuple[str, int], int] = {}

    def remark(self, code: Code, where: Located | Span, detail: str, item: Item, fatal: bool = True) -> None:
        self.domain.remarks.append(Remark(code, where, detail, fatal, item))

    def document(self, root: Element) -> None:
        top = self.items["CycloneDDS"]
        if root.name.lower() == "cyclonedds":
            self.attributes(root, top, root, self.configuration.remarks)
            self.text(root, top, root)
            for child in root.children:
                self.block(child, root)
        elif self.inline:
            self.block(root, None)
        else:
            self.configuration.remarks.append(Remark(Code.ROOT, root.name, root.name))
            for child in root.find_all("Domain"):
                self.block(child, root)
        if self.domain.element is None and (self.domain.settings or self.domain.remarks or self.domain.elements):
            self.configuration.domains.append(self.domain)

    def block(self, element: Element, parent: Element | None) -> None:
        """A Domain, or a group in its place."""
        top = self.items["CycloneDDS"]
        if element.name.lower() == "domain" or (not self.inline and parent is None):
            before, self.domain = self.domain, Domain(element)
            self.counts = {}
            self.configuration.domains.append(self.domain)
            self.inside(element, self.items[DOMAIN], element)
            self.domain = before
        elif parent is None:
            self.children([element], self.items[DOMAIN].children, top, element)
        else:
            self.children([element], top.children, top, parent)

    def children(self, elements: list[Element], items: Mapping[str, Item], inside: Item, owner: Element) -> None:
        """Match elements and read them. ``owner`` is the nearest list element: what must be unique, is so inside it."""
        for element in elements:
            found = level([(element.name, element)], items, inside, self.spelling)
            self.domain.remarks.extend(found.remarks)
            for _, known in found.known:
                self.built(element.name, known)
                item = known
                if known.moved_to:
                    self.remark(Code.MOVED, element.name, known.moved_to, known, False)
                    item = self.items[known.moved_to]
                self.inside(element, item, element if repeats(item) else owner)

    def built(self, name: Located, item: Item) -> None:
        lacking = features_of(item, self.configuration.version) - self.features
        if lacking:
            self.remark(Code.BUILD, name, ", ".join(sorted(lacking)), item)

    def inside(self, element: Element, item: Item, owner: Element) -> None:
        if item.is_attribute:
            # an element that became an attribute, such as Domain/Id
            for attribute in element.attributes:
                self.remark(Code.UNKNOWN_ATTRIBUTE, attribute.name, attribute.name, item)
            for child in element.children:
                self.remark(Code.UNKNOWN, child.name, child.name, item)
            if element.text:
                self.value(element.name, element.text, item, element, owner)
            return
        self.domain.elements.append((item, element))
        before = len(self.domain.settings)
        self.attributes(element, item, owner, self.domain.remarks)
        self.children(element.children, item.children, item, owner)
        self.text(element, item, owner)
        if repeats(item) or item.name == "Security":
            self.required(element, item, self.domain.settings[before:])

    def attributes(self, element: Element, item: Item, owner: Element, remarks: list[Remark]) -> None:
        for attribute in element.attributes:
            written = [(attribute.name, attribute)]
            found = level(written, item.attributes, item, self.spelling, Code.UNKNOWN_ATTRIBUTE)
            remarks.extend(found.remarks)
            for _, known in found.known:
                self.built(attribute.name, known)
                self.value(attribute.name, attribute.value, known, element, element if repeats(item) else owner)

    def text(self, element: Element, item: Item, owner: Element) -> None:
        text = element.text
        if not text:
            return
        if item.type == "group" or element.children:
            self.remark(Code.TEXT, text, text, item)
        else:
            self.value(element.name, text, item, element, owner)

    def value(self, name: Located, value: Located, item: Item, element: Element, owner: Element) -> None:
        if item.type == "ignored":
            return
        key = (item.path, id(owner))
        self.counts[key] = self.counts.get(key, 0) + 1
        is_id = item.path == f"{DOMAIN}@Id"
        if self.counts[key] > 1 and not is_id:
            self.remark(Code.DUPLICATE, name, item.name, item)
        setting = Setting(item, name, value, self.effective(value, item), element)
        if is_id:
            self.domain.id = value
        self.domain.add(setting)
        fault = None if setting.effective is None else fault_of(item, setting.effective, self.configuration.version)
        if fault is not None:
            self.remark(fault.code, value, fault.detail, item, fault.fatal)

    def effective(self, value: Located, item: Item) -> str | None:
        try:
            return expand(value, self.environment)
        except UnknownVariable:
            return None
        except ExpansionError as error:
            self.remark(Code.EXPANSION, value, str(error), item)
            return None

    def required(self, element: Element, item: Item, settings: list[Setting]) -> None:
        """What has no default must be there: attributes and children, also below groups that are left out."""
        held = {setting.path for setting in settings}
        for needed in _required(item):
            if needed.path not in held:
                self.remark(Code.MISSING, element.name, needed.name, needed)


def _required(item: Item) -> Iterator[Item]:
    siblings = (*item.attributes.values(), *item.children.values())
    yield from (each for each in siblings if each.required and each.type != "group")
    for child in item.children.values():
        if not repeats(child):
            yield from _required(child)
