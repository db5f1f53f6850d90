"""Which parameter files something of the tree names."""

from __future__ import annotations

import os
from collections.abc import Callable
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.graph.memo import memo
from bringup_lint.graph.params.composed_names import ComposedNames
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.params.mentions import Mentions
    from bringup_lint.graph.workspace import Package
    from bringup_lint.source import Source

BUILD = ("params", "cmake", "setup-py", "setup-cfg", "ros-package")
"""Kinds that may name a parameter file without loading it."""
_FILE_NAME = regex(r"[\w.-]+")


@dataclass(eq=False)
class Naming:
    """What names files: launch files, and any other text but those that build or install."""

    files: Files
    launch: Callable[[], Launch]

    def is_elsewhere(self, name: str, known: set[Source]) -> bool:
        """Whether a file other than the known ones and those that only build or install mentions a name."""
        return self._mentions(len(self.files.sources)).outside(name, known)

    @memo
    def _mentions(self, count: int) -> Mentions:
        """By the number of sources, to which some come later."""
        from bringup_lint.graph.params.mentions import Mentions

        return Mentions([each for each in self.files.sources if each.kind not in BUILD])

    def is_named(self, source: Source) -> bool:
        """Whether a launch file hands the path of a file on, or takes any of its folder by argument, or something names
        it, and means no other one of its name."""
        if source.absolute in self._handed_on or os.path.dirname(source.absolute) in self._chosen_from:
            return True
        same = list(self.files.tree.named(source.basename))
        if len(same) == 1 and self.is_elsewhere(source.basename, {source}):
            return True
        return self._is_named_in_package(source, same)

    def _is_named_in_package(self, source: Source, same: list[str]) -> bool:
        """Whether a launch file of the package of a file names it, and the package has no other one of its name, or
        puts its name together."""
        launch = self.launch() if self.files.of_kind(*LAUNCH) else None
        owner = launch.workspace.owner(source) if launch is not None else None
        if launch is None or owner is None:
            return False
        path = os.path.relpath(source.absolute, owner.folder)
        if self._composed(owner).has(path):
            return True
        owners = [launch.workspace.package_of(os.path.dirname(os.path.abspath(path))) for path in same]
        if sum(each is owner for each in owners) != 1:
            return False
        return source.basename in self._named_by(owner)

    @memo
    def _composed(self, owner: Package) -> ComposedNames:
        """The names that the launch files of a package put together."""
        return ComposedNames(each.source.uncommented for each in self.launch().files_of(owner))

    @memo
    def _named_by(self, owner: Package) -> frozenset[str]:
        """The names of files that the launch files of a package hold."""
        texts = (each.source.uncommented for each in self.launch().files_of(owner))
        return frozenset(word for text in texts for word in _FILE_NAME.findall(text))

    @cached_property
    def _handed_on(self) -> frozenset[str]:
        """The files of the tree that launch files name as values of arguments, and so give to what they include."""
        if not self.files.of_kind(*LAUNCH):
            return frozenset()
        launch = self.launch()
        named = (each for file in launch.judged for each in launch.references(file) if each.kind == "path" and each.key)
        return frozenset(os.path.abspath(each.found.file) for each in named if each.found.file is not None)

    @cached_property
    def _chosen_from(self) -> frozenset[str]:
        if not self.files.of_kind(*LAUNCH):
            return frozenset()
        from bringup_lint.graph.params.chosen_folders import chosen_folders

        return frozenset(chosen_folders(self.launch()))
