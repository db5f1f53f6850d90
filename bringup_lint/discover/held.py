"""What a process that runs many times holds between the runs: unsaved texts, and the sources of the run before."""

from __future__ import annotations

from collections.abc import Mapping

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.source import Source

_BOM = "\ufeff"


@dataclass(eq=False)
class Held:
    """Texts over the files of a tree, and the sources that a run shares with the one before."""

    texts: Mapping[str, str] = field(default_factory=dict)
    """Absolute path -> the text that an editor shows, and has not necessarily saved."""
    _sources: dict[tuple[str, str, bool], Source] = field(default_factory=dict)

    def shared(self, source: Source) -> Source:
        """The source of the run before, with its models, when nothing about it has changed; else this one."""
        key = (source.name, source.kind, source.judged)
        before = self._sources.get(key)
        if before is not None and _facts(before) == _facts(source):
            return before
        source.models = {}
        self._sources[key] = source
        return source


def over(on_disk: str, shown: str) -> str:
    """What an editor shows of a file, with the byte order mark that is there and not shown."""
    return _BOM + shown if on_disk.startswith(_BOM) and not shown.startswith(_BOM) else shown


def _facts(source: Source) -> tuple[object, ...]:
    return (source.text, source.robot_path, source.template, source.mode, source.link, source.uid, source.gid)
