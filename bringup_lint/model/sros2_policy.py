"""sros2 policies: what each node of an enclave may do, in names of ROS. Permissions documents are made from them."""

from __future__ import annotations

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.model.schema import Remark
from bringup_lint.model.xml import Document
from bringup_lint.model.xml import Element
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located
from bringup_lint.source import Source


class Right(NamedTuple):
    """One name of a ``topics``, ``services`` or ``actions`` element."""

    kind: str
    """``topic``, ``service`` or ``action``."""
    name: Located
    """As written, blanks included."""
    ways: dict[str, str]
    """``publish``, ``subscribe``, ``reply``, ``request``, ``call``, ``execute`` -> ``ALLOW`` or ``DENY``."""
    element: Element
    """The element with the ways."""

    def allows(self, way: str) -> bool:
        return self.ways.get(way) == "ALLOW"


@dataclass(eq=False, slots=True)
class Profile:
    """The rights of one node."""

    element: Element
    namespace: Located
    node: Located
    rights: list[Right] = field(default_factory=list)
    open: bool = False
    """More rights are included from elsewhere, or a template does not say them yet."""

    @property
    def fqn(self) -> str:
        return f"{self.namespace.rstrip('/')}/{self.node}"


@dataclass(eq=False, slots=True)
class PolicyEnclave:
    element: Element
    path: Located
    profiles: list[Profile] = field(default_factory=list)
    open: bool = False
    """More profiles are included from elsewhere."""


@dataclass(eq=False, slots=True)
class Policy:
    source: Source
    document: Document
    remarks: list[Remark] = field(default_factory=list)
    enclaves: list[PolicyEnclave] = field(default_factory=list)
    open: bool = False
    """More enclaves are included from elsewhere, or something puts more into the text than names."""
