"""The security files of ROS 2: governance and permissions documents, policies."""

from __future__ import annotations

import re
from datetime import datetime
from datetime import timezone
from fnmatch import fnmatchcase

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.model.schema import Remark
from bringup_lint.model.xml import Document
from bringup_lint.model.xml import Element
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span

_DATE_TIME = regex(r"(\d{4})-(\d\d)-(\d\d)T(\d\d):(\d\d):(\d\d)(?:\.\d+)?(?:Z|[+-]\d\d:\d\d)?", re.ASCII)


class Range(NamedTuple):
    """Domains from ``first`` to ``last``, both included; ``last`` None: no end."""

    first: int
    last: int | None
    where: Span


@dataclass(eq=False, slots=True)
class Domains:
    element: Element
    ranges: list[Range] = field(default_factory=list)
    known: bool = True
    """False when an entry could not be read."""

    def covers(self, domain: int) -> bool:
        return not self.known or any(
            each.first <= domain and (each.last is None or domain <= each.last) for each in self.ranges
        )

    def __str__(self) -> str:
        shown = [
            str(each.first)
            if each.first == each.last
            else f"{each.first} to {each.last}"
            if each.last is not None
            else f"{each.first} and above"
            for each in self.ranges
        ]
        return ", ".join(shown)


@dataclass(eq=False, slots=True)
class TopicRule:
    element: Element
    expression: Located | None
    fields: dict[str, Located]
    """The text of the other elements by name."""


@dataclass(eq=False, slots=True)
class DomainRule:
    element: Element
    domains: Domains | None
    fields: dict[str, Located]
    topic_rules: list[TopicRule] = field(default_factory=list)


@dataclass(eq=False, slots=True)
class Governance:
    source: Source
    document: Document
    remarks: list[Remark] = field(default_factory=list)
    rules: list[DomainRule] = field(default_factory=list)


@dataclass(eq=False, slots=True)
class AccessRule:
    """An ``allow_rule`` or ``deny_rule``."""

    element: Element
    allows: bool
    domains: Domains | None
    publish: list[Located] = field(default_factory=list)
    subscribe: list[Located] = field(default_factory=list)


@dataclass(eq=False, slots=True)
class Grant:
    element: Element
    name: Located | None
    subject: Located | None
    not_before: Located | None
    not_after: Located | None
    rules: list[AccessRule] = field(default_factory=list)
    default: Located | None = None

    @property
    def place(self) -> Located:
        """The subject, where the grant has one."""
        return self.subject or self.element.name

    @property
    def enclave(self) -> Located | None:
        """The enclave of the subject, when sros2 made it: ``CN=/path``."""
        if self.subject is None or not self.subject.startswith("CN=/") or "," in self.subject:
            return None
        return self.subject.part(3, len(self.subject))

    @property
    def allowed(self) -> list[AccessRule]:
        return [rule for rule in self.rules if rule.allows]


@dataclass(eq=False, slots=True)
class Permissions:
    source: Source
    document: Document
    remarks: list[Remark] = field(default_factory=list)
    grants: list[Grant] = field(default_factory=list)


def moment(text: str | None) -> datetime | None:
    """A date and time as the documents write it, time zones left out; None when it is not one."""
    match = _DATE_TIME.fullmatch(text.strip()) if text else None
    if match is None:
        return None
    try:
        year, month, day, hour, minute, second = (int(part) for part in match.groups())
        return datetime(year, month, day, hour, minute, second, tzinfo=timezone.utc)
    except ValueError:
        return None


_COMMANDS = ("rt/cmd_vel", "rt/robot/cmd_vel", "rt/emergency_stop")
_COMMAND_WORDS = regex(r"cmd|vel|stop|command|joint|traj|brake|motor")


def moves_robot(expression: str) -> bool:
    """Whether the topics of an expression move the robot, or stop it."""
    return any(fnmatchcase(name, expression) for name in _COMMANDS) or bool(_COMMAND_WORDS.search(expression))
