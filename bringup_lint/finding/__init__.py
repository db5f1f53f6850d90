"""What a rule hands over: findings with their locations, chains and fixes."""

from __future__ import annotations

from collections.abc import Callable
from enum import Enum
from enum import IntEnum

from bringup_lint.dataclass import dataclass
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span
from bringup_lint.type_names import Any


class Severity(IntEnum):
    """What happens on the robot."""

    INFO = 1
    """Hygiene; not shown unless asked for."""
    WARNING = 2
    """Works today and will hurt."""
    ERROR = 3
    """Will not start, will silently not apply, or is unsafe."""

    def __str__(self) -> str:
        return self.name.lower()


class Confidence(IntEnum):
    MEDIUM = 1
    HIGH = 2

    def __str__(self) -> str:
        return self.name.lower()


class Applicability(str, Enum):
    """Whether a fix may be applied unseen."""

    SAFE = "safe"
    UNSAFE = "unsafe"

    def __str__(self) -> str:
        return self.value


class Edit(NamedTuple):
    """Replace the text of ``span`` by ``text``; an empty span inserts."""

    span: Span
    text: str


@dataclass(frozen=True, eq=False)
class Codemod:
    """A change of a whole Python file that edits of places cannot express."""

    source: Source
    change: Callable[[str], str]
    """Old text -> new text; the same text where there is nothing to do. Only the step that applies fixes calls it."""


@dataclass(frozen=True)
class Fix:
    """A change that removes the finding: edits, or a codemod."""

    title: str
    edits: tuple[Edit, ...] = ()
    applicability: Applicability = Applicability.SAFE
    codemod: Codemod | None = None


class Related(NamedTuple):
    """Another place that has a part in the finding, with a word on which part."""

    span: Span
    message: str


class Suppression(NamedTuple):
    """The comment or the entry of the configuration that silences a finding."""

    span: Span
    reason: str
    external: bool = False
    """Whether the configuration says it and not the file."""


@dataclass(frozen=True)
class Finding:
    """One defect. Rules make it with ``api.finding``; the engine fills in ``rule``, ``severity`` and ``confidence``."""

    message: str
    span: Span
    rule: str = ""
    severity: Severity = Severity.WARNING
    confidence: Confidence = Confidence.HIGH
    advice: str = ""
    related: tuple[Related, ...] = ()
    chain: tuple[Related, ...] = ()
    """The steps, in order, that lead to the defect; a cycle ends where it starts."""
    fix: Fix | None = None
    hidden: tuple[Span, ...] = ()
    """Further places where a suppression comment counts, such as the drop-in that changed the line."""
    suppression: Suppression | None = None
    secrets: tuple[Span, ...] = ()
    """Stretches that no output may show: passwords, keys, tokens."""
    fingerprint: str = ""
    """What makes it the same finding after lines have moved; empty until its secrets are masked."""
    copies: tuple[Finding, ...] = ()
    """The same findings on copies of the line, each with its own fix; their places are in ``related`` too."""
    own_severity: Severity | None = None
    """What the rule says of this one finding; None where it is as severe as the rule."""
    own_confidence: Confidence | None = None
    """The same for the confidence, which can only be lower than the rule's."""

    @property
    def source(self) -> Source:
        return self.span.source


def changed(finding: Finding, **fields: Any) -> Finding:
    """As ``dataclasses.replace``, which asks for each of the fields; every finding of a run is changed several
    times."""
    new = object.__new__(Finding)
    vars(new).update(vars(finding), **fields)
    return new


def span_of(where: Located | Span | Source) -> Span:
    """The span of whatever knows its place."""
    if isinstance(where, Source):
        return where.whole
    return where.span if isinstance(where, Located) else where
