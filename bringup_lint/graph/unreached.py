"""Files of a tree to which nothing of the robot's own leads: in the copy of a package that others wrote, of which the
robot's own files use another part or nothing. What is found there is information."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from itertools import chain

from bringup_lint.dataclass import dataclass
from bringup_lint.graph.files import Files
from bringup_lint.graph.words import named
from bringup_lint.graph.words import words
from bringup_lint.pattern import regex
from bringup_lint.source import Source
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.copies import Copies

_BUILDING = ("ros-package", "cmake", "setup-py", "setup-cfg")
"""Kinds that colcon reads, whatever the robot uses."""
_CODE = ("python-node", "cpp-node", "cpp-driver")
"""Kinds that are used with their package: which files a program is made of is not asked."""
_PAGE = regex(r"(?i)(?:\.(?:md|rst|txt|repos|rosinstall|mk|just)|(?:^|/)(?:makefile|justfile|procfile))$")
_SIZE = 200_000
"""How much is read of a page."""
_DEVICE = regex(r"/dev/([\w.-]+)")
_LINKS = regex(r"""SYMLINK\s*\+?=\s*\\?["']([^"'\\]*)""")
"""The links of a udev rule, also of one that a script writes."""


class Reached:
    """What the own files of a tree lead to in the copies that it carries: where a text names a package, and a file by
    the words that the text holds. Files that are reached so lead on."""

    def __init__(self, files: Files, copies: Copies) -> None:
        self._files = files
        self._copies = copies
        self.packages: set[str] = set()
        """The folders of packages that are named."""
        self.paths: set[str] = set()
        """The absolute paths of files that are named beside their package."""
        self.devices: set[str] = set()
        """What of ``/dev`` is named."""
        own = (each.text for each in files.sources if not copies.has(each.absolute))
        todo: list[tuple[str, str | None]] = [(text, None) for text in chain(own, self._pages())]
        while todo:
            text, folder = todo.pop()
            todo += self._led_to(text, folder)

    def _pages(self) -> Iterator[str]:
        """The pages and lists of packages that the tree's own people wrote."""
        tree = self._files.tree
        for path in tree.like(_PAGE):
            if not self._copies.has(path):
                yield tree.head(path, _SIZE)

    def _led_to(self, text: str, own: str | None) -> Iterator[tuple[str, str | None]]:
        """The texts to which one leads, which is of a file of the copy ``own``."""
        self.devices.update(_DEVICE.findall(text))
        here = words(text)
        folders = {folder for name in self._by_name.keys() & here for folder in self._by_name[name]}
        for folder in folders | ({own} if own else set()):
            if folder not in self.packages:
                self.packages.add(folder)
                yield self._copies.found[folder].source.text, None
            left = self._left.get(folder, {})
            for name in list(named(left, here)):
                for source in left.pop(name):
                    self.paths.add(source.absolute)
                    yield source.text, folder

    @cached_property
    def _by_name(self) -> dict[str, list[str]]:
        """Word -> the folders of the copies that it may mean."""
        found: dict[str, list[str]] = {}
        for folder in self._copies.found:
            for name in self._copies.names(folder):
                found.setdefault(name, []).append(folder)
        return found

    @cached_property
    def _left(self) -> dict[str, dict[str, list[Source]]]:
        """Folder of a copy -> name of a file -> the files that nothing led to so far."""
        found: dict[str, dict[str, list[Source]]] = {}
        for source in self._files.sources:
            folder = self._copies.owner(source)
            if folder is not None and source.kind not in _BUILDING:
                found.setdefault(folder, {}).setdefault(source.basename, []).append(source)
        return found


@dataclass(eq=False)
class Unreached:
    files: Files

    def has(self, source: Source) -> bool:
        """Whether nothing leads to a file. The configuration may say that it is the robot's."""
        if self.files.is_configured(source) or source.kind in _BUILDING:
            return False
        folder = self._copies.owner(source)
        if folder is None:
            return False
        if source.kind in _CODE:
            return folder not in self._reached.packages
        return source.absolute not in self._reached.paths and not self._makes_links(source)

    def _makes_links(self, source: Source) -> bool:
        """Whether a file has udev rules for a link that something else opens."""
        links = {link for links in _LINKS.findall(source.text) for link in links.split()}
        return not self._reached.devices.isdisjoint(links)

    @cached_property
    def _copies(self) -> Copies:
        from bringup_lint.graph.copies import Copies

        return Copies(self.files)

    @cached_property
    def _reached(self) -> Reached:
        return Reached(self.files, self._copies)
