"""Baselines: findings that are known and are not reported again."""

from __future__ import annotations

import json
from collections.abc import Iterable
from typing import NamedTuple

from bringup_lint.finding import Finding
from bringup_lint.finding.uri import below_root

VERSION = 1


class BaselineError(ValueError):
    """The baseline file is not one, or comes from a newer version."""


class Sifted(NamedTuple):
    """Findings compared with a baseline."""

    new: tuple[Finding, ...]
    known: tuple[Finding, ...]
    gone: int
    """How many entries of the baseline no finding matches any more."""


def written(findings: Iterable[Finding], root: str, cwd: str = "") -> str:
    """The text of a baseline file for presented findings; it holds no line numbers, and no secrets."""
    entries = [
        {
            "path": _text(below_root(finding.source.name, root, cwd)),
            "rule": finding.rule,
            "message": _text(finding.message),
            "fingerprint": finding.fingerprint,
        }
        for finding in findings
        if finding.suppression is None
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


def sift(findings: Iterable[Finding], known: frozenset[str]) -> Sifted:
    """Split presented findings into new ones and those that the baseline knows."""
    findings = tuple(findings)
    new = tuple(finding for finding in findings if finding.fingerprint not in known)
    old = tuple(finding for finding in findings if finding.fingerprint in known)
    return Sifted(new, old, len(known.difference(finding.fingerprint for finding in findings)))


def _text(text: str) -> str:
    return text.encode("utf-8", "replace").decode()
