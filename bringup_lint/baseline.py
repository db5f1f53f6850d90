"""Baselines: findings that are known and shall not be reported again."""

from __future__ import annotations

import json
from collections.abc import Iterable
from typing import NamedTuple

from bringup_lint.finding import Finding
from bringup_lint.report.fingerprint import fingerprints
from bringup_lint.report.redact import mask_of
from bringup_lint.report.uri import below_root

VERSION = 1


class BaselineError(ValueError):
    """The baseline file is not one, or comes from a newer version."""


class Sifted(NamedTuple):
    """Findings held against a baseline."""

    new: tuple[Finding, ...]
    known: tuple[Finding, ...]
    gone: int
    """How many entries of the baseline no finding matches any more."""


def written(findings: Iterable[Finding], root: str, cwd: str = "") -> str:
    """The text of a baseline file; it holds no line numbers, and no secrets."""
    findings = tuple(finding for finding in findings if finding.suppression is None)
    mask = mask_of(findings)
    entries = [
        {
            "path": _text(below_root(finding.source.name, root, cwd)),
            "rule": finding.rule,
            "message": _text(mask.words(finding.message) if mask else finding.message),
            "fingerprint": fingerprint,
        }
        for finding, fingerprint in zip(findings, fingerprints(findings, root, cwd), strict=True)
    ]
    entries.sort(key=lambda entry: tuple(entry.values()))
    return json.dumps({"version": VERSION, "findings": entries}, indent=2) + "\n"


def read(text: str) -> frozenset[str]:
    """The fingerprints in a baseline file.

    Raises BaselineError with one clear line when the text is not a baseline of a known version.
    """
    try:
        content = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise BaselineError(f"not a baseline: {error}") from error
    if not isinstance(content, dict) or "version" not in content:
        raise BaselineError("not a baseline: it has no version")
    if content["version"] != VERSION:
        raise BaselineError(f"baseline of version {content['version']}; this program reads {VERSION}")
    try:
        return frozenset(str(entry["fingerprint"]) for entry in content["findings"])
    except (KeyError, TypeError) as error:
        raise BaselineError("not a baseline: findings without fingerprints") from error


def sift(findings: Iterable[Finding], known: frozenset[str], root: str, cwd: str = "") -> Sifted:
    """Part the findings into new ones and those that the baseline knows."""
    findings = tuple(findings)
    marks = fingerprints(findings, root, cwd)
    new = tuple(finding for finding, mark in zip(findings, marks, strict=True) if mark not in known)
    old = tuple(finding for finding, mark in zip(findings, marks, strict=True) if mark in known)
    return Sifted(new, old, len(known.difference(marks)))


def _text(text: str) -> str:
    return text.encode("utf-8", "replace").decode()
