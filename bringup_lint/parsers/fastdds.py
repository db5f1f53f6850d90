"""Fast DDS profiles: read as a version of the library reads them, with every remark that it would make.

On the first error the library ignores the whole file and runs with its defaults, exit status 0. This reader
goes on, so that
all errors are found at once. Types are not read: they describe data, not the start of a robot.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from bringup_lint.model.fastdds import Profile
from bringup_lint.model.fastdds import Profiles
from bringup_lint.model.fastdds import Remark
from bringup_lint.model.xml import Document
from bringup_lint.model.xml import Element
from bringup_lint.parsers.fastdds_schema import Item
from bringup_lint.parsers.fastdds_schema import schema
from bringup_lint.parsers.fastdds_values import complaint
from bringup_lint.parsers.fastdds_values import first_text
from bringup_lint.parsers.fastdds_values import hidden_by_comment
from bringup_lint.parsers.xml import parse as parse_xml
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source
from bringup_lint.source import Span

DEFAULT_VERSION = "2.14"
"""What Jazzy ships."""
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
_DIGITS = re.compile(r"\s*([0-9]+)")
"""As much of a number as the library reads."""
_SIZE = re.compile(r"[0-9]+ *(?:[a-zA-Z]+)?")


def parse(source: Source, version: str = DEFAULT_VERSION) -> Profiles:
    """Read a profiles file as one version of the library does."""
    document = parse_xml(source)
    profiles = Profiles(source, document, version)
    for problem in document.problems:
        if problem.code == "stray-end-tag" and _is_behind(document, problem):
            break
        drops = problem.code not in TOLERATED
        if problem.code == "late-declaration":
            span = getattr(problem.where, "span", problem.where)
            drops = bool(source.text[: span.start].strip(" \t\r\n\ufeff"))
        if problem.code == "text-outside-root":
            span = getattr(problem.where, "span", problem.where)
            drops = document.root is None or span.start > document.root.span.start
        if drops or problem.code == "doctype":
            profiles.remarks.append(Remark("xml", problem.where, drops, f"{problem.code}: {problem.detail}"))
    for span in document.instructions:
        profiles.remarks.append(Remark("instruction", span, True))
    if document.root is not None:
        _Reader(profiles).document(document.root)
    return profiles


def _is_behind(document: Document, problem: Problem) -> bool:
    """Whether a problem stands behind the root. TinyXML-2 ends at an end tag there, and reads nothing of the rest."""
    span = getattr(problem.where, "span", problem.where)
    return document.root is not None and span.start >= document.root.span.end


class _Reader:
    def __init__(self, profiles: Profiles) -> None:
        self.profiles = profiles
        self.items = schema(profiles.version)
        self.known_transports: set[str] = set()

    def remark(self, code: str, where: Located | Span, drops: bool, detail: str = "", path: str = "") -> None:
        self.profiles.remarks.append(Remark(code, where, drops, detail, path))

    def document(self, root: Element) -> None:
        if root.name not in ROOTS:
            self.remark("root", root.name, True, root.name)
            return
        if root.name == "profiles":
            self.below_profiles(root, rooted=True)
            return
        if root.name != "dds":
            self.top(root)
            return
        for child in root.children:
            if child.name == "profiles":
                self.below_profiles(child)
            elif child.name in PROFILE_KINDS:
                self.profile(child)
            elif child.name in ROOTS:
                self.top(child)
            else:
                self.remark("unknown-element", child.name, True, child.name, "dds")

    def top(self, element: Element) -> None:
        """``types``, ``log`` or ``library_settings``."""
        item = self.items.get(str(element.name))
        if element.name != "types" and item is not None:
            self.inside(element, item)

    def below_profiles(self, element: Element, rooted: bool = False) -> None:
        before = len(self.profiles.profiles) + len(self.profiles.transports)
        for child in element.children:
            if child.name in PROFILE_KINDS:
                self.profile(child)
            elif child.name == "transport_descriptors":
                self.transports(child)
            elif child.name == "library_settings":
                self.top(child)
            elif child.name not in ("types", *UNSUPPORTED):
                self.remark("unknown-element", child.name, True, child.name, "profiles")
            elif child.name in UNSUPPORTED:
                self.remark("ignored", child.name, False, child.name, "profiles")
        empty = before == len(self.profiles.profiles) + len(self.profiles.transports)
        if rooted and empty and element.find("types") is None:
            self.remark("empty", element.name, True, "no profile", "profiles")

    def profile(self, element: Element) -> None:
        kind = PROFILE_KINDS[element.name]
        item = self.items.get(f"profiles/{kind}")
        if item is None:
            self.remark("unknown-element", element.name, True, element.name, "profiles")
            return
        name = element.get("profile_name")
        profile = Profile(kind, element, name, element.get("is_default_profile"))
        twin = next((each for each in self.profiles.of_kind(kind) if name and each.name == name), None)
        if twin is not None:
            self.remark("profile-duplicate", name, False, name, item.path)
        self.profiles.profiles.append(profile)
        self.inside(element, item)

    def transports(self, element: Element) -> None:
        item = self.items["profiles/transport_descriptors"]
        for child in element.children:
            if child.name != "transport_descriptor":
                continue
            self.profiles.transports.append(child)
            self.inside(child, item.children["transport_descriptor"])
            name = child.find("transport_id")
            text = first_text(name) if name is not None else None
            if text is not None:
                if text in self.known_transports:
                    self.remark("transport-duplicate", text, False, text, item.path)
                self.known_transports.add(str(text))

    def inside(self, element: Element, item: Item) -> None:
        """One known element: attributes, children, text."""
        if item.ignored:
            self.remark("ignored", element.name, False, item.name, item.path)
            return
        shape = self.items[item.check] if item.check.startswith("{") else item
        self.attributes(element, item, shape)
        if item.check == "group" or item.check.startswith("{"):
            self.children(element, item, shape)
        else:
            self.text(element, item)

    def children(self, element: Element, item: Item, shape: Item) -> None:
        if item.check == "{Duration}" and not element.children:
            self.duration(element, item)
            return
        seen: set[str] = set()
        for child in element.children:
            known = shape.children.get(str(child.name))
            if known is None:
                passed = item.passes_over and not (item.name.endswith("List") and child is element.children[0])
                if not passed:
                    self.remark("unknown-element", child.name, True, child.name, item.path)
                continue
            twin = f"{child.name} {child.get('port') if known.name == 'reception_thread' else ''}"
            if twin in seen and known.once:
                self.remark("duplicate", child.name, True, child.name, known.path)
            seen |= {twin, str(child.name)}
            if known.only and not self.reads(element, known):
                self.remark("passed-over", child.name, False, known.name, known.path)
            else:
                self.inside(child, known)
        if not element.children and item.not_empty:
            self.remark("empty", element.name, True, item.name, item.path)
            return
        if item.check == "{AllocationConfig}":
            self.allocation(element, item)
        for known in set(shape.children.values()):
            if known.required and not seen & {known.name, *known.aliases}:
                self.remark("missing", element.name, True, known.name, known.path)

    @staticmethod
    def reads(transport: Element, item: Item) -> bool:
        """Whether a transport of this type reads one of its elements."""
        kind = transport.find("type")
        return kind is None or not kind.text or str(kind.text).lower().startswith(item.only)

    def allocation(self, element: Element, item: Item) -> None:
        """Initial and largest number; a step of zero is fine when nothing can grow. The largest is 0 for no
        limit."""
        texts = {str(child.name): _DIGITS.match(first_text(child) or "") for child in element.children}
        if None in texts.values():
            return
        numbers = {name: int(found[1]) for name, found in texts.items()}
        initial = numbers.get("initial", 0)
        maximum = numbers.get("maximum", 0) or None
        if maximum is not None and initial > maximum:
            self.remark("number", element.find("initial").text, True, "more than maximum", item.path)
        elif numbers.get("increment", 1) == 0 and initial != maximum:
            self.remark("number", element.find("increment").text, True, "zero", f"{item.path}/increment")

    def attributes(self, element: Element, item: Item, shape: Item) -> None:
        known = {**item.attributes, **shape.attributes}
        for attribute in element.attributes:
            if attribute.name not in known and (item.name in STRICT_ATTRIBUTES or shape.path in STRICT_ATTRIBUTES):
                self.remark("unknown-attribute", attribute.name, True, attribute.name, item.path)
            own = known.get(str(attribute.name))
            if own is not None and own.check == "enum" and attribute.value not in own.allowed:
                self.remark("enum", attribute.value, True, "", own.path)
        for needed in item.attributes.values():
            value = element.get(needed.name)
            if not needed.required or value:
                continue
            if needed.name == "profile_name":
                self.remark("profile-name", element.name, False, item.name, item.path)
            else:
                self.remark("missing", element.name, True, needed.name, needed.path)
        prefix = element.get("prefix")
        if prefix is not None and item.name == "RemoteServer":
            self.value(prefix, self.items["profiles/participant/rtps/prefix"])
        if item.name == "reception_thread" and element.get("port") is None:
            self.remark("missing", element.name, True, "port", item.path)
        if item.name == "builtinTransports":
            self.builtin_transports(element, item)

    def builtin_transports(self, element: Element, item: Item) -> None:
        switch = element.get("non_blocking")
        if switch is not None and switch not in ("true", "false"):
            self.remark("bool", switch, True, "", item.path)

    def duration(self, element: Element, item: Item) -> None:
        text = first_text(element)
        if text is not None and (text.strip() in _DURATION_WORDS or "${" in text):
            return
        if hidden_by_comment(element):
            self.remark("comment", element.text, True, item.name, item.path)
        else:
            where = text.strip_located() if text is not None else element.name
            self.remark("duration" if text is not None else "empty", where, True, item.name, item.path)

    def text(self, element: Element, item: Item) -> None:
        if item.check == "any":
            return
        text = first_text(element)
        if text is None:
            if hidden_by_comment(element):
                self.remark("comment", element.text, True, item.name, item.path)
            elif item.not_empty:
                self.remark("empty", element.name, True, item.name, item.path)
            return
        self.value(text, item)
        undefined = item.path.endswith("userTransports/transport_id") and text not in self.known_transports
        if undefined and "${" not in text:
            self.remark("transport-undefined", text, True, text, item.path)

    def value(self, text: Located, item: Item) -> None:
        found = complaint(item, text)
        if found:
            self.remark(found.code, text.strip_located() or text, found.drops, found.detail, item.path)


def locators(element: Element) -> Iterator[Element]:
    """The transport elements (``udpv4``, ...) of every locator in a list."""
    for locator in element.find_all("locator"):
        yield from locator.children
