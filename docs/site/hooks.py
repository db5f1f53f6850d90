"""What mkdocs calls while it builds the site: the pages that are made from the rules, the links, the navigation."""

from __future__ import annotations

import sys
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(PROJECT))

from collections.abc import Iterator  # noqa: E402

import links  # noqa: E402
import navigation  # noqa: E402
import settings  # noqa: E402
from indexes import index_pages  # noqa: E402
from mkdocs.config.defaults import MkDocsConfig  # noqa: E402
from mkdocs.structure.files import File  # noqa: E402
from mkdocs.structure.files import Files  # noqa: E402
from mkdocs.structure.pages import Page  # noqa: E402
from rule_pages import rule_pages  # noqa: E402

from bringup_lint.registry import Registry  # noqa: E402


def on_config(config: MkDocsConfig) -> MkDocsConfig:
    config.nav = navigation.tree(PROJECT, Registry.of())
    return config


def on_files(files: Files, config: MkDocsConfig) -> Files:
    for path, text in _made():
        files.append(File.generated(config, path, content=text))
    return files


def on_page_markdown(markdown: str, page: Page, config: MkDocsConfig, files: Files) -> str:
    return markdown if page.file.generated_by else links.rewritten(markdown)


def _made() -> Iterator[tuple[str, str]]:
    """Path and text of the pages that no file holds."""
    registry = Registry.of()
    yield "index.md", links.from_the_top((PROJECT / "README.md").read_text("utf-8"))
    yield "changelog.md", links.from_the_top((PROJECT / "CHANGELOG.md").read_text("utf-8"))
    yield "contributing.md", links.from_the_top((PROJECT / "CONTRIBUTING.md").read_text("utf-8"))
    yield "contents.md", links.rewritten((PROJECT / "docs/README.md").read_text("utf-8"))
    yield "configuration.md", settings.page(PROJECT / "docs/bringup-lint.schema.json")
    yield from rule_pages(registry, PROJECT)
    yield from index_pages(registry)
