"""Files that a tree keeps and uses no more: a unit that nothing installs while others beside it are, a script of an
image that nothing runs, a Dockerfile that nothing builds, a role that no play takes, the copy of a file in a folder of
documentation, a copy of a compose file whose paths only hold where the other one is, and what a folder of an older
version or an archive holds. What is found there is information.

Only what is plain counts: a folder that is taken as a whole, a name that is put together, and a page that names the
file all use it."""

from __future__ import annotations

import os
from collections.abc import Callable
from functools import cached_property

from bringup_lint.discover.tree import display_name
from bringup_lint.discover.tree import is_below
from bringup_lint.graph.containers.compose import Compose
from bringup_lint.graph.files import Files
from bringup_lint.graph.memo import memo
from bringup_lint.graph.purpose import Purpose
from bringup_lint.graph.purpose import by_path
from bringup_lint.graph.set_aside.compose_copies import MisplacedCopies
from bringup_lint.graph.set_aside.dockerfiles import LeftOverDockerfiles
from bringup_lint.graph.set_aside.pages import CopiedPages
from bringup_lint.graph.set_aside.roles import IdleRoles
from bringup_lint.graph.set_aside.scripts import IdleScripts
from bringup_lint.graph.set_aside.texts import Texts
from bringup_lint.graph.set_aside.units import IdleUnits
from bringup_lint.source import Source

_MOST = 20_000
"""Files of a tree that is looked through."""


class SetAside:
    """Asked for a source: whether the tree keeps it and does not use it."""

    def __init__(self, files: Files, compose: Callable[[], Compose]) -> None:
        self._files = files
        self._texts = Texts(files)
        self._compose = compose

    def has(self, source: Source) -> bool:
        if self._files.tree.root is not None or source.origin is not None or self._files.is_configured(source):
            return False
        is_large = len(self._files.tree.paths) > _MOST
        if self._files.purpose(source) is Purpose.ARCHIVE:
            return not self._is_asked_for(source) and (is_large or not self._is_taken_from_archive(source))
        if is_large:
            return False
        return self._roles.have(source) or self._pages.have(source) or self._is_idle(source)

    def _is_idle(self, source: Source) -> bool:
        if source.kind == "compose":
            return self._compose_copies.have(source)
        if source.kind == "dockerfile":
            return self._dockerfiles.have(source) or self._compose_copies.build(source)
        if source.kind == "systemd-unit":
            return self._units.have(source)
        return source.kind == "shell-script" and self._scripts.have(source)

    def _is_asked_for(self, source: Source) -> bool:
        """Whether the run is for the folder of an archive itself."""
        around = (each for each in self._files.tree.asked if is_below(os.path.dirname(source.absolute), (each,)))
        folders = {folder for each in around for folder in display_name(each).split("/")}
        return any(by_path(f"{folder}/") is Purpose.ARCHIVE for folder in folders)

    @memo
    def _is_taken_from_archive(self, source: Source) -> bool:
        """Whether something that is no page, and outside of the folder, has a file by its path."""
        place = "/".join(self._texts.path_of(source.absolute).split("/")[-2:])
        return any(
            place in each.text and not each.is_page and by_path(each.path) is not Purpose.ARCHIVE
            for each in self._texts.saying(source.basename, source)
        )

    @cached_property
    def _roles(self) -> IdleRoles:
        return IdleRoles(self._files, self._texts)

    @cached_property
    def _pages(self) -> CopiedPages:
        return CopiedPages(self._files, self._texts)

    @cached_property
    def _compose_copies(self) -> MisplacedCopies:
        return MisplacedCopies(self._files, self._texts, self._compose)

    @cached_property
    def _dockerfiles(self) -> LeftOverDockerfiles:
        return LeftOverDockerfiles(self._texts, self._compose)

    @cached_property
    def _units(self) -> IdleUnits:
        return IdleUnits(self._files, self._texts)

    @cached_property
    def _scripts(self) -> IdleScripts:
        return IdleScripts(self._files, self._texts)
