"""Fingerprints: what makes a finding the same finding after lines have moved."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable
from functools import lru_cache

from bringup_lint.digest import new_sha256
from bringup_lint.finding import Finding
from bringup_lint.finding.place import inside
from bringup_lint.finding.place import is_whole_file
from bringup_lint.finding.uri import below_root
from bringup_lint.source import Source
from bringup_lint.type_names import Any


def fingerprints(findings: Iterable[Finding], root: str, cwd: str = "") -> list[str]:
    """One for each finding, whose secrets are masked: made of the rule, the path below ``root``, the text of the line,
    the message without its numbers, and a count of those that are alike in all this."""
    seen: Counter[tuple[str, ...]] = Counter()
    made = []
    lines = _Lines()
    for finding in findings:
        path = below_root(finding.source.name, root, cwd)
        line = lines.of(finding)
        key = (finding.rule, path, line, _skeleton(finding.message))
        digest = lines.digest(finding.rule, path, line)
        digest.update(_bytes("", key[-1], str(seen[key])))
        made.append(digest.hexdigest()[:32])
        seen[key] += 1
    return made


class _Lines:
    """What lines add to fingerprints: each is read once, however many findings it has."""

    def __init__(self) -> None:
        self._texts: dict[tuple[Source, int], str] = {}
        self._digests: dict[tuple[str, str, str], Any] = {}
        self._begun = new_sha256()

    def of(self, finding: Finding) -> str:
        """The text of the line of a finding, without what moves."""
        if is_whole_file(finding.span):
            return ""
        source, start, _ = inside(finding.span)
        line = source.position(start).line
        if (source, line) not in self._texts:
            self._texts[source, line] = _masked(" ".join(source.line_text(line).split()))
        return self._texts[source, line]

    def digest(self, rule: str, path: str, line: str) -> Any:
        """A digest that has begun with a rule, a path and a line."""
        parts = (rule, path, line)
        if parts not in self._digests:
            self._digests[parts] = self._begun(_bytes(*parts))
        return self._digests[parts].copy()


@lru_cache(1000)
def _skeleton(message: str) -> str:
    return _masked(re.sub(r"\d+", "0", " ".join(message.split())))


def _masked(text: str) -> str:
    """The text without the length of what is masked."""
    return re.sub(r"\*+", "*", text) if "**" in text else text


def _bytes(*parts: str) -> bytes:
    return "\0".join(parts).encode("utf-8", "surrogatepass")
