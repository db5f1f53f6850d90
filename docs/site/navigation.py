"""The navigation: the known pages in their order, the rules by family, and every further page of ``docs/``."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from bringup_lint.registry import Family
from bringup_lint.registry import Registry

USE = ("rollout", "suppressing", "fixes", "purposes", "live", "fleet", "graph", "editors", "faq")
REPORTS = ("output-formats", "sarif", "json", "ci", "changes", "github", "gitlab", "pre-commit", "colcon")
RULES = ("guides", "cross-layer", "versioning")
INDEXES = ({"By log line": "rules/log-lines.md"}, {"By kind of file": "rules/files.md"})
CODE = ("architecture", "rule-api")


def tree(project: Path, registry: Registry) -> list[Any]:
    """What mkdocs takes as ``nav``."""
    pages = {path.stem for path in (project / "docs").glob("*.md")} - {"README"}
    placed = {*USE, *REPORTS, *RULES, *CODE}
    further = [f"{stem}.md" for stem in sorted(pages - placed)]
    return [
        {"Start": ["index.md", {"All pages": "contents.md"}]},
        {"Use": [{"Configuration": "configuration.md"}, *_known(USE, pages), *further]},
        {"Reports and CI": _known(REPORTS, pages)},
        {"Rules": ["rules/index.md", *INDEXES, *_known(RULES, pages), *_families(registry)]},
        {"Write rules": [{"Contributing": "contributing.md"}, *_known(CODE, pages), {"Changelog": "changelog.md"}]},
    ]


def _known(stems: tuple[str, ...], pages: set[str]) -> list[str]:
    return [f"{stem}.md" for stem in stems if stem in pages]


def _families(registry: Registry) -> list[Any]:
    return [{family.name: _family(family)} for family in registry.families]


def _family(family: Family) -> list[str | dict[str, str]]:
    named = [family.rule_id(path).partition("/")[2] for path in family.rule_paths]
    return [f"rules/{family.name}/index.md", *({name: f"rules/{family.name}/{name}.md"} for name in named)]
