"""The list of the rules."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import groupby
from pathlib import Path

from bringup_lint.cli.streams import complain
from bringup_lint.cli.streams import put
from bringup_lint.cli.terminal import wants_colour
from bringup_lint.registry import Registry
from bringup_lint.registry import Rule
from bringup_lint.report.paint import painter
from bringup_lint.spelling import meant
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.cache.answers import Question


def plain(families: tuple[str, ...], question: Question | None) -> int:
    """List rules without options."""
    return list_rules(families, "text", (), None)


def list_rules(families: tuple[str, ...], output_format: str, rule_folders: Iterable[Path], colour: bool | None) -> int:
    """List the rules of some families, or all; returns the exit code."""
    registry = Registry.of(rule_folders)
    unknown = set(families) - {family.name for family in registry.families}
    if unknown:
        name = sorted(unknown)[0]
        near = meant(name, [family.name for family in registry.families])
        hint = f"did you mean '{near}'?" if near else "bringup-lint rules lists all"
        complain(f"no family is called '{name}'; {hint}")
        return 2
    rules = [rule for rule in registry.all() if not families or rule.family in families]
    put(_as_json(rules) if output_format == "json" else _as_text(rules, registry, wants_colour(colour)))
    return 0


def _as_json(rules: list[Rule]) -> str:
    import json

    return json.dumps([_data(rule) for rule in rules], indent=2, ensure_ascii=False) + "\n"


def _as_text(rules: list[Rule], registry: Registry, colour: bool) -> str:
    titles = {family.name: family.title for family in registry.families}
    paint = painter(colour)
    lines = []
    for family, group in groupby(rules, key=lambda rule: rule.family):
        members = list(group)
        width = max(len(rule.id) for rule in members)
        lines.append(paint("strong", f"{titles[family]} ({len(members)})"))
        for rule in members:
            mark = {"safe": "*", "unsafe": "+"}.get(rule.meta.fix, " ")
            severity = paint(str(rule.severity), f"{rule.severity!s:<8}")
            lines.append(f"  {severity}{mark} {rule.id:<{width}}  {rule.title}")
        lines.append("")
    lines.append(f"{len(rules)} rules. * has a safe fix, + an unsafe one. bringup-lint explain RULE says more.")
    return "\n".join(lines) + "\n"


def _data(rule: Rule) -> dict[str, object]:
    return {
        "id": rule.id,
        "title": rule.title,
        "severity": str(rule.severity),
        "confidence": str(rule.meta.confidence),
        "fix": rule.meta.fix,
        "since": rule.meta.since,
        "aliases": rule.meta.aliases,
        "tags": rule.meta.tags,
        "symptoms": rule.meta.symptoms,
        "silent": rule.meta.silent,
    }
