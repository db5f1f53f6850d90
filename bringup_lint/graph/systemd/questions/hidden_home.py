"""What a service needs below the homes that ProtectHome= hides from it."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.dataclass import dataclass
from bringup_lint.graph.systemd.directories import Path
from bringup_lint.graph.systemd.directories import paths
from bringup_lint.graph.systemd.sandbox import Sandbox
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.graph.systemd.units import Units
from bringup_lint.pattern import regex
from bringup_lint.source import Located

_BELOW = regex(r"(?<![\w./])/(?:home/[\w.-]+|root)(?:/[\w.@+-]+)*")
_FILE = regex(
    r"(?:file://)?(?P<path>/(?:home/[\w.-]+|root)/[\w.@+/-]+\.(?:ya?ml|xml|json5?|toml|ini|conf|cfg|env|pem|key|crt))"
)
"""A value of the environment that is the path of a file of settings."""
_REOPENING = ("ReadWritePaths", "ReadOnlyPaths", "ExecPaths")


@dataclass(frozen=True)
class HiddenHome:
    """What one ProtectHome= hides."""

    at: Located
    emptied: bool
    """The homes are empty (``tmpfs``), rather than hidden."""
    reopened: list[Path]
    """The entries of path lists that cannot open them again."""
    needed: list[tuple[Located, str]]
    """The words by which the service needs a path below, and the path."""

    @property
    def prevents_start(self) -> bool:
        """Whether an entry of a path list names what is not there."""
        return self.emptied and any(not entry.optional for entry in self.reopened)


def hidden_home(unit: Unit, units: Units) -> HiddenHome | None:
    """What ProtectHome= hides although the unit needs it; None when it hides nothing."""
    box = units.sandbox(unit)
    home = box.protect_home
    if home.at is None or home.value not in ("yes", "tmpfs") or box.own_root:
        return None
    return HiddenHome(
        home.at,
        home.value == "tmpfs",
        [entry for entry in paths(unit, *_REOPENING) if _is_hidden(box, entry.path)],
        [(word, path) for word, path in _needed(unit, units) if _is_hidden(box, path)],
    )


def _is_hidden(box: Sandbox, path: str) -> bool:
    """Whether ProtectHome= has the last word on a path."""
    view = box.view(path)
    if view is None:
        return False
    closed = [each.prefix for each in box.views if each.at is box.protect_home.at]
    if view.at is box.protect_home.at:
        return True
    return view.key in ("ReadWritePaths", "ReadOnlyPaths") and any(path.startswith(f"{home}/") for home in closed)


def _needed(unit: Unit, units: Units) -> Iterator[tuple[Located, str]]:
    """The paths below the homes that the working directory, the environment and the command lines name."""
    folder = unit.get("WorkingDirectory")
    if folder == "~":
        home = unit.identity.home(units.users)
        if folder and home and home.path:
            yield folder, home.path
    elif folder and folder.startswith("/"):
        yield folder, str(folder)
    for variable in units.environment(unit):
        found = _FILE.fullmatch(variable.value)
        if found is not None:
            yield variable.value.part(*found.span("path")), found["path"]
    for process in units.processes(unit):
        for step in process.steps:
            if step.script is None and (step.depth or not process.shell):
                for word in step.command.words:
                    yield from _named(word)


def _named(word: Located) -> Iterator[tuple[Located, str]]:
    if not word.startswith("-") or "=" in word:
        for found in _BELOW.finditer(word):
            yield word.part(*found.span()), found[0]
