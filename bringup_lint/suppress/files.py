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
from bringup_lint.discover.exclude import exclusion
from bringup_lint.finding import Finding
from bringup_lint.finding import Suppression
from bringup_lint.source import Source
from bringup_lint.source import Span

UNUSED = "lint/unused-ignore"


@dataclass(eq=False)
class Entry:
    """One name for one pattern."""

    pattern: str
    name: str
    matches: Callable[[str], bool]
    """Whether an absolute path is meant."""
    where: Span
    """The pattern in the configuration."""
    used: bool = False


@dataclass(eq=False)
class FileIgnores:
    """All entries of a configuration."""

    entries: tuple[Entry, ...] = ()
    is_name_of: Callable[[str, str], bool] = lambda name, rule: name == rule
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
        context = {os.path.abspath(source.name) for source in sources if not source.judged}
        for entry in self.entries:
            meant = {path for path in walked if entry.matches(path)}
            if not meant:
                yield _complaint(entry, f"The pattern '{entry.pattern}' matches no file")
            elif not entry.used and ran(entry.name) and not meant & context:
                yield _complaint(entry, f"{entry.name} has nothing to silence in '{entry.pattern}'")

    def _matches(self, entry: Entry, path: str) -> bool:
        key = (id(entry), path)
        if key not in self.matched:
            self.matched[key] = entry.matches(os.path.abspath(path))
        return self.matched[key]


def file_ignores(
    table: Mapping[str, Iterable[str]], configuration: Source, is_name_of: Callable[[str, str], bool]
) -> FileIgnores:
    """The entries of a configuration file, whose patterns are relative to its folder."""
    folder = os.path.dirname(os.path.abspath(configuration.name))
    entries = []
    for pattern, names in table.items():
        start = max(configuration.text.find(pattern), 0)
        where = configuration.span(start, start + len(pattern))
        matches = exclusion(folder, [pattern])
        entries += [Entry(pattern, name, matches, where) for name in names]
    return FileIgnores(tuple(entries), is_name_of)


def _complaint(entry: Entry, message: str) -> Finding:
    return Finding(message, entry.where, rule=UNUSED, advice="delete the entry, or correct it")
