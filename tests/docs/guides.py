"""Finds what the four guides warn of and ask for, by their structure, and draws ``docs/guides.md``.

The texts of the guides are not part of the project: an item is known by its guide, its kind, its ordinal and a
fingerprint of its words. ``docs/guides.toml`` says for each, in words of its own, which rules look after it, or why
files cannot show it.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from hashlib import sha256
from pathlib import Path

from bringup_lint.toml import read_toml
from tests.conftest import PROJECT

GUIDES = {
    "robot-bringup": "Robot bring-up",
    "robotics-security": "Robotics security",
    "ros2-robotics-skill": "ROS 2 robotics",
    "ros2-chapter": "The ROS 2 chapter",
}
KINDS = {
    "anti-pattern": "anti-patterns",
    "bad-example": "bad examples",
    "good-example": "examples of how to do it",
    "checklist": "checklists",
    "critical": "critical notes",
}
MARKS = {
    "anti-pattern": re.compile(r"\bproblem(?::| with )", re.I),
    "bad-example": re.compile(r"#\s*bad\b", re.I),
    "good-example": re.compile(r"#\s*good\b", re.I),
    "critical": re.compile(
        r"critical: true|\bCRITICAL:|\b(?:NEVER|NOT|PROTECT|Always|Must|must|ensure|[Nn]ever)\b"
        r"|[a-z]-critical|\bis critical\b"
    ),
}
"""What an item of a kind starts with. Marks within one sentence count once."""

CHECKLISTS = {
    re.compile(r"Checklist\n((?:.|\n)*)"): re.compile(r"(?<!\S)- (?=\w)"),
    re.compile(r"Practices:\n((?:\s*\d\. .*)+)"): re.compile(r"^\s*\d\. ", re.M),
    re.compile(r"^((?:✅ .*\n)+)", re.M): re.compile(r"^✅ ", re.M),
    re.compile(r"\| Vector \| Impact \|\n\|[-|]+\n((?:\|.*\n)+)"): re.compile(r"^\| ", re.M),
    # one page was cut off in its list, and the next one glued to the item
    re.compile(r"^(\w[^\n]* — [^\n]*\w)development$", re.M): re.compile(r"^(?=\w)", re.M),
}
"""A list that is to be ticked off, and what an item of it starts with."""

INTRODUCTION = """\
# The guides, and the rules that look after them

Four guides to the bring-up of ROS 2 robots are widely followed. Each thing that they warn of or ask for is here, in
the words of this project, with the rules that find it, or with the reason why the files of a robot cannot show it.
Some of the guides' own examples do not do what they say; there the rules say what really happens.
`fixtures/robots/guide` is a robot that follows all four, and its
[traps.toml](../fixtures/robots/guide/traps.toml) lists the examples that fail.

This page is drawn from [guides.toml](guides.toml) by `pytest tests/docs/test_guides.py --update-expected`.
"""

TABLE = "| | what | rules | what files cannot show |\n|---|---|---|---|"

WORDS = 60
"""How many letters and digits behind its mark make an item's fingerprint."""


def items(text: str) -> Iterator[tuple[str, str, str]]:
    """Key (``anti-pattern-3``), fingerprint and opening of each item of a guide."""
    for kind, mark in MARKS.items():
        starts = [match.start() for match in mark.finditer(text)]
        first_of_sentence = [start for start, before in zip(starts, [-999, *starts]) if start - before > WORDS]
        yield from _numbered(kind, [text[start:] for start in first_of_sentence])
    ticked = []
    for shape, mark in CHECKLISTS.items():
        for block in shape.finditer(text):
            ticked += [block[1][match.end() :] for match in mark.finditer(block[1])]
    yield from _numbered("checklist", ticked)


def _numbered(kind: str, texts: list[str]) -> Iterator[tuple[str, str, str]]:
    for number, text in enumerate(texts, 1):
        letters = re.sub(r"[^a-z0-9]", "", text[: 4 * WORDS].lower())[:WORDS]
        yield f"{kind}-{number}", sha256(letters.encode()).hexdigest()[:8], text[:WORDS]


def texts(folder: Path) -> dict[str, str]:
    return {guide: (folder / f"{guide}.txt").read_text("utf-8") for guide in GUIDES}


def answers() -> dict[str, dict[str, dict]]:
    """Guide -> key -> what ``docs/guides.toml`` says."""
    return read_toml((PROJECT / "docs" / "guides.toml").read_text("utf-8"))


def page() -> str:
    """``docs/guides.md``: for each guide and kind a table of the items, their rules and their limits."""
    sections = [INTRODUCTION]
    for guide, title in GUIDES.items():
        sections.append(f"## {title}\n")
        for kind, heading in KINDS.items():
            rows = [_row(key, entry) for key, entry in answers()[guide].items() if key.startswith(f"{kind}-")]
            if rows:
                sections.append(
                    f"### {title}: {heading}\n\n| | what | rules | what files cannot show |\n|---|---|---|---|"
                )
                sections.append("\n".join(rows) + "\n")
    return "\n".join(sections)


def _row(key: str, entry: dict) -> str:
    rules = ", ".join(f"[{rule}](../rules/{rule.replace('-', '_')}.py)" for rule in entry.get("rules", ()))
    number, limit = key.rpartition("-")[2], entry.get("reason", entry.get("limit", ""))
    return f"| {number} | {entry['what']} | {rules or '—'} | {limit} |"
