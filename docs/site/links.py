"""Links that are written for a reader of the repository, turned into links of the site."""

from __future__ import annotations

import posixpath
import re

REPOSITORY = "https://github.com/bringup-lint/bringup-lint/blob/main/"
_LINK = re.compile(r"(?<=\]\()(?!https?:|#|mailto:|/)([^)#\s]+)")
_RULE = re.compile(r"rules/([a-z0-9_]+)/([a-z0-9_]+)\.py")
_PAGES = {"README.md": "index.md", "CONTRIBUTING.md": "contributing.md", "CHANGELOG.md": "changelog.md"}
"""Files at the top of the repository that are pages of the site."""
_SHOWN = (".md", ".svg", ".png", ".json", ".toml")


def rewritten(markdown: str) -> str:
    """The text of a page in ``docs/``."""
    return _LINK.sub(lambda link: _target(posixpath.normpath(f"docs/{link[1]}")), markdown)


def from_the_top(markdown: str) -> str:
    """The text of a page at the top of the repository."""
    return _LINK.sub(lambda link: _target(posixpath.normpath(link[1])), markdown)


def _target(path: str) -> str:
    """Where the site has a file of the repository, or the repository itself."""
    rule = _RULE.fullmatch(path)
    if rule:
        return f"rules/{rule[1]}/{rule[2]}.md".replace("_", "-")
    if path in _PAGES:
        return _PAGES[path]
    if path in ("docs", "docs/README.md"):
        return "contents.md"
    if path.startswith("docs/") and path.endswith(_SHOWN) and not path.startswith(("docs/example/", "docs/observed/")):
        return path.removeprefix("docs/")
    return REPOSITORY + path
