"""Fast DDS profiles: read as a version of the library reads them, with every remark that it would make.

On the first error the library ignores the whole file and runs with its defaults, exit status 0. This reader goes on, so
that all errors are found at once. Types are not read: they describe data, not the start of a robot.
"""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.model.fastdds import Profile
from bringup_lint.model.fastdds import Profiles
from bringup_lint.model.schema import Code
from bringup_lint.model.schema import Item
from bringup_lint.model.schema import Remark
from bringup_lint.model.xml import Document
from bringup_lint.model.xml import Element
from bringup_lint.parsers.fastdds_schema import needs_content
from bringup_lint.parsers.fastdds_schema import passes_over
from bringup_lint.parsers.fastdds_schema import read_by
from bringup_lint.parsers.fastdds_schema import schema
from bringup_lint.parsers.fastdds_values import fault_of
from bringup_lint.parsers.fastdds_values import first_text
from bringup_lint.parsers.fastdds_values import hidden_by_comment
from bringup_lint.parsers.xml import parse as parse_xml
from bringup_lint.pattern import regex
from bringup_lint.schema.walk import level
from bringup_lint.schema.walk import missing
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source
from bringup_lint.source import Span

DEFAULT_VERSION = "2.14"
"""What Jazzy ships."""
OTHER_VERSIONS = ("3.6", "2.6")
"""Versions that take what the usual one refuses."""
ROOTS = ("dds", "profiles", "types", "log", "library_settings")
PROFILE_KINDS = {
    "participant": "participant",
    "data_writer": "data_writer",
    "publisher": "data_writer",
    "data_reader": "data_reader",
    "subscriber": "data_reader",
    "topic": "topic",
    "requester": "requester",
    "replier": "replier",
    "domainparticipant_factory": "domainparticipant_factory",
}
UNSUPPORTED = ("qos_profile", "application", "type")
"""Tags that the library names as not supported below ``profiles``, and passes over."""
TOLERATED = frozenset(
    {
        "bad-declaration",
        "bad-comment",
        "control-character",
        "doctype",
        "encoding",
        "entity",
        "bad-reference",
        "cdata-end",
        "less-than-in-value",
        "missing-blank",
        "second-root",
        "undeclared-prefix",
    }
)
"""XML problems that TinyXML-2 does not mind."""
STRICT_ATTRIBUTES = ("builtinTransports", "{ThreadSettings}")
_DURATION_WORDS = ("DURATION_INFINITY", "DURATION_INFINITE_SEC", "DURATION_INFINITE_NSEC")
_DIGITS = regex(r"\s*([0-9]+)")
"""As much of a number as the library reads."""
_SIZE = regex(r"[0-9]+ *(?:[a-zA-Z]+)?")


def parse(source: Source, version: str = DEFAULT_VERSION) -> Profiles:
    """Read a profiles file as one version of the library does."""
    document = parse_xml(source)
    last = document.others[-1] if document.others else document.root
    document.root = _root(document)
    profiles = Profiles(source, document, version)
    for problem in document.problems:
        if problem.code == "stray-end-tag" and _is_after_root(document, problem):
            break
        drops = problem.code not in TOLERATED
        if problem.code == "late-declaration":
            drops = bool(source.text[: problem.span.start].strip(" \t\r\n\ufeff"))
        if problem.code == "text-outside-root":
            drops = last is None or problem.span.start > last.span.start
        if drops or problem.code == "doctype":
            profiles.remarks.append(Remark(Code.XML, problem.where, problem.detail, drops, xml=problem.code))
    for span in document.instructions:
        profiles.remarks.append(Remark(Code.INSTRUCTION, span))
    if document.root is not None:
        _Reader(profiles).document(document.root)
    return profiles


def fitting(source: Source) -> Profiles:
    """Read a profiles file as a version of the library does that takes it, where the robot's is not known."""
    usual = parse(source)
    if not usual.dropped:
        return usual
    others = (parse(source, version) for version in OTHER_VERSIONS)
    return next((other for other in others if not other.dropped), usual)


def _root(document: Document) -> Element | None:
    """The first element at the top that the library knows: it asks for ``dds``, then for each of the others, by name
    and passes over the rest, such as a licence in an element of its own."""
    if document.root is None:
        return None
    tops = [document.root, *document.others]
    return next((top for name in ROOTS for top in tops if top.name == name), document.root)


def _is_after_root(document: Document, problem: Problem) -> bool:
    """Whether a problem is after the root. TinyXML-2 ends at an end tag there, and reads nothing of the rest."""
    return document.root is not None and problem.span.start >= document.root.span.end


DDS = Item("dds", "group")


class _Reader:
    def __init__(self, profiles: Profiles) -> None:
        self.profiles = profiles
        self.schema = schema(profiles.version)
        self.items = self.schema.items
        self.known_transports: set[str] = set()
        self.known_profiles: set[tuple[str, str | None]] = set()

    def remark(
        self, code: Code, where: Located | Span, detail: str, item: Item | None = None, fatal: bool = True
    ) -> None:
        self.profiles.remarks.append(Remark(code, where, detail, fatal, item))

    def document(self, root: Element) -> None:
        if root.name not in ROOTS:
            self.remark(Code.ROOT, root.name, root.name)
        elif root.name == "profiles":
            self.below_profiles(root, rooted=True)
        elif root.name != "dds":
            self.top(root)
        else:
            for child in root.children:
                self.below_dds(child)

    def below_dds(self, element: Element) -> None:
        if element.name == "profiles":
            self.below_profiles(element)
        elif element.name in PROFILE_KINDS:
            self.profile(element)
        elif element.name in ROOTS:
            self.top(element)
        else:
            self.remark(Code.UNKNOWN, element.name, element.name, DDS)

    def top(self, element: Element) -> None:
        """``types``, ``log`` or ``library_settings``."""
        item = self.items.get(str(element.name))
        if element.name != "types" and item is not None:
            self.inside(element, item)

    def below_profiles(self, element: Element, rooted: bool = False) -> None:
        before = len(self.profiles.profiles) + len(self.profiles.transports)
        top = self.items["profiles"]
        for child in element.children:
            if child.name in PROFILE_KINDS:
                self.profile(child)
            elif child.name == "transport_descriptors":
                self.transports(child)
            elif child.name == "library_settings":
                self.top(child)
            elif child.name in UNSUPPORTED:
                self.remark(Code.IGNORED, child.name, child.name, top, False)
            elif child.name != "types":
                self.remark(Code.UNKNOWN, child.name, child.name, top)
        empty = before == len(self.profiles.profiles) + len(self.profiles.transports)
        if rooted and empty and element.find("types") is None:
            self.remark(Code.EMPTY, element.name, "no profile", top)

    def profile(self, element: Element) -> None:
        kind = PROFILE_KINDS[element.name]
        item = self.items.get(f"profiles/{kind}")
        if item is None:
            self.remark(Code.UNKNOWN, element.name, element.name, self.items["profiles"])
            return
        name = element.get("profile_name")
        if name and (kind, name) in self.known_profiles:
            self.remark(Code.PROFILE_DUPLICATE, name, name, item, False)
        self.known_profiles.add((kind, name))
        self.profiles.profiles.append(Profile(kind, element, name, element.get("is_default_profile")))
        self.inside(element, item)

    def transports(self, element: Element) -> None:
        item = self.items["profiles/transport_descriptors"]
        for child in element.find_all("transport_descriptor"):
            self.profiles.transports.append(child)
            self.inside(child, item.children["transport_descriptor"])
            name = child.find("transport_id")
            text = first_text(name) if name is not None else None
            if text is not None:
                if text in self.known_transports:
                    self.remark(Code.TRANSPORT_DUPLICATE, text, text, item, False)
                self.known_transports.add(str(text))

    def inside(self, element: Element, item: Item) -> None:
        """One known element: attributes, children, text."""
        if item.ignored:
            self.remark(Code.IGNORED, element.name, item.name, item, False)
            return
        shape = self.schema.inside(item)
        self.attributes(element, item, shape)
        if item.type == "group" or item.is_structure:
            self.children(element, item, shape)
        else:
            self.text(element, item)

    def children(self, element: Element, item: Item, shape: Item) -> None:
        if item.type == "{Duration}" and not element.children:
            self.duration(element, item)
            return
        found = level(((child.name, child) for child in element.children), shape.children, item)
        unknown = [remark for remark in found.remarks if remark.code is Code.UNKNOWN]
        if passes_over(item):
            # the first child of a list is read, whatever it is
            first = element.children[0].name if element.children and item.name.endswith("List") else None
            unknown = [remark for remark in unknown if remark.where is first]
        self.profiles.remarks.extend(unknown)
        seen: set[tuple[str, Located | None]] = set()
        for child, known in found.known:
            twin = (str(child.name), child.get("port") if known.name == "reception_thread" else None)
            if twin in seen and known.once:
                self.remark(Code.DUPLICATE, child.name, child.name, known)
            seen.add(twin)
            if read_by(known) and not self.reads(element, known):
                self.remark(Code.PASSED_OVER, child.name, known.name, known, False)
            else:
                self.inside(child, known)
        if not element.children and needs_content(item):
            self.remark(Code.EMPTY, element.name, item.name, item)
            return
        if item.type == "{AllocationConfig}":
            self.allocation(element, item, shape)
        for needed in missing(shape.children, found.known):
            self.remark(Code.MISSING, element.name, needed.name, needed)

    @staticmethod
    def reads(transport: Element, item: Item) -> bool:
        """Whether a transport of this type reads one of its elements."""
        kind = transport.find("type")
        return kind is None or not kind.text or str(kind.text).lower().startswith(read_by(item))

    def allocation(self, element: Element, item: Item, shape: Item) -> None:
        """Initial and largest number; a step of zero is fine when nothing can grow. The largest is 0 for no limit."""
        numbers: dict[str, int] = {}
        for child in element.children:
            digits = _DIGITS.match(first_text(child) or "")
            if digits is None:
                return
            numbers[str(child.name)] = int(digits[1])
        texts = {str(child.name): child.text for child in reversed(element.children)}
        initial = numbers.get("initial", 0)
        maximum = numbers.get("maximum", 0) or None
        if maximum is not None and initial > maximum:
            self.remark(Code.NUMBER, texts["initial"], "more than maximum", item)
        elif numbers.get("increment", 1) == 0 and initial != maximum:
            self.remark(Code.NUMBER, texts["increment"], "zero", shape.children["increment"])

    def attributes(self, element: Element, item: Item, shape: Item) -> None:
        known = {**item.attributes, **shape.attributes}
        for attribute in element.attributes:
            if attribute.name not in known and (item.name in STRICT_ATTRIBUTES or shape.path in STRICT_ATTRIBUTES):
                self.remark(Code.UNKNOWN_ATTRIBUTE, attribute.name, attribute.name, item)
            own = known.get(str(attribute.name))
            if own is not None and own.type == "enum" and attribute.value not in own.words:
                self.remark(Code.ENUM, attribute.value, "", own)
        for needed in item.attributes.values():
            if not needed.required or element.get(needed.name):
                continue
            if needed.name == "profile_name":
                self.remark(Code.PROFILE_NAME, element.name, item.name, item, False)
            else:
                self.remark(Code.MISSING, element.name, needed.name, needed)
        prefix = element.get("prefix")
        if prefix is not None and item.name == "RemoteServer":
            self.value(prefix, self.items["profiles/participant/rtps/prefix"])
        if item.name == "reception_thread" and element.get("port") is None:
            self.remark(Code.MISSING, element.name, "port", item)
        if item.name == "builtinTransports":
            self.builtin_transports(element, item)

    def builtin_transports(self, element: Element, item: Item) -> None:
        switch = element.get("non_blocking")
        if switch is not None and switch not in ("true", "false"):
            self.remark(Code.BOOL, switch, "", item)

    def duration(self, element: Element, item: Item) -> None:
        text = first_text(element)
        if text is not None and (text.strip() in _DURATION_WORDS or "${" in text):
            return
        if hidden_by_comment(element):
            self.remark(Code.COMMENT, element.text, item.name, item)
        elif text is not None:
            self.remark(Code.DURATION, text.strip_located(), item.name, item)
        else:
            self.remark(Code.EMPTY, element.name, item.name, item)

    def text(self, element: Element, item: Item) -> None:
        if item.type == "any":
            return
        text = first_text(element)
        if text is None:
            if hidden_by_comment(element):
                self.remark(Code.COMMENT, element.text, item.name, item)
            elif needs_content(item):
                self.remark(Code.EMPTY, element.name, item.name, item)
            return
        self.value(text, item)
        undefined = item.path.endswith("userTransports/transport_id") and text not in self.known_transports
        if undefined and "${" not in text:
            self.remark(Code.TRANSPORT_UNDEFINED, text, text, item)

    def value(self, text: Located, item: Item) -> None:
        fault = fault_of(item, text)
        if fault is not None:
            self.remark(fault.code, text.strip_located() or text, fault.detail, item, fault.fatal)


def locators(element: Element) -> Iterator[Element]:
    """The transport elements (``udpv4``, ...) of every locator in a list."""
    for locator in element.find_all("locator"):
        yield from locator.children
