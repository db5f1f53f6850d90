"""The directories that systemd makes for a unit, and the paths that its settings name."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.systemd_values import expand
from bringup_lint.parsers.systemd_values import split_words
from bringup_lint.parsers.systemd_values import unit_specifiers
from bringup_lint.source import Located

DIRECTORIES = {
    "RuntimeDirectory": "/run",
    "StateDirectory": "/var/lib",
    "CacheDirectory": "/var/cache",
    "LogsDirectory": "/var/log",
    "ConfigurationDirectory": "/etc",
}
"""What systemd makes for a unit, and where; systemd.exec(5)."""


class Path(NamedTuple):
    """One entry of a path list."""

    word: Located
    path: str
    optional: bool
    """It has a ``-``: a missing path is ignored."""


def absolute(word: Located, unit: Unit) -> str | None:
    """A path of a unit file with its specifiers replaced; None when it is not known."""
    path = expand(word, unit_specifiers(unit.name))
    return posixpath.normpath(path) if path and path.startswith("/") and "$" not in path else None


def directories(unit: Unit) -> Iterator[str]:
    """The directories that systemd makes for a unit."""
    for key, base in DIRECTORIES.items():
        for value in unit.values(key, unit.section):
            for word in split_words(value).words:
                name = expand(word.partition(":")[0], unit_specifiers(unit.name))
                if name:
                    yield f"{base}/{name}".rstrip("/")


def line_to_create(path: str) -> str | None:
    """The setting with which systemd makes a directory for a unit; None where it makes none."""
    found = ((key, path.removeprefix(f"{base}/")) for key, base in DIRECTORIES.items() if base != "/etc")
    return next((f"{key}={name}" for key, name in found if name != path), None)


def paths(unit: Unit, *keys: str) -> Iterator[Path]:
    """The paths of list settings such as ReadWritePaths=; for bind mounts the source."""
    for key in keys:
        for value in unit.values(key, unit.section):
            if unit.is_opaque(value):
                continue
            for word in split_words(value).words:
                bare = word.lstrip("+-")
                name = word.part(len(word) - len(bare), len(word))
                colon = name.find(":") if key.startswith("Bind") else -1
                path = absolute(name if colon < 0 else name.part(0, colon), unit)
                if path is not None:
                    yield Path(word, path, "-" in word[: len(word) - len(bare)])
