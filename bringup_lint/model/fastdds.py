"""A Fast DDS profiles file as the library reads it."""

from __future__ import annotations

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.model.schema import Remark
from bringup_lint.model.xml import Document
from bringup_lint.model.xml import Element
from bringup_lint.source import Located
from bringup_lint.source import Source

VERSIONS = ("2.6", "2.14", "3.2", "3.6")
"""The series that the tables know, oldest first."""


@dataclass(eq=False, slots=True)
class Profile:
    kind: str
    """participant, data_writer, data_reader, topic, requester, replier or domainparticipant_factory."""
    element: Element
    name: Located | None
    default: Located | None
    """The value of ``is_default_profile``; only exactly ``true`` selects the profile."""

    @property
    def is_default(self) -> bool:
        return self.default == "true"


@dataclass(eq=False, slots=True)
class Profiles:
    """One file, as one version of the library reads it."""

    source: Source
    document: Document
    version: str
    remarks: list[Remark] = field(default_factory=list)
    profiles: list[Profile] = field(default_factory=list)
    transports: list[Element] = field(default_factory=list)
    """The ``transport_descriptor`` elements, in order."""

    @property
    def dropped(self) -> bool:
        """Whether the library ignores the whole file."""
        return any(remark.fatal for remark in self.remarks)

    @property
    def default_participants(self) -> list[Element]:
        """The default profiles of participants; none when the library ignores the file."""
        return [] if self.dropped else [each.element for each in self.of_kind("participant") if each.is_default]

    def of_kind(self, kind: str) -> list[Profile]:
        return [profile for profile in self.profiles if profile.kind == kind]
