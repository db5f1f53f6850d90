"""What every rule imports: the decorator, findings and fixes, and the robot.

The modules of this package hold what rules of one subject need besides: ``from bringup_lint.api import launch``, or
``from bringup_lint.api.systemd import flag``. A module loads the layers of its subject only.
"""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.dataclass import dataclass
from bringup_lint.finding import Applicability
from bringup_lint.finding import Codemod
from bringup_lint.finding import Confidence
from bringup_lint.finding import Edit
from bringup_lint.finding import Finding
from bringup_lint.finding import Fix
from bringup_lint.finding import Related
from bringup_lint.finding import Severity
from bringup_lint.finding import span_of
from bringup_lint.graph.purpose import Purpose
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.robot import Robot
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source
from bringup_lint.source import Span
from bringup_lint.type_names import Any

__all__ = [
    "Edit",
    "Finding",
    "Fix",
    "Located",
    "NamedTuple",
    "Place",
    "Problem",
    "Purpose",
    "Related",
    "Robot",
    "Source",
    "Span",
    "finding",
    "fix",
    "note",
    "regex",
    "rule",
]

Place = Located | Span | Source
Check = Callable[[Any], Iterator[Any]]
"""A robot -> findings; for a rule of the fleet, a fleet -> findings of the fleet."""


@dataclass(frozen=True)
class Metadata:
    """What a rule says about itself."""

    severity: Severity
    confidence: Confidence
    fix: str
    since: str
    symptoms: tuple[str, ...]
    silent: str
    """Why no program reports the defect; empty when one does."""
    tags: tuple[str, ...]
    aliases: tuple[str, ...]
    check: Check


def rule(
    severity: str,
    *,
    confidence: str = "high",
    fix: str = "none",
    since: str = "0.1",
    symptoms: Iterable[str] = (),
    silent: str = "",
    tags: Iterable[str] = (),
    aliases: Iterable[str] = (),
) -> Callable[[Check], Metadata]:
    """Make a generator function a rule.

    ``severity`` is ``error``, ``warning`` or ``info`` (a single finding may differ); ``fix`` is ``none``, ``safe`` or
    ``unsafe``, and every fix is unsafe unless it is ``safe``; ``symptoms`` are log lines by which people meet the
    defect, the most frequent first, with ``*`` for any text; ``silent`` says why there is none; ``tags`` are words such
    as ``CWE-250``.
    """
    if fix not in ("none", "safe", "unsafe"):
        raise ValueError(f"fix must be none, safe or unsafe, not {fix!r}")

    def decorate(check: Check) -> Metadata:
        return Metadata(
            Severity[severity.upper()],
            Confidence[confidence.upper()],
            fix,
            since,
            tuple(symptoms),
            silent,
            tuple(tags),
            tuple(aliases),
            check,
        )

    return decorate


def note(where: Place, message: str) -> Related:
    """Another place that has a part in the finding: ``note(interface.name, "the interface is declared here")``."""
    return Related(span_of(where), message)


def fix(title: str, *edits: tuple[Place, str], safe: bool = True, codemod: Codemod | None = None) -> Fix:
    """A change of one or more places; an empty replacement deletes. A codemod changes a Python file as a whole."""
    applicability = Applicability.SAFE if safe else Applicability.UNSAFE
    return Fix(title, tuple(Edit(span_of(where), text) for where, text in edits), applicability, codemod)


def finding(
    where: Place,
    message: str,
    *,
    advice: str = "",
    related: Iterable[Related] = (),
    chain: Iterable[Related] = (),
    fix: Fix | None = None,
    severity: str | None = None,
    confidence: str | None = None,
    hidden: Iterable[Place] = (),
    secrets: Iterable[Place] = (),
) -> Finding:
    """One defect at one place. ``message`` says what happens on the robot, ``advice`` what to write instead.
    ``severity`` and ``confidence`` are the rule's where they are not given, and evidence can only lower the confidence;
    ``secrets`` are the values (passwords, keys) that no report may show."""
    return Finding(
        message=message,
        span=span_of(where),
        own_severity=None if severity is None else Severity[severity.upper()],
        own_confidence=None if confidence is None else Confidence[confidence.upper()],
        advice=advice,
        related=tuple(related),
        chain=tuple(chain),
        fix=fix,
        hidden=tuple(span_of(place) for place in hidden),
        secrets=tuple(span_of(place) for place in secrets),
    )
