"""Which diagnostics an editor has, and which it needs: pushed to one that does not ask, ready for one that does."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from collections.abc import Mapping
from hashlib import blake2b

from lsprotocol.types import Diagnostic
from lsprotocol.types import PublishDiagnosticsParams

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.server.analysis import Document
from bringup_lint.server.analysis import uri_of
from bringup_lint.server.folder import Folder

DEBOUNCE = 0.02
"""Seconds after the last change before a run begins that nobody asked for."""


@dataclass(eq=False)
class Published:
    """What was pushed, by folder and path."""

    push: Callable[[PublishDiagnosticsParams], None]
    documents: Callable[[], Mapping[str, Document]]
    _shown: dict[Folder, dict[str, list[Diagnostic]]] = field(default_factory=dict)

    def show(self, folder: Folder, found: dict[str, list[Diagnostic]]) -> None:
        """Push what has changed in a folder, and take back what is no longer found."""
        before = self._shown.get(folder, {})
        documents = self.documents()
        for path in sorted(before.keys() | found.keys()):
            items = found.get(path, [])
            if items != before.get(path, []):
                document = documents.get(path) or Document(uri_of(path), "")
                self.push(PublishDiagnosticsParams(document.uri, items, document.version))
        self._shown[folder] = found

    def forget(self, folder: Folder) -> None:
        """Take back all that was found in a folder."""
        self.show(folder, {})
        del self._shown[folder]


class Timers:
    """One run a folder at a time, some time after the last change."""

    def __init__(self, start: Callable[[Folder], None]) -> None:
        self._start = start
        self._waiting: dict[Folder, asyncio.TimerHandle] = {}

    def restart(self, folder: Folder) -> None:
        waiting = self._waiting.pop(folder, None)
        if waiting is not None:
            waiting.cancel()
        self._waiting[folder] = asyncio.get_running_loop().call_later(DEBOUNCE, self._start, folder)


def result_id(items: list[Diagnostic]) -> str:
    """The same for the same diagnostics."""
    return blake2b(repr(items).encode("utf-8", "surrogatepass"), digest_size=12).hexdigest()
