"""The page of each rule: its documentation, an example of its output, and what belongs to it."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from collections.abc import Mapping
from pathlib import Path

from links import REPOSITORY

from bringup_lint.registry import Registry
from bringup_lint.registry import Rule
from bringup_lint.report.docs import HEADINGS
from bringup_lint.report.docs import LOG_LINES
from bringup_lint.report.docs import sections
from bringup_lint.toml import read_toml

REFERENCES = HEADINGS[-1]
SHOWN = 3
"""Findings of the bad fixture that a page shows."""
FIXES = {"none": "none", "safe": "[safe](../../fixes.md)", "unsafe": "[unsafe](../../fixes.md)"}


def rule_pages(registry: Registry, project: Path) -> Iterator[tuple[str, str]]:
    """Path and text of the page of each rule."""
    guides = _guides(project)
    for rule in registry.all():
        yield f"rules/{rule.id}.md", _page(rule, guides.get(rule.id, []), project)


def _page(rule: Rule, guides: list[str], project: Path) -> str:
    found = sections(rule.doc)
    references = found.pop(REFERENCES, "")
    parts = [_head(rule), f"# {rule.id}", f"**{_escaped(rule.title)}.**", _facts(rule)]
    parts += [f"## {heading}\n\n{body}" for heading, body in found.items()]
    parts += [f"## {heading}\n\n{body}" for heading, body in _further(rule, guides, project)]
    return "\n\n".join([*parts, f"## {REFERENCES}\n\n{references}\n- [The rule's source]({_source(rule)})"]) + "\n"


def _head(rule: Rule) -> str:
    return f"---\ntitle: {rule.id}\ndescription: {rule.title!r}\n---"


def _facts(rule: Rule) -> str:
    meta = rule.meta
    rows = {
        "Severity": str(rule.severity),
        "Confidence": str(meta.confidence),
        "Fix": FIXES[meta.fix],
        "Family": f"[{rule.family}](index.md)",
        "Since": meta.since,
        "Tags": ", ".join(meta.tags),
        "Former names": ", ".join(meta.aliases),
    }
    shown = {name: value for name, value in rows.items() if value}
    header = " | ".join(shown)
    return f"| {header} |\n|{'---|' * len(shown)}\n| {' | '.join(shown.values())} |"


def _further(rule: Rule, guides: list[str], project: Path) -> Iterator[tuple[str, str]]:
    output = _output(rule, project)
    if output:
        yield "What it prints", f"```text\n{output}\n```"
    if rule.meta.symptoms:
        lines = "\n".join(rule.meta.symptoms)
        yield LOG_LINES, f"`*` stands for any text. See [all log lines](../log-lines.md).\n\n```text\n{lines}\n```"
    elif rule.meta.silent:
        yield LOG_LINES, f"None: {_escaped(rule.meta.silent)}."
    if rule.meta.fix != "none":
        options = "--diff --unsafe-fixes" if rule.meta.fix == "unsafe" else "--diff"
        yield "Fix", f"This shows what the fix changes:\n\n```sh\nbringup-lint --select {rule.id} {options} .\n```"
    yield (
        "Suppress",
        f"[Suppressing findings](../../suppressing.md) has the form for each kind of file: `{_ignore(rule)}`",
    )
    if guides:
        yield "Guides", "\n".join(f"- {each}" for each in guides)


def _ignore(rule: Rule) -> str:
    return f"bringup-lint: ignore[{rule.id}]: reason"


def _output(rule: Rule, project: Path) -> str:
    """The first findings of the rule's bad fixture."""
    expected = project / "fixtures" / rule.id.replace("-", "_") / "expected.txt"
    if not expected.exists():
        return ""
    lines = [line for line in expected.read_text("utf-8").splitlines() if f"[{rule.id}]" in line]
    return "\n".join(lines[:SHOWN])


def _source(rule: Rule) -> str:
    return f"{REPOSITORY}rules/{rule.id.replace('-', '_')}.py"


def _guides(project: Path) -> Mapping[str, list[str]]:
    """Rule -> the items of the guides that it looks after, as links."""
    found = defaultdict(list)
    for item in read_toml((project / "docs/guides.toml").read_text("utf-8")).values():
        for each in item.values():
            for rule_id in each.get("rules", ()):
                found[rule_id].append(f"[{_escaped(each['what'])}](../../guides.md)")
    return found


def _escaped(text: str) -> str:
    """Text in Markdown without a meaning of its own for its signs."""
    return "".join(f"\\{sign}" if sign in "*_[]<`" else sign for sign in text)
