"""Findings as SARIF results."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import Any

from bringup_lint.finding import Finding
from bringup_lint.finding import Fix
from bringup_lint.finding import Related
from bringup_lint.finding.place import is_whole_file
from bringup_lint.finding.place import place_of
from bringup_lint.report.sarif.line_hash import line_hash
from bringup_lint.report.sarif.places import Places
from bringup_lint.report.sarif.places import exact_region
from bringup_lint.report.sarif.rules import LEVELS


def result(finding: Finding, index: int, places: Places, silenced: bool) -> dict[str, Any]:
    """A SARIF ``result``; ``silenced`` tells that some finding of the run is suppressed."""
    made: dict[str, Any] = {
        "ruleId": finding.rule,
        "ruleIndex": index,
        "level": LEVELS[finding.severity],
        "message": {"text": message(finding)},
        "locations": [{"physicalLocation": places.physical(finding.span)}],
        "partialFingerprints": _fingerprints(finding),
        "properties": {"confidence": str(finding.confidence)},
    }
    if finding.related:
        made["relatedLocations"] = [
            {"id": number, **_said(related, places)} for number, related in enumerate(finding.related, 1)
        ]
    if finding.chain:
        steps = [{"location": _said(step, places)} for step in finding.chain]
        made["codeFlows"] = [{"threadFlows": [{"locations": steps}]}]
    if finding.fix and finding.fix.edits:
        made["fixes"] = [_fix(finding.fix, places)]
    if silenced:
        made["suppressions"] = list(_suppressions(finding, places))
    return made


def _fingerprints(finding: Finding) -> dict[str, str]:
    """Ours, and the one that GitHub reads, for the line that the region starts in."""
    known = {"bringupLint/v1": finding.fingerprint}
    line = 1 if is_whole_file(finding.span) else place_of(finding.span).line
    of_line = line_hash(finding.source, line)
    return {**known, "primaryLocationLineHash": of_line} if of_line else known


def message(finding: Finding) -> str:
    """What happens, what to write instead, and links to the other places."""
    sentences = [_plain(finding.message), _plain(finding.advice)]
    for number, related in enumerate(finding.related, 1):
        sentences.append(f"See [{_link(related.message)}]({number})")
    return " ".join(_sentence(sentence) for sentence in sentences if sentence)


def _said(related: Related, places: Places) -> dict[str, Any]:
    text = _sentence(_plain(related.message) or "Related place")
    return {"physicalLocation": places.physical(related.span, context=False), "message": {"text": text}}


def _fix(fix: Fix, places: Places) -> dict[str, Any]:
    changes: dict[int, dict[str, Any]] = {}
    for span, text in fix.edits:
        where = places.artifact(span.source)
        change = changes.setdefault(where["index"], {"artifactLocation": where, "replacements": []})
        replacement = {"deletedRegion": exact_region(span), "insertedContent": {"text": text}}
        change["replacements"].append(replacement)
    return {
        "description": {"text": _sentence(_plain(fix.title))},
        "artifactChanges": list(changes.values()),
        "properties": {"applicability": str(fix.applicability)},
    }


def _suppressions(finding: Finding, places: Places) -> Iterable[dict[str, Any]]:
    if finding.suppression:
        yield {
            "kind": "external" if finding.suppression.external else "inSource",
            "justification": finding.suppression.reason,
            "location": {"physicalLocation": places.physical(finding.suppression.span, context=False)},
        }


def _plain(text: str) -> str:
    """Text in which nothing is taken for a link."""
    return re.sub(r"\[(?=[^\[\]]*\]\()", r"\\[", " ".join(text.split()))


def _link(text: str) -> str:
    return re.sub(r"([\\\[\]])", r"\\\1", " ".join(text.split()).rstrip("."))


def _sentence(text: str) -> str:
    """The text with a capital at its start and a stop at its end."""
    text = text.strip()
    end = "" if text.endswith((".", "!", "?")) else "."
    starts_a_word = re.match(r"[a-z]+(?=[ ,])", text)
    return (text[0].upper() + text[1:] if starts_a_word else text) + end
