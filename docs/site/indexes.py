"""The lists of rules: all, those of a family, by log line and by kind of file."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.facts import table
from bringup_lint.registry import Family
from bringup_lint.registry import Registry
from bringup_lint.registry import Rule

FIXES = {"none": "", "safe": "safe", "unsafe": "unsafe"}
FILTER = (
    '<input class="filter" type="search" placeholder="Part of a line, or a rule" aria-label="Filter the table">'
    '<output class="filtered"></output>'
)


def index_pages(registry: Registry) -> Iterator[tuple[str, str]]:
    """Path and text of each list."""
    rules = list(registry.all())
    yield "rules/index.md", _all(registry, rules)
    yield "rules/log-lines.md", _log_lines(rules)
    yield "rules/files.md", _files(registry)
    for family in registry.families:
        members = [rule for rule in rules if rule.family == family.name]
        yield f"rules/{family.name}/index.md", _family(family, members)


def _all(registry: Registry, rules: list[Rule]) -> str:
    rows = [
        f"| [{family.name}]({family.name}/index.md) | {family.title} | {len(family.rule_paths)} |"
        for family in registry.families
    ]
    return "\n".join(
        (
            "# Rules",
            "",
            f"{len(rules)} rules in {len(registry.families)} families. Find one [by the line of a log](log-lines.md), "
            "[by the kind of file](files.md) or [by the guide](../guides.md) that asks for it, or search.",
            "",
            "| family | files | rules |",
            "|---|---|---|",
            *rows,
            "",
            "## All rules",
            "",
            FILTER,
            "",
            *_table(rules, ""),
            "",
        )
    )


def _family(family: Family, members: list[Rule]) -> str:
    reads = ", ".join(f"`{kind}`" for kind in sorted(family.reads))
    parts = [f"# {family.name}", "", f"**{family.title}.** {family.description}", ""]
    parts += [f"Read for these [kinds of file](../files.md): {reads}.", ""] if reads else []
    return "\n".join([*parts, *_table(members, "../"), ""])


def _table(rules: Iterable[Rule], up: str) -> Iterator[str]:
    yield "| rule | finds | severity | fix |"
    yield "|---|---|---|---|"
    for rule in rules:
        title = rule.title.replace("|", "\\|")
        yield f"| [{rule.id}]({up}{rule.id}.md) | {title} | {rule.severity} | {FIXES[rule.meta.fix]} |"


def _log_lines(rules: list[Rule]) -> str:
    known = defaultdict(list)
    for rule in rules:
        for symptom in rule.meta.symptoms:
            known[symptom].append(f"[{rule.id}]({rule.id}.md)")
    rows = [f"| {_code(line)} | {', '.join(known[line])} |" for line in sorted(known, key=str.lower)]
    silent = [f"| [{rule.id}]({rule.id}.md) | {_cell(rule.meta.silent)} |" for rule in rules if rule.meta.silent]
    other = [f"| {_code(row['pattern'])} | {_cell(row['reason'])} |" for row in table("logs/other_causes")]
    return "\n".join(
        (
            "---\nsearch:\n  boost: 4\n---",
            "",
            "# Log lines",
            "",
            "`bringup-lint explain` with a whole line of a log names the rules that explain it, the most likely first. "
            "Here are the known lines; `*` stands for any text.",
            "",
            FILTER,
            "",
            "| log line | rules |",
            "|---|---|",
            *rows,
            "",
            "## Lines that no rule explains",
            "",
            "| log line | what it means |",
            "|---|---|",
            *other,
            "",
            "## Defects that no program reports",
            "",
            "| rule | why there is no log line |",
            "|---|---|",
            *silent,
            "",
        )
    )


def _files(registry: Registry) -> str:
    readers: dict[str, set[str]] = defaultdict(set)
    for family in registry.families:
        for kind in family.reads.union(*family.joins.values()):
            readers[kind].add(family.name)
    rows = [
        f"| `{kind}` | {', '.join(f'[{name}]({name}/index.md)' for name in sorted(readers[kind]))} |"
        for kind in sorted(readers)
    ]
    always = [f"[{family.name}]({family.name}/index.md)" for family in registry.families if not family.reads]
    return "\n".join(
        (
            "# Rules by kind of file",
            "",
            "A family of rules runs when the tree has a file of a kind that it reads, or that one of its rules joins "
            "with others.",
            "",
            "| kind of file | families |",
            "|---|---|",
            *rows,
            "",
            f"Families that do not depend on a kind of file: {', '.join(always)}.",
            "",
        )
    )


def _cell(text: str) -> str:
    return text.replace("|", "\\|").replace("<", "&lt;").replace("*", "\\*")


def _code(line: str) -> str:
    """A line as code in a cell of a table."""
    fence = "``" if "`" in line else "`"
    return (
        f"{fence}{' ' if fence == '``' else ''}{line.replace('|', chr(92) + '|')}{' ' if fence == '``' else ''}{fence}"
    )
