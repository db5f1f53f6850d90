"""One folder of the workspace: its configuration, its files with what the editor shows of them, and the last run."""

from __future__ import annotations

import os
from collections.abc import Callable
from collections.abc import Mapping
from datetime import date
from typing import Any

from lsprotocol.types import PositionEncodingKind

from bringup_lint.config import Config
from bringup_lint.config import find
from bringup_lint.config import read
from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.dataclass import replace
from bringup_lint.discover.exclude import exclusion
from bringup_lint.discover.held import Held
from bringup_lint.discover.tree import Tree
from bringup_lint.discover.tree import display_name
from bringup_lint.discover.walk import discover
from bringup_lint.engine import run
from bringup_lint.finding.presented import presented
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.registry import Registry
from bringup_lint.robot import Robot
from bringup_lint.server.analysis import Analysis
from bringup_lint.server.analysis import Document
from bringup_lint.server.analysis import of_findings

Known = Callable[[Config], frozenset[str]]
"""The fingerprints in the baseline that a configuration names."""


class State(NamedTuple):
    """What the editor shows at one moment."""

    generation: int
    """That of the folder."""
    documents: Mapping[str, Document]
    """What is open, by its absolute path."""
    encoding: PositionEncodingKind | str = PositionEncodingKind.Utf16


class Stale(Exception):
    """Something has changed since the run began."""


@dataclass(eq=False)
class Folder:
    """A folder of the workspace. ``path`` is absolute. Only the worker's thread runs ``check``."""

    path: str
    registry: Registry
    known: Known
    settings: Mapping[str, Any] = field(default_factory=dict)
    """Settings of the editor, by the names of ``Config``: before those of the configuration file."""
    asked: tuple[str, ...] = ()
    """What is judged, when it is not the whole folder."""
    generation: int = 0
    """Counts the changes."""
    _held: Held = field(default_factory=Held)
    _last: tuple[int, Analysis] | None = None

    def change(self) -> None:
        """Note that a text, a file or the configuration is no longer what it was."""
        self.generation += 1

    @property
    def last(self) -> Analysis | None:
        """The last run, however old."""
        return self._last and self._last[1]

    def check(self, state: State) -> Analysis:
        """What is found with what the editor shows over the files. Raises Stale when that changes before the end, and
        ConfigError."""

        def go_on() -> None:
            if self.generation != state.generation:
                raise Stale

        go_on()
        if self._last is not None and self._last[0] == state.generation:
            return self._last[1]
        os.chdir(self.path)
        config = self._config()
        self._held.texts = {path: document.text for path, document in state.documents.items()}
        tree = self._tree(config)
        purposes = {display_name(config.beside(path)): name for path, name in config.purpose.items()}
        robot = Robot(tree, config.target_ros, config.target_systemd, date.today(), purposes)
        outcome = run(robot, self.registry, config, between=go_on)
        shown = presented(outcome.findings, tree.root or self.path, self.path).findings
        found = of_findings(outcome.findings, shown, self.known(config))
        analysis = Analysis(self.path, robot, found, outcome.rules, state.documents, state.encoding)
        self._last = (state.generation, analysis)
        return analysis

    def _config(self) -> Config:
        path = find(Config().folder)
        config = read(path, named=False) if path else Config()
        return replace(config, **self.settings)

    def _tree(self, config: Config) -> Tree:
        deploy = {config.beside(path): place for path, place in config.deploy.items()}
        opened = () if self.asked else (f"{self.path.rstrip('/')}/",)
        excluded = exclusion(config.folder, config.exclude, opened)
        return discover(self.asked or (self.path,), deploy=deploy, excluded=excluded, held=self._held)
