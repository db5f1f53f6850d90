"""The environment files that units read, with who reads them and what else does."""

from __future__ import annotations

import re
from collections.abc import Iterator
from collections.abc import Sequence
from functools import cached_property

from bringup_lint.dataclass import dataclass
from bringup_lint.graph.memo import memo
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.model.env_file import Entry
from bringup_lint.model.env_file import EnvFile
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.env_file import parse
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span
from bringup_lint.templates import has_placeholder
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.systemd.units import Units

_LOOKS_LIKE_ENTRY = regex(r"^[^\S\n]*(?:export\s+)?[A-Za-z_][A-Za-z0-9_]*=", re.M)


class Reader(NamedTuple):
    """A unit that reads the file, and the word of EnvironmentFile= that says so."""

    unit: Unit
    value: Located


_SOURCED = regex(r"(?:source(?<![^\s;&'\"(]source)|\.(?<![^\s;&'\"(]\.))\s+[\"']?([^\s;&|\"']+)")
"""What is before the word comes after it: so the search jumps from word to word."""


@dataclass(eq=False)
class Mentions:
    """Where else than in ``EnvironmentFile=`` environment files are named, gathered once for all of them."""

    files: Files
    units: Units

    @cached_property
    def sourced(self) -> list[tuple[str, Source]]:
        """What shells read with ``source`` or ``.``, and the file that says so, each pair once."""
        pairs = ((match[1], source) for source in self.files.sources for match in _SOURCED.finditer(source.text))
        return list(dict.fromkeys(pairs))

    @cached_property
    def of_docker(self) -> dict[Source, Located]:
        """Environment file -> the first word that names it."""
        found: dict[Source, Located] = {}
        for unit in self.units.services:
            for process in self.units.processes(unit):
                for step in process.steps:
                    for path in _env_files_of_docker(step.command.words):
                        source = self.files.tree.find(path)
                        if source is not None:
                            found.setdefault(source, path)
        return found


@memo
def _mentions(units: Units, files: Files) -> Mentions:
    return Mentions(files, units)


def _env_files_of_docker(words: Sequence[Located]) -> Iterator[Located]:
    if "docker" not in {word.rpartition("/")[2] for word in words}:
        return
    for option, following in zip(words, (*words[1:], None)):
        if option == "--env-file" and following is not None:
            yield following
        elif option.startswith("--env-file="):
            yield option.part(11, len(option))


@dataclass(eq=False)
class UsedEnvFile:
    """An environment file that at least one unit reads."""

    files: Files
    units: Units
    model: EnvFile
    readers: list[Reader]
    mentions: Mentions

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
        basename, own = self.source.basename, self.source
        sourced = ((word, each) for word, each in self.mentions.sourced if basename in word and each is not own)
        return next((each for word, each in sourced if re.search(rf"{re.escape(basename)}\b", word)), None)

    @property
    def docker_run(self) -> Located | None:
        """The word of a ``docker run --env-file`` in an Exec line or script that names this file."""
        return self.mentions.of_docker.get(self.source)

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


def docker_env_files(files: Files, units: Units) -> list[tuple[EnvFile, Located]]:
    """Every environment file that only a ``docker run`` of a unit reads, and the word that names it."""
    own = {file.source for unit in units.judged for file in units.environment_files(unit)}
    read = {each: word for each, word in _mentions(units, files).of_docker.items() if each.judged and each not in own}
    return [(model, read[model.source]) for model in files.parsed(parse, read)]


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
    mentions = _mentions(units, files)
    return [UsedEnvFile(files, units, model, readers[model.source.name], mentions) for model in models]
