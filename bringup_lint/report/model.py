"""What every output format is made from."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from collections.abc import Mapping
from enum import Enum

from bringup_lint import __version__
from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.finding import Confidence
from bringup_lint.finding import Finding
from bringup_lint.finding import Severity
from bringup_lint.finding.presented import presented
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.type_names import Any


@dataclass(frozen=True)
class RuleDoc:
    """A rule as documentation and reports know it. ``report.docs`` turns it into Markdown or plain text."""

    id: str
    docstring: str
    severity: Severity = Severity.WARNING
    confidence: Confidence = Confidence.HIGH
    fix: str = "none"
    """``none``, ``safe`` or ``unsafe``."""
    since: str = ""
    symptoms: tuple[str, ...] = ()
    silent: str = ""
    """Why no program reports the defect; empty when one does."""
    tags: tuple[str, ...] = ()
    aliases: tuple[str, ...] = ()
    uri: str = ""
    """Where the rule is documented on the web; empty for a user's own rule."""

    @property
    def title(self) -> str:
        """The first sentence of the documentation, without its full stop."""
        paragraph = self.docstring.strip().partition("\n\n")[0]
        return " ".join(paragraph.split()).rstrip(".")


class Target(NamedTuple):
    """The versions that the rules assumed, and what told them."""

    ros: str | None = None
    systemd: int | None = None
    ros_why: str = ""
    systemd_why: str = ""


class Part(Enum):
    WHOLE = "whole"
    FINDINGS = "findings"
    STATISTICS = "statistics"


NOT_KNOWN = Target()


class Notification(NamedTuple):
    """Something about the run itself, such as a rule that failed inside."""

    level: str
    """``error``, ``warning`` or ``note``."""
    message: str
    rule: str = ""
    path: str = ""


@dataclass(frozen=True)
class Report:
    """One run. No secret survives the making of a report: the findings and their sources come out masked, and each
    finding has its fingerprint."""

    findings: tuple[Finding, ...] = ()
    """In the order of output; suppressed ones are among them."""
    rules: Mapping[str, RuleDoc] = field(default_factory=dict)
    """The rules that ran, by id."""
    kinds: Mapping[str, int] = field(default_factory=dict)
    """How many files of each kind were checked."""
    root: str = ""
    """Absolute folder that ``%SRCROOT%`` stands for."""
    cwd: str = ""
    """Absolute folder that relative source names start from; ``root`` when empty."""
    version: str = __version__
    target: Target = NOT_KNOWN
    command: tuple[str, ...] = ()
    """The command line as given, program first."""
    started: float | None = None
    """Seconds since the epoch."""
    ended: float | None = None
    exit_code: int = 0
    notifications: tuple[Notification, ...] = ()
    below: Mapping[Severity, int] = field(default_factory=dict)
    """How many findings of each severity were left out by ``--min-severity``."""
    elsewhere: int = 0
    """How many findings were left out because the change that is judged has no part in them."""
    narrowed: tuple[str, ...] = ()
    """What a configuration of the tree keeps from being judged, in words."""
    known: tuple[Finding, ...] = ()
    """Findings that were left out because the baseline holds them."""
    stale: tuple[str, ...] = ()
    """The fingerprints in the baseline whose findings are gone."""
    picture: dict[str, Any] | None = None
    """The robot as ``report.picture`` draws it, with these findings; only the formats in ``report.DRAWN`` show it."""
    at_boot: frozenset[str] = frozenset()
    """The names of the files that decide what starts at boot; only asked for by long reports for people."""
    part: Part = Part.WHOLE
    """What of a report for people is printed."""
    colour: bool = False
    width: int = 80

    def __post_init__(self) -> None:
        findings, mask = presented(self.findings, self.root, self.cwd)
        object.__setattr__(self, "findings", findings)
        if mask:
            said = (told._replace(message=mask.words(told.message)) for told in self.notifications)
            object.__setattr__(self, "notifications", tuple(said))

    @property
    def shown(self) -> Iterator[Finding]:
        """The findings that no comment suppresses."""
        return (finding for finding in self.findings if finding.suppression is None)

    @property
    def silenced(self) -> Iterator[tuple[str, int]]:
        """What suppresses findings, the comments first and then each configuration by its name, and how many."""
        silencing = [finding.suppression for finding in self.findings if finding.suppression]
        comments = sum(not each.external for each in silencing)
        if comments:
            yield "comments", comments
        yield from sorted(Counter(each.span.source.basename for each in silencing if each.external).items())

    @property
    def by_configuration(self) -> Iterator[str]:
        """What configurations keep from being reported, in words."""
        silencing = [each.suppression for each in self.findings if each.suppression and each.suppression.external]
        for name, number in sorted(Counter(each.span.source.basename for each in silencing).items()):
            yield f"{number} suppressed by {name}"
        yield from self.narrowed

    @property
    def worst_first(self) -> list[Finding]:
        """The findings that no comment suppresses, errors before warnings, for readers that stop early."""
        return sorted(self.shown, key=lambda finding: -finding.severity)

    @property
    def files(self) -> int:
        """How many files were checked."""
        return sum(self.kinds.values())
