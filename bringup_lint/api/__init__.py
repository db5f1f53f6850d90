"""All that a rule imports: the decorator, findings, and the words of the model."""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator
from dataclasses import dataclass
from importlib import import_module
from typing import Any

from bringup_lint.finding import Applicability
from bringup_lint.finding import Confidence
from bringup_lint.finding import Edit
from bringup_lint.finding import Finding
from bringup_lint.finding import Fix
from bringup_lint.finding import Related
from bringup_lint.finding import Severity
from bringup_lint.finding import span_of
from bringup_lint.robot import Robot
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span

__all__ = ["Edit", "Finding", "Located", "Robot", "Source", "Span", "finding", "fix", "note", "rule"]

_WORDS = {
    "all_respawn": "bringup_lint.graph.launch.of_units",
    "at_least": "bringup_lint.facts.ros.distros",
    "commands_of": "bringup_lint.parsers.dockerfile",
    "daemon_rules": "bringup_lint.daemon_rules",
    "daemons": "bringup_lint.graph.host.daemons",
    "delete_lines": "bringup_lint.graph.systemd.unit_edits",
    "devices_of": "bringup_lint.graph.launch.of_units",
    "directives": "bringup_lint.facts.systemd.directives",
    "distro_end": "bringup_lint.facts.ros.distros",
    "distros_since": "bringup_lint.facts.ros.distros",
    "duration": "bringup_lint.graph.systemd.settings",
    "file_capabilities": "bringup_lint.graph.systemd.capabilities",
    "first_key": "bringup_lint.graph.yaml_edits",
    "flag": "bringup_lint.graph.systemd.settings",
    "forgotten": "bringup_lint.graph.systemd.filesystem",
    "granted_limits": "bringup_lint.graph.systemd.limits",
    "is_example": "bringup_lint.templates",
    "is_made": "bringup_lint.graph.systemd.filesystem",
    "is_stand_in": "bringup_lint.templates",
    "is_there": "bringup_lint.graph.systemd.filesystem",
    "json5": "bringup_lint.parsers.json5",
    "launch": "bringup_lint.graph.launch.words",
    "launched": "bringup_lint.graph.launch.of_units",
    "lift_comment": "bringup_lint.graph.systemd.unit_edits",
    "memory": "bringup_lint.graph.systemd.memory",
    "move_lines": "bringup_lint.graph.systemd.unit_edits",
    "nearest": "bringup_lint.spelling",
    "nodes": "bringup_lint.graph.nodes.words",
    "paths": "bringup_lint.graph.systemd.sandbox",
    "ros_values": "bringup_lint.parsers.ros_values",
    "runs_as_root": "bringup_lint.model.dockerfile",
    "sandbox": "bringup_lint.graph.systemd.sandbox",
    "shell_commands": "bringup_lint.parsers.shell",
    "stop_time": "bringup_lint.graph.launch.supervision",
    "topics": "bringup_lint.graph.topics.words",
}
"""Words of single layers, and whole modules of them, loaded when the first rule asks for them."""


def __getattr__(name: str) -> Any:
    if name not in _WORDS:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    module = import_module(_WORDS[name])
    return getattr(module, name, module)


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
