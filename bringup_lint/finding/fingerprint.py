"""Fingerprints: what makes a finding the same finding after lines have moved."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable
from functools import lru_cache

from bringup_lint.finding import Finding
from bringup_lint.finding.place import inside
from bringup_lint.finding.place import is_whole_file
from bringup_lint.finding.uri import below_root


def fingerprints(findings: Iterable[Finding], root: str, cwd: str = "") -> list[str]:
    """One for each finding, whose secrets are masked: made of the rule, the path below ``root``, the text of the line,
    the message without its numbers, and a count of those that are alike in all this."""
    seen: Counter[tuple[str, ...]] = Counter()
    made = []
    for finding in findings:
        path = below_root(finding.source.name, root, cwd)
        key = (finding.rule, path, _line(finding), _skeleton(finding.message))
        made.append(_digest(*key, str(seen[key])))
        seen[key] += 1
    return made


def _line(finding: Finding) -> str:
    if is_whole_file(finding.span):
        return ""
    source, start, _ = inside(finding.span)
    return _masked(" ".join(source.line_text(source.position(start).line).split()))


@lru_cache(1000)
def _skeleton(message: str) -> str:
    return _masked(re.sub(r"\d+", "0", " ".join(message.split())))


def _masked(text: str) -> str:
    """The text without the length of what is masked."""
    return re.sub(r"\*+", "*", text) if "**" in text else text


def _digest(*parts: str) -> str:
    from hashlib import sha256

    return sha256("\0".join(parts).encode("utf-8", "surrogatepass")).hexdigest()[:32]
