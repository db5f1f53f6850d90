"""The folders of one editor window, and the runs over them."""

from __future__ import annotations

import os
from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Mapping
from functools import partial
from typing import Any
from typing import TypeVar

from lsprotocol.types import PositionEncodingKind

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.discover.tree import is_below
from bringup_lint.discover.walk import SKIPPED_FOLDERS
from bringup_lint.registry import Registry
from bringup_lint.server.analysis import Analysis
from bringup_lint.server.analysis import Document
from bringup_lint.server.folder import Folder
from bringup_lint.server.folder import Known
from bringup_lint.server.folder import Stale
from bringup_lint.server.folder import State
from bringup_lint.server.worker import Worker

Answer = TypeVar("Answer")


@dataclass(eq=False)
class Session:
    """Folders by their absolute path. The protocol's thread changes them, and the worker runs over them."""

    worker: Worker
    registry: Registry
    known: Known
    documents: Callable[[], Mapping[str, Document]]
    """What is open in the editor, by its absolute path."""
    encoding: PositionEncodingKind | str = PositionEncodingKind.Utf16
    settings: Mapping[str, Any] = field(default_factory=dict)
    folders: dict[str, Folder] = field(default_factory=dict)
    _alone: dict[str, Folder] = field(default_factory=dict)
    """Folders for open files outside of all folders, by the path of the file."""

    def add(self, paths: Iterable[str]) -> None:
        for path in paths:
            self.folders.setdefault(path, Folder(path, self.registry, self.known, self.settings))

    def remove(self, paths: Iterable[str]) -> None:
        for path in paths:
            folder = self.folders.pop(path, None)
            if folder is not None:
                folder.change()

    def configure(self, settings: Mapping[str, Any]) -> None:
        """Take the settings of the editor."""
        self.settings = settings
        for folder in self.all():
            folder.settings = settings
            folder.change()

    def all(self) -> list[Folder]:
        return [*self.folders.values(), *self._alone.values()]

    def folder_of(self, path: str) -> Folder:
        """The innermost folder that holds a file; for one outside of all, a folder that judges it alone."""
        holding = [folder for folder in self.folders if is_below(path, (folder,))]
        if holding:
            return self.folders[max(holding, key=len)]
        if path not in self._alone:
            place = os.path.dirname(path)
            self._alone[path] = Folder(place, self.registry, self.known, self.settings, asked=(path,))
        return self._alone[path]

    def is_alone(self, path: str) -> bool:
        """Whether a file lies outside of all folders."""
        return path in self._alone

    def is_looked_at(self, path: str) -> bool:
        """Whether a change of a file on the disk can matter: not in a folder that no run enters."""
        return any(is_below(path, (folder,)) for folder in self.folders) and SKIPPED_FOLDERS.isdisjoint(
            path.split(os.sep)
        )

    def forget(self, path: str) -> None:
        """A file is closed: outside of all folders nothing is said of it any more."""
        folder = self._alone.pop(path, None)
        if folder is not None:
            folder.change()

    async def current(self, folder: Folder) -> Analysis:
        """What is found in a folder as it is now. Raises ConfigError, and Stale for a folder that is gone."""
        return await self.ask(folder, lambda analysis: analysis)

    async def ask(self, folder: Folder, question: Callable[[Analysis], Answer]) -> Answer:
        """The answer to a question about a folder as it is now."""
        while True:
            state = State(folder.generation, self.documents(), self.encoding)
            work = partial(_answer, folder, state, question)
            try:
                return await self.worker.do(work)
            except Stale:
                if folder not in self.all():
                    raise


def _answer(folder: Folder, state: State, question: Callable[[Analysis], Answer]) -> Answer:
    return question(folder.check(state))
