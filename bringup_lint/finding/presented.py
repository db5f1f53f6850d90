"""Findings as reports and baselines show them: masked, each with its fingerprint."""

from __future__ import annotations

from collections.abc import Iterable

from bringup_lint.finding import Finding
from bringup_lint.finding import changed
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.finding.redact import Mask


class Presented(NamedTuple):
    """Findings without their secrets."""

    findings: tuple[Finding, ...]
    mask: Mask | None
    """What hid the secrets; None when there was nothing to hide."""


def presented(findings: Iterable[Finding], root: str, cwd: str = "") -> Presented:
    """The findings, masked, with fingerprints for paths below ``root``. A finding that has a fingerprint is masked."""
    findings = tuple(findings)
    if all(finding.fingerprint for finding in findings):
        return Presented(findings, None)
    from bringup_lint.finding.fingerprint import fingerprints
    from bringup_lint.finding.redact import mask_of

    mask = mask_of(findings)
    masked = [mask.finding(finding) for finding in findings] if mask else list(findings)
    marks = fingerprints(masked, root, cwd)
    return Presented(tuple(changed(finding, fingerprint=mark, copies=()) for finding, mark in zip(masked, marks)), mask)
