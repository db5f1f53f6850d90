"""What a table knows of a format, and what a reader says about a file that does not follow it."""

from __future__ import annotations

from collections.abc import Mapping
from enum import Enum

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.model.xml import Element
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Problem


class Code(str, Enum):
    """What is wrong. Readers of tables use these codes only; rules choose their findings by them."""

    # of names
    UNKNOWN = "unknown"
    UNKNOWN_ATTRIBUTE = "unknown-attribute"
    AMBIGUOUS = "ambiguous-name"
    ABBREVIATED = "abbreviated"
    ALIAS = "alias"
    DEPRECATED = "deprecated"
    MOVED = "moved"
    IGNORED = "ignored"
    PASSED_OVER = "passed-over"
    BUILD = "build"
    TOO_NEW = "too-new"
    NAMESPACE = "namespace"
    # of structure
    XML = "xml"
    INSTRUCTION = "instruction"
    ROOT = "root"
    SHAPE = "wrong-shape"
    UNQUOTED = "unquoted"
    DUPLICATE = "duplicate"
    MISSING = "missing"
    MISSING_ATTRIBUTE = "missing-attribute"
    ORDER = "order"
    EMPTY = "empty"
    TEXT = "unexpected-text"
    COMMENT = "comment"
    # of one value
    VALUE = "value"
    BOOL = "bool"
    ENUM = "enum"
    NUMBER = "number"
    RANGE = "range"
    UNIT = "unit"
    BARE_NUMBER = "bare-number"
    DURATION = "duration"
    DATE = "date"
    NAME = "name"
    ADDRESS = "address"
    PREFIX_LENGTH = "prefix-length"
    RENDERER = "renderer"
    VERSION = "version"
    EXPANSION = "expansion"
    # of values together, Cyclone DDS
    MIXED_INTERFACES = "mixed-interfaces"
    ANONYMOUS = "anonymous"
    AUTODETERMINED = "autodetermined"
    INTERFACE_TWICE = "interface-twice"
    WATERMARKS = "watermarks"
    TRANSPORT = "transport"
    PORTS = "ports"
    PRIORITY = "priority"
    # of profiles and transports, Fast DDS
    PROFILE_NAME = "profile-name"
    PROFILE_DUPLICATE = "profile-duplicate"
    TRANSPORT_DUPLICATE = "transport-duplicate"
    TRANSPORT_UNDEFINED = "transport-undefined"

    def __str__(self) -> str:
        return self.value


@dataclass(frozen=True, eq=False, slots=True)
class Item:
    """One name of a format: an element, an attribute, a section, a key or a keyword."""

    path: str
    """``General/Interfaces``; an attribute after ``@``. A structure that several places share has a name in braces."""
    type: str
    """The grammar of its value, ``group`` for what holds other names, or the name of a structure in braces."""
    allowed: str = ""
    """The words or ranges that the grammar takes, as the format's table writes them."""
    aliases: tuple[str, ...] = ()
    required: bool = False
    once: bool = False
    """Whether a second one is an error."""
    order: int = 0
    """Its place among its siblings; 0 where any place will do."""
    since: str = ""
    """The first release that knows it; empty when every release of the table does."""
    status: str = "yes"
    """``yes``, ``deprecated``, ``ignored`` or ``moved:PATH``, in the version that is read."""
    row: Mapping[str, str] = field(default_factory=dict)
    """The row of the table, for columns that only this format has."""
    children: dict[str, Item] = field(default_factory=dict)
    attributes: dict[str, Item] = field(default_factory=dict)

    @property
    def name(self) -> str:
        return self.path.replace("@", "/").rpartition("/")[2]

    @property
    def is_attribute(self) -> bool:
        return "@" in self.path

    @property
    def is_structure(self) -> bool:
        """Whether its content is described at another place of the table."""
        return self.type.startswith("{")

    @property
    def deprecated(self) -> bool:
        return self.status == "deprecated"

    @property
    def ignored(self) -> bool:
        return self.status == "ignored"

    @property
    def moved_to(self) -> str:
        """The path where the program applies it, else empty."""
        return self.status.removeprefix("moved:") if self.status.startswith("moved:") else ""

    @property
    def words(self) -> tuple[str, ...]:
        """The words between bars."""
        return tuple(self.allowed.split("|")) if self.allowed else ()


class Fault(NamedTuple):
    """Why the grammar of an item refuses a text, or what is odd about it."""

    code: Code
    detail: str = ""
    """The part that is to blame, what is expected, or how the text is read."""
    fatal: bool = True


@dataclass(frozen=True, slots=True)
class Remark(Problem):
    """Something that the program that reads a file says about it, or should say."""

    fatal: bool = True
    """Whether it costs the whole file: no participant is created, the document is rejected, the line is not used."""
    item: Item | None = None
    """What was meant; for an unknown name, the item inside which it appears."""
    element: Element | None = None
    """In XML, the element that the remark is about, or inside which something is missing."""
    before: Element | None = None
    """For something missing from XML: the child in front of which it belongs, if there is one."""
    xml: str = ""
    """For ``Code.XML``: the code of the XML reader, such as ``bad-tag``."""

    @property
    def path(self) -> str:
        """The table's path of the item; empty without one."""
        return self.item.path if self.item else ""

    @property
    def known(self) -> Item:
        """The item of a remark that has one."""
        assert self.item is not None, f"{self.code} names no item"
        return self.item

    @property
    def inside(self) -> Element:
        """The element of a remark that has one."""
        assert self.element is not None, f"{self.code} names no element"
        return self.element

    @property
    def xml_problem(self) -> str:
        """What the XML reader says: ``duplicate attribute, name``."""
        words = self.xml.replace("-", " ")
        return f"{words}, {self.detail}" if self.detail else words
