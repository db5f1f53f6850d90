"""What the files of a tree say that may use others."""

from __future__ import annotations

import os
from collections.abc import Iterator
from functools import cached_property

from bringup_lint.graph.files import Files
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Source

_USERS = regex(
    r"(?i)(?:\.(?:mk|just|kdl|desktop|j2|jinja2?|in|ya?ml|json|toml|xml|cfg|ini|conf|sh|bash|zsh|bats|plist|lua|ps1"
    r"|py|m?js|ts|tsx|php|rb|go|rs|c|cc|cpp|hpp|h|cmake|nix|bb|bbappend|spec|install|postinst|preinst|m4|rules|md|rst|txt"
    r"|adoc|html|ipynb|service|target|timer)|/[\w-]+)$"
)
"""Files that may use others, or say to people how to."""
_REMARK = regex(r"(?m)^[ \t]*(?:#(?!!)|//|\*(?=[ \t/*])|<!--)[^\n]*")
_DRAWING = regex(r"(?m)^[^\n\w]{0,40}[├└│][^\n]*")
"""Of folders."""
_PAGE = regex(r"(?i)\.(?:md|rst|txt|adoc)$")
"""Texts for people, in which a heading and an item of a list are no comments."""
_SIZE = 200_000
"""How much is read of a file."""
FEWEST = 2
"""Files beside one that are used, at least: of two, each may be for another machine."""
WORD = regex(r"[\w@](?:[\w.@-]*[\w@-])?")


class Text(NamedTuple):
    path: str
    text: str

    @property
    def is_page(self) -> bool:
        """Whether it is for people."""
        return _PAGE.search(self.path) is not None


class Texts:
    """The texts of a tree without their comments, and where each word of them is."""

    def __init__(self, files: Files) -> None:
        self._files = files

    @cached_property
    def all(self) -> list[Text]:
        """What files say that may use others, but for their comments."""
        tree = self._files.tree
        known = {source.absolute: source for source in self._files.sources if source.origin is None}
        texts = {path: source.text for path, source in known.items()}
        texts.update({path: tree.head(path, _SIZE) for path in tree.like(_USERS) if path not in known})
        return [Text(self.path_of(path), _said(path, text)) for path, text in texts.items()]

    @cached_property
    def by_word(self) -> dict[str, list[Text]]:
        found: dict[str, list[Text]] = {}
        for each in self.all:
            for word in set(WORD.findall(each.text)):
                found.setdefault(word, []).append(each)
        return found

    @cached_property
    def by_folder(self) -> dict[str, list[Text]]:
        found: dict[str, list[Text]] = {}
        for each in self.all:
            found.setdefault(os.path.dirname(each.path), []).append(each)
        return found

    def saying(self, word: str, source: Source) -> Iterator[Text]:
        """The texts that have a word, but for the file itself."""
        own = self.path_of(source.absolute)
        return (each for each in self.by_word.get(word, ()) if each.path != own)

    def path_of(self, absolute: str) -> str:
        return absolute.removeprefix(self.top)

    @cached_property
    def top(self) -> str:
        folders = {os.path.dirname(os.path.abspath(each)) for each in self._files.tree.paths}
        return f"{os.path.commonpath(folders).rstrip('/')}/" if folders else "/"


def is_copy(text: str, other: str) -> bool:
    """Whether most lines of a text are those of another one."""
    lines, others = set(text.split("\n")), set(other.split("\n"))
    return len(lines & others) * 2 > len(lines)


def _said(path: str, text: str) -> str:
    """A text without comments and drawings of folders."""
    text = _DRAWING.sub("", text)
    return text if _PAGE.search(path) else _REMARK.sub("", text)
