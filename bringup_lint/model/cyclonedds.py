"""A Cyclone DDS configuration as the library reads it."""

from __future__ import annotations

from collections.abc import Sequence

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.model.schema import Item
from bringup_lint.model.schema import Remark
from bringup_lint.model.xml import Document
from bringup_lint.model.xml import Element
from bringup_lint.source import Located
from bringup_lint.source import Source

VERSIONS = ("0.7", "0.8", "0.9", "0.10", "11")
"""The series that the tables know, oldest first."""


@dataclass(frozen=True, eq=False, slots=True)
class Setting:
    """One value in the file, at the place where the library applies it."""

    item: Item
    name: Located
    value: Located
    """As written; the text of an element without surrounding blanks."""
    effective: str | None
    """With variables expanded; None when it depends on an environment that is not known."""
    owner: Element
    """The element that holds it: for an attribute its element, for text the element itself."""

    @property
    def path(self) -> str:
        return self.item.path


@dataclass(eq=False, slots=True)
class Domain:
    """One ``Domain`` block."""

    element: Element | None
    """None when the groups are directly below the root."""
    id: Located | None = None
    settings: list[Setting] = field(default_factory=list)
    elements: list[tuple[Item, Element]] = field(default_factory=list)
    """Every recognised element, in document order."""
    remarks: list[Remark] = field(default_factory=list)
    _by_path: dict[str, list[Setting]] = field(default_factory=dict)
    _by_owner: dict[int, list[Setting]] = field(default_factory=dict)

    def add(self, setting: Setting) -> None:
        self.settings.append(setting)
        self._by_path.setdefault(setting.path, []).append(setting)
        self._by_owner.setdefault(id(setting.owner), []).append(setting)

    def get(self, path: str) -> Setting | None:
        """The last setting below ``CycloneDDS/Domain/``."""
        found = self.all(path)
        return found[-1] if found else None

    def all(self, path: str) -> Sequence[Setting]:
        return self._by_path.get(f"CycloneDDS/Domain/{path}", ())

    def first(self, path: str) -> Setting | None:
        """Where a setting is given first, by its whole path."""
        found = self._by_path.get(path)
        return found[0] if found else None

    def found(self, path: str) -> list[Element]:
        """The elements at a path below ``CycloneDDS/Domain/``."""
        wanted = f"CycloneDDS/Domain/{path}"
        return [element for item, element in self.elements if item.path == wanted]

    def of(self, element: Element, attribute: str) -> Setting | None:
        """The value of an attribute, by its full name, of one element."""
        own = self._by_owner.get(id(element), ())
        return next((each for each in own if each.item.name == attribute), None)

    @property
    def applies_to_any(self) -> bool:
        return self.id is None or self.id.lower() == "any"


@dataclass(eq=False, slots=True)
class Configuration:
    """One file, or one inline document, as one version of the library reads it."""

    source: Source
    document: Document
    version: str
    inline: bool
    domains: list[Domain] = field(default_factory=list)
    remarks: list[Remark] = field(default_factory=list)
    """What concerns the document as a whole: XML, root."""
    _domains_of: dict[int, Domain] = field(default_factory=dict)

    def domain_of(self, remark: Remark) -> Domain | None:
        """The block that a remark is about; asked when all of them are made."""
        if not self._domains_of:
            self._domains_of = {id(each): domain for domain in self.domains for each in domain.remarks}
        return self._domains_of.get(id(remark))

    @property
    def all_remarks(self) -> list[Remark]:
        return [*self.remarks, *(remark for domain in self.domains for remark in domain.remarks)]
