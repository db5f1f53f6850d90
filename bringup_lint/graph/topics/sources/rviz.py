"""What RViz subscribes, by the configuration that a launch file gives it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.params.loads import path_of

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.parsers.rviz import Display

OPTIONS = ("-d", "--display-config")


class Displays:
    """The RViz configurations of the tree, each read once."""

    def __init__(self, files: Files, launch: Launch) -> None:
        self._files = files
        self._launch = launch
        self._read: dict[str, list[Display]] = {}

    def of(self, started: Started) -> list[Display]:
        """The displays that are switched on; none when the configuration is not in the tree."""
        if literal_text(started.package) != "rviz2" or literal_text(started.executable) != "rviz2":
            return []
        values = list(started.arguments)
        for at, value in enumerate(values[:-1]):
            if text_of(value) in OPTIONS:
                path = path_of(self._launch, values[at + 1])
                return self._at(path) if path is not None else []
        return []

    def _at(self, path: str) -> list[Display]:
        from bringup_lint.parsers.rviz import parse

        if path not in self._read:
            source = self._files.tree.at(path) if self._files.tree.walks(path) else None
            read = self._files.parsed(parse, [source] if source is not None and not source.template else [])
            self._read[path] = read[0] if read else []
        return self._read[path]
