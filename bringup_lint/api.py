"""All that a rule imports: the decorator, findings, and the words of the model."""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from bringup_lint.facts import directives
from bringup_lint.finding import Applicability
from bringup_lint.finding import Confidence
from bringup_lint.finding import Edit
from bringup_lint.finding import Finding
from bringup_lint.finding import Fix
from bringup_lint.finding import Related
from bringup_lint.finding import Severity
from bringup_lint.finding import span_of
from bringup_lint.graph.settings import duration
from bringup_lint.graph.unit_edits import delete_lines
from bringup_lint.graph.unit_edits import lift_comment
from bringup_lint.graph.unit_edits import move_lines
from bringup_lint.model.dockerfile import Stage
from bringup_lint.model.dockerfile import runs_as_root
from bringup_lint.model.shell import Command
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.robot import Robot
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span
from bringup_lint.spelling import nearest
from bringup_lint.templates import is_example
from bringup_lint.templates import is_stand_in

__all__ = [
    "Edit",
    "Finding",
    "Located",
    "Robot",
    "Source",
    "Span",
    "commands_of",
    "delete_lines",
    "directives",
    "duration",
    "finding",
    "first_key",
    "fix",
    "is_example",
    "is_stand_in",
    "lift_comment",
    "move_lines",
    "nearest",
    "note",
    "rule",
    "runs_as_root",
]

Place = Located | Span | Source
Check = Callable[[Robot], Iterator[Finding]]


@dataclass(frozen=True)
class Metadata:
    """What a rule says about itself."""

    severity: Severity
    confidence: Confidence
    fix: str
    since: str
    symptoms: tuple[str, ...]
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
    tags: Iterable[str] = (),
    aliases: Iterable[str] = (),
) -> Callable[[Check], Metadata]:
    """Make a generator function a rule.

    ``severity`` is ``error``, ``warning`` or ``info`` (a single finding may differ); ``fix`` is ``none``, ``safe`` or
    ``unsafe``; ``symptoms`` are log lines by which people meet the defect; ``tags`` are words such as ``CWE-250``.
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
            tuple(tags),
            tuple(aliases),
            check,
        )

    return decorate


def note(where: Place, message: str) -> Related:
    """Another place that has a part in the finding: ``note(interface.name, "the interface is declared here")``."""
    return Related(span_of(where), message)


def fix(title: str, *edits: tuple[Place, str], safe: bool = True) -> Fix:
    """A change of one or more places; an empty replacement deletes."""
    applicability = Applicability.SAFE if safe else Applicability.UNSAFE
    return Fix(title, tuple(Edit(span_of(where), text) for where, text in edits), applicability)


def finding(
    where: Place,
    message: str,
    *,
    advice: str = "",
    related: Iterable[Related] = (),
    chain: Iterable[Related] = (),
    fix: Fix | None = None,
    severity: str | None = None,
    confidence: str = "high",
    hidden: Iterable[Place] = (),
    secrets: Iterable[Place] = (),
) -> Finding:
    """One defect at one place. ``message`` says what happens on the robot, ``advice`` what to write instead;
    ``secrets`` are the values (passwords, keys) that no report may show."""
    return Finding(
        message=message,
        span=span_of(where),
        severity=None if severity is None else Severity[severity.upper()],
        confidence=Confidence[confidence.upper()],
        advice=advice,
        related=tuple(related),
        chain=tuple(chain),
        fix=fix,
        hidden=tuple(span_of(place) for place in hidden),
        secrets=tuple(span_of(place) for place in secrets),
    )


def __getattr__(name: str) -> Any:
    """``launch``: the words of the launch model, loaded only by the rules that speak of launch files."""
    if name == "launch":
        import bringup_lint.graph.launch_words

        return bringup_lint.graph.launch_words
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def commands_of(stage: Stage) -> Iterator[Command]:
    """The shell commands of a Dockerfile stage's RUN instructions, in order."""
    from bringup_lint.parsers.shell import commands

    for instruction in stage.all("RUN"):
        for script in instruction.scripts:
            yield from commands(script)


def first_key(mapping: Mapping, text: str) -> tuple[Span, str]:
    """The edit that puts ``key: value`` first into a YAML mapping, in its own indentation or style."""
    source, at = mapping.span.source, mapping.span.start + mapping.flow
    gap = ", " if mapping.flow else "\n" + " " * (source.position(at).column - 1)
    return source.span(at, at), text + gap
