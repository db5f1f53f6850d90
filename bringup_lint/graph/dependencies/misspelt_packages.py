"""Packages whose folder or nodes are asked for by a name that nobody has, and that is nearly the name of one."""

from __future__ import annotations

import re
from collections.abc import Callable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.released import near_current
from bringup_lint.facts.ros.released import released
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.spelling import Neighbours
from bringup_lint.spelling import numbered

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.workspace import Workspace

_LAUNCH = ("launch-python", "launch-xml", "launch-yaml")
_KINDS = (*_LAUNCH, "python-node", "cpp-node", "urdf")
_LOOKED_UP = regex(
    r"(?:get_package_share_(?:directory|path)|get_package_prefix|FindPackage(?:Share|Prefix))"
    r"[ \t]{0,4}\(\s{0,80}(?:package(?:_name)?\s{0,8}=\s{0,8})?[\"']([A-Za-z]\w{5,80})[\"']"
    r"|\$\((?:find-pkg-(?:share|prefix)|find)[ \t]{1,8}([A-Za-z]\w{5,80})[ \t]{0,8}\)",
    hints="get_package_ FindPackage $(find",
)
_STARTED = regex(
    r"(?<![\w-])package[ \t]{0,4}=\s{0,80}[\"']([A-Za-z]\w{5,80})[\"'](?=\s{0,80}[,)])"
    r"|(?<![\w-])pkg[ \t]{0,4}[=:][ \t]{0,4}[\"']?([A-Za-z]\w{5,80})(?![\w$({/.-])",
    hints="package pkg",
)
_PLACEHOLDER = regex(r"^(?:your|my)_|(?:^|_)(?:package|pkg)_name$|_name_here$")
_SHORTEST = 6


class MisspeltPackage(NamedTuple):
    name: Located
    meant: str
    place: Located | None
    """Where the package is declared or has its name; None of one that the tables know."""
    is_launch: bool
    """A launch file asks, which aborts."""


def misspelt_packages(files: Files, launch: Launch, is_fetched: Callable[[str], bool]) -> Iterator[MisspeltPackage]:
    """Each place once. ``is_fetched``: whether a list of repositories names a package."""
    known = _Known(launch.workspace)
    if launch.workspace.packages:
        for source in files.of_kind(*_KINDS):
            if source.judged:
                yield from _of_source(known, is_fetched, source)


def _of_source(known: _Known, is_fetched: Callable[[str], bool], source: Source) -> Iterator[MisspeltPackage]:
    is_launch = source.kind in _LAUNCH
    for name in asked(source, (_LOOKED_UP, _STARTED) if is_launch else (_LOOKED_UP,)):
        meant = known.meant(name)
        if meant is not None and not is_fetched(str(name)) and not _is_remark(name):
            yield MisspeltPackage(name, str(meant), meant if isinstance(meant, Located) else None, is_launch)


def asked(source: Source, patterns: tuple[re.Pattern[str], ...]) -> Iterator[Located]:
    for pattern in patterns:
        for match in pattern.finditer(source.said):
            group = match.lastindex or 0
            yield source.located(match.start(group), match.end(group))


def _is_remark(name: Located) -> bool:
    source, start = name.span.source, name.span.start
    before = source.line_before(start)
    if before.lstrip().startswith(("#", "//", "*")) or "# " in before:
        return True
    return source.text.rfind("<!--", 0, start) > source.text.rfind("-->", 0, start)


class _Known:
    """Which packages there are, as far as the tree and the tables know."""

    def __init__(self, workspace: Workspace) -> None:
        self._workspace = workspace
        depends = (name for package in workspace.packages.values() for _, name in package.manifest.depends)
        self._declared = {str(name): name for name in depends}
        self._names = {*workspace.packages, *workspace.ambiguous, *self._declared, *released()}
        self._own = Neighbours((*workspace.packages, *self._declared))
        self._meant: dict[str, Located | str | None] = {}

    def meant(self, name: Located) -> Located | str | None:
        """The one package whose name is a letter away."""
        text = str(name)
        if text not in self._meant:
            self._meant[text] = None if text in self._names else self._nearest(text)
        return self._meant[text]

    def _nearest(self, name: str) -> Located | str | None:
        if len(name) < _SHORTEST or _PLACEHOLDER.search(name):
            return None
        found = dict.fromkeys((*self._own.meant(name), *near_current().meant(name)))
        near = [each for each in found if each[0] == name[0] and not numbered(each, name)]
        if len(near) != 1:
            return None
        package = self._workspace.packages.get(near[0])
        return package.manifest.name if package is not None else self._declared.get(near[0], near[0])
