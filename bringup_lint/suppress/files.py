"""``[per-file-ignores]`` of the configuration: rules that are silent in some files."""

from __future__ import annotations

import os
from collections.abc import Callable
from collections.abc import Collection
from collections.abc import Iterable
from collections.abc import Iterator
from collections.abc import Mapping

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.dataclass import replace
from bringup_lint.discover.gitignore import Patterns
from bringup_lint.finding import Finding
from bringup_lint.finding import Suppression
from bringup_lint.source import Source
from bringup_lint.source import Span

UNUSED = "lint/unused-ignore"
COMPARED = 2_000_000
"""Pairs of an entry and a file up to which entries without effect are looked for."""


@dataclass(eq=False)
class Entry:
    """One name for one pattern."""

    pattern: str
    name: str
    patterns: Patterns
    where: Span
    """The pattern in the configuration."""
    used: bool = False


@dataclass(eq=False)
class FileIgnores:
    """All entries of a configuration."""

    entries: tuple[Entry, ...] = ()
    is_name_of: Callable[[str, str], bool] = lambda name, rule: name == rule
    folder: str = ""
    """The absolute folder that patterns are relative to."""
    matched: dict[tuple[int, str], bool] = field(default_factory=dict)

    def apply(self, finding: Finding) -> Finding:
        """The finding, with its suppression when an entry silences it."""
        if finding.suppression is not None:
            return finding
        entry = self.entry_for(finding.rule, finding.span.path)
        if entry is None:
            return finding
        reason = f"per-file-ignores of {entry.where.source.basename}"
        return replace(finding, suppression=Suppression(entry.where, reason, external=True))

    def entry_for(self, rule: str, path: str) -> Entry | None:
        """The first entry that silences a rule in a file, which is then in use."""
        for entry in self.entries:
            if self.is_name_of(entry.name, rule) and self._matches(entry, path):
                entry.used = True
                return entry
        return None

    def complaints(
        self, walked: Collection[str], sources: Iterable[Source], ran: Callable[[str], bool]
    ) -> Iterator[Finding]:
        """Entries without effect, where all files were judged that they could mean.

        ``walked`` holds the absolute paths of all files that the run has met.
        """
        configuration = {os.path.abspath(entry.where.path) for entry in self.entries}
        if not configuration <= set(walked):
            return
        below = {path: name for path in walked if (name := self._below(path))}
        if len(below) * len(self.entries) > COMPARED:
            return
        context = {source.absolute for source in sources if not source.judged}
        for entry in self.entries:
            meant = {path for path, name in below.items() if entry.patterns.match(name)}
            if not meant:
                yield _complaint(entry, f"The pattern '{entry.pattern}' matches no file")
            elif not entry.used and ran(entry.name) and not meant & context:
                yield _complaint(entry, f"{entry.name} has nothing to silence in '{entry.pattern}'")

    def _matches(self, entry: Entry, path: str) -> bool:
        key = (id(entry), path)
        if key not in self.matched:
            name = self._below(os.path.abspath(path))
            self.matched[key] = bool(name) and entry.patterns.match(name)
        return self.matched[key]

    def _below(self, path: str) -> str:
        """An absolute path as the patterns see it; empty where they see it not."""
        top = f"{self.folder.rstrip('/')}/"
        return path[len(top) :] if path.startswith(top) else ""


def file_ignores(
    table: Mapping[str, Iterable[str]], configuration: Source, is_name_of: Callable[[str, str], bool]
) -> FileIgnores:
    """The entries of a configuration file, whose patterns are relative to its folder."""
    folder = os.path.dirname(os.path.abspath(configuration.name))
    entries = []
    for pattern, names in table.items():
        start = max(configuration.text.find(pattern), 0)
        where = configuration.span(start, start + len(pattern))
        patterns = Patterns.of([pattern])
        entries += [Entry(pattern, name, patterns, where) for name in dict.fromkeys(names)]
    return FileIgnores(tuple(entries), is_name_of, folder)


def _complaint(entry: Entry, message: str) -> Finding:
    return Finding(message, entry.where, rule=UNUSED, advice="delete the entry, or correct it")
