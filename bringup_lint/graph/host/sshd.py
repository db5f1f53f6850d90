"""What sshd does with its configuration: the first value of a keyword wins, an Include counts where it is."""

from __future__ import annotations

import fnmatch
from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.model.sshd import Match
from bringup_lint.model.sshd import Option
from bringup_lint.model.sshd import SshdFile
from bringup_lint.parsers.sshd import keyword_of
from bringup_lint.parsers.sshd import keywords
from bringup_lint.parsers.sshd import parse
from bringup_lint.parsers.sshd_values import algorithms
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files

Resolve = Callable[[str], Iterable[Source]]

COLLECTED = frozenset(
    [
        "Port",
        "ListenAddress",
        "HostKey",
        "HostCertificate",
        "AllowUsers",
        "DenyUsers",
        "AllowGroups",
        "DenyGroups",
        "AcceptEnv",
        "Subsystem",
        "Include",
        "Match",
        "MaxStartups",
        "PerSourceMaxStartups",
        "PerSourceNetBlockSize",
        "IPQoS",
        "StreamLocalBindMask",
        "FingerprintHash",
        "PermitOpen",
        "PermitListen",
    ]
)
"""Keywords whose lines add up, or whose last line wins."""
_DEEPEST = 16
_FILE = regex(r"(?:^|/)ssh/sshd_config(?:\.d/[^/]+\.conf)?$")


@dataclass(eq=False)
class Sshd:
    """The configuration of one sshd."""

    main: SshdFile | None = None
    """sshd_config; None when the tree holds only drop-ins for the distribution's."""
    dropins: list[SshdFile] = field(default_factory=list)
    options: list[Option] = field(default_factory=list)
    """In the order in which sshd meets them, with the included ones in place."""
    complete: bool = True
    """Whether every Include could be followed."""

    @property
    def files(self) -> list[SshdFile]:
        """The judged files that are not templates."""
        return [
            file
            for file in (*filter(None, [self.main]), *self.dropins)
            if file.source.judged and not file.source.template
        ]

    @property
    def problems(self) -> Iterator[Problem]:
        """What the parser says of the judged files."""
        for file in self.files:
            yield from file.problems

    @property
    def is_whole(self) -> bool:
        """Whether a keyword that is not set has its default."""
        return self.main is not None and not self.main.source.template and self.complete

    def get(self, name: str) -> Option | None:
        """The line that counts for every connection."""
        return next((option for option in self.options if option.name == name and option.everywhere), None)

    def all(self, name: str) -> list[Option]:
        return [option for option in self.options if option.name == name]

    def says(self, name: str, default: str) -> str | None:
        """The effective value in small letters; None when it is not known."""
        option = self.get(name)
        if option is not None:
            return str(option.value).lower()
        return default if self.is_whole else None

    @property
    def where(self) -> Source:
        """What a finding about something that is not set points at."""
        return self.main.source if self.main else self.dropins[0].source

    @property
    def keywords(self) -> list[str]:
        """The keywords that sshd knows."""
        return list(keywords())

    def overridden(self) -> Iterator[tuple[Option, Option]]:
        """Lines that lose against an earlier one with another value: the line, and the one that wins."""
        first: dict[str, Option] = {}
        for option in self.options:
            if option.name in COLLECTED or not option.everywhere or keyword_of(option.keyword) is None:
                continue
            winner = first.setdefault(option.name, option)
            if [str(word).lower() for word in winner.arguments] != [str(word).lower() for word in option.arguments]:
                yield option, winner

    def weak_algorithms(self) -> Iterator[Located]:
        """The words of Ciphers, MACs and the like that switch something weak on."""
        kinds = {known.name: known.type for known in keywords().values()}
        for option in self.options:
            kind = kinds.get(option.name)
            if kind in ("cipher", "mac", "kex", "keys") and not option.value.startswith("-"):
                offset = option.value[:1] in ("+", "^")
                at = int(offset)
                for name in str(option.value)[at:].split(","):
                    if algorithms(kind).get(name):
                        yield option.value.part(at, at + len(name))
                    at += len(name) + 1


def effective(sources: list[Source], resolve: Resolve) -> Sshd:
    """sshd_config, or drop-ins alone, with everything that they include."""
    sshd = Sshd()
    for source in sources:
        sshd.options += _read(sshd, parse(source), resolve, 0, None)
    return sshd


def _read(sshd: Sshd, file: SshdFile, resolve: Resolve, depth: int, match: Match | None) -> Iterator[Option]:
    for option in file.options:
        if option.name == "Include" and depth < _DEEPEST:
            for pattern in option.arguments:
                found = list(resolve(pattern))
                inner = option.match or match
                for source in found:
                    yield from _read(sshd, parse(source), resolve, depth + 1, inner)
        else:
            yield option if option.match or match is None else option._replace(match=match)


def load_sshd(files: Files) -> list[Sshd]:
    """One Sshd for each folder that holds sshd_config or a sshd_config.d."""
    folders: dict[str, tuple[list[Source], list[Source]]] = {}
    for source in files.of_kind("sshd-config"):
        folder = f"/{source.name}".rpartition("/")[0]
        dropin = folder.endswith("/sshd_config.d")
        mains, dropins = folders.setdefault(folder.removesuffix("/sshd_config.d"), ([], []))
        (dropins if dropin else mains).append(source)
    return [_joined(files, *group) for group in folders.values()]


def _joined(files: Files, mains: list[Source], dropins: list[Source]) -> Sshd:
    complete = len(mains) == 1

    def resolve(pattern: str) -> Iterable[Source]:
        nonlocal complete
        folder, _, names = str(pattern).rpartition("/")
        if not folder.endswith("sshd_config.d"):
            complete = False
            return []
        found = [source for source in dropins if fnmatch.fnmatchcase(source.basename, names)]
        return sorted(found, key=lambda source: source.basename)

    ordered = sorted(dropins, key=lambda source: source.basename)
    sshd = effective(mains[:1] or ordered, resolve)
    sshd.complete = complete
    sshd.main = parse(mains[0]) if mains else None
    sshd.dropins = files.parsed(parse, ordered)
    return sshd


def sshd_sources(files: Files) -> list[Source]:
    """The sshd configuration of the tree: the main file and its drop-ins."""
    known = [source for source in files.sources if _FILE.search(source.name)]
    main = files.tree.find("/etc/ssh/sshd_config")
    return known if main is None or main in known else [*known, main]
