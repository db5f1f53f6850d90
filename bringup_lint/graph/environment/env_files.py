"""The environment files that units read, with who reads them and what else does."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING
from typing import NamedTuple

from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.model.env_file import Entry
from bringup_lint.model.env_file import EnvFile
from bringup_lint.parsers.env_file import parse
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span
from bringup_lint.templates import has_placeholder

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.systemd.units import Units

_LOOKS_LIKE_ENTRY = re.compile(r"^[^\S\n]*(?:export\s+)?[A-Za-z_][A-Za-z0-9_]*=", re.M)


class Reader(NamedTuple):
    """A unit that reads the file, and the word of EnvironmentFile= that says so."""

    unit: Unit
    value: Located


@dataclass(eq=False)
class UsedEnvFile:
    """An environment file that at least one unit reads."""

    files: Files
    units: Units
    model: EnvFile
    readers: list[Reader]

    @property
    def source(self) -> Source:
        return self.model.source

    @property
    def entries(self) -> list[Entry]:
        """The entries that no deployment still fills in."""
        return [entry for entry in self.model.entries if not has_placeholder(entry.value)]

    @cached_property
    def sourced_by(self) -> Source | None:
        """A file of the tree that reads this one with a shell as well."""
        name = re.escape(self.source.basename)
        pattern = re.compile(rf"(?:^|[\s;&'\"(])(?:source|\.)\s+[\"']?[^\s;&|\"']*{name}\b", re.M)
        return next(
            (other for other in self.files.sources if other is not self.source and pattern.search(other.text)),
            None,
        )

    @cached_property
    def docker_run(self) -> Located | None:
        """The word of a ``docker run --env-file`` in an Exec line or script that names this file."""
        for unit in self.units.services:
            for process in self.units.processes(unit):
                for step in process.steps:
                    words = step.command.words
                    if "docker" not in {word.rpartition("/")[2] for word in words}:
                        continue
                    for option, following in zip(words, (*words[1:], None)):
                        path = following if option == "--env-file" else option.part(11, len(option))
                        named = option == "--env-file" or option.startswith("--env-file=")
                        if named and path is not None and self.files.tree.find(path) is self.source:
                            return path
        return None

    def comment(self, entry: Entry) -> Located | None:
        """Text behind the value that was meant as a comment: a blank and ``#`` outside quotes."""
        source = entry.span.source
        start = source.text.index("=", entry.span.start) + 1
        quote = ""
        at = start
        while at < entry.span.end:
            char = source.text[at]
            if char == "\\" and quote != "'":
                at += 1
            elif quote:
                quote = "" if char == quote else quote
            elif char in "'\"" and not source.text[start:at].strip():
                quote = char
            elif char == "#" and source.text[at - 1] in " \t":
                return source.located(at, entry.span.end).strip_located()
            at += 1
        return None

    def blanks_around_equals(self, entry: Entry) -> Iterator[Located]:
        """The blanks before and behind the ``=``."""
        source = entry.span.source
        text = source.text
        equals = text.index("=", entry.name.span.end)
        if equals > entry.name.span.end:
            yield source.located(entry.name.span.end, equals)
        end = equals + 1
        while end < entry.span.end and text[end] in " \t":
            end += 1
        if end > equals + 1 and end < entry.span.end:
            yield source.located(equals + 1, end)

    def swallowed_lines(self, where: Span | Located) -> int:
        """How many lines behind the first one a quoted stretch holds that look like entries of their own."""
        text = where.span.text if isinstance(where, Located) else where.text
        _, _, rest = text.partition("\n")
        return len(_LOOKS_LIKE_ENTRY.findall(rest))


def used_env_files(files: Files, units: Units) -> list[UsedEnvFile]:
    """Every environment file of the tree that a judged unit reads."""
    readers: dict[str, list[Reader]] = {}
    sources: dict[str, Source] = {}
    for unit in units.judged:
        for file in units.environment_files(unit):
            if file.source is not None and file.source.judged:
                sources[file.source.name] = file.source
                readers.setdefault(file.source.name, []).append(Reader(unit, file.value))
    models = files.parsed(parse, sources.values())
    return [UsedEnvFile(files, units, model, readers[model.source.name]) for model in models]
