"""What a service may see and write: the name space that systemd builds for it, systemd.exec(5), "Sandboxing".

Per the systemd source (``src/core/namespace.c``, and tried with 252): ProtectSystem=strict leaves /home,
/root and /run/user as they are, that is for ProtectHome=; what lies below a hidden directory stays hidden,
whatever ReadWritePaths= says.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from bringup_lint.dataclass import dataclass
from bringup_lint.graph.systemd.directories import directories
from bringup_lint.graph.systemd.directories import paths
from bringup_lint.graph.systemd.settings import Setting
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.systemd_values import parse_bool
from bringup_lint.parsers.systemd_values import split_words
from bringup_lint.source import Located
from bringup_lint.type_names import Literal

Mode = Literal["rw", "ro", "hidden", "empty"]
"""What the service can do with a directory; ``empty``: a fresh tmpfs."""
HOMES = ("/home", "/root", "/run/user")
_SYSTEM = {"yes": ("/usr", "/boot", "/efi"), "full": ("/usr", "/boot", "/efi", "/etc"), "strict": ("/",)}
_OPEN_UNDER_STRICT = ("/proc", "/sys", "/dev", *HOMES)
_HOME_MODES: dict[str, Mode] = {"yes": "hidden", "read-only": "ro", "tmpfs": "empty"}
_LISTS: dict[str, Mode] = {"ReadWritePaths": "rw", "ReadOnlyPaths": "ro", "InaccessiblePaths": "hidden"}


class View(NamedTuple):
    """What the service makes of a directory."""

    prefix: str
    mode: Mode
    at: Located | None
    """The value that says so; None when it is implied."""
    key: str
    """The setting that decides, such as ``ProtectHome``."""
    why: str
    """The setting with its value, for people."""


@dataclass(eq=False)
class Sandbox:
    """The file system as one service sees it."""

    unit: Unit

    @property
    def dynamic(self) -> bool:
        return bool(self.unit.identity.dynamic)

    @cached_property
    def protect_system(self) -> Setting[str]:
        found = _word(self.unit, "ProtectSystem", "full", "strict")
        return Setting(found.at, "strict") if self.dynamic else found

    @cached_property
    def protect_home(self) -> Setting[str]:
        found = _word(self.unit, "ProtectHome", "read-only", "tmpfs")
        return Setting(found.at, "read-only") if self.dynamic and found.value in (None, "no") else found

    @cached_property
    def own_root(self) -> bool:
        """Whether the service lives in another root, of which the tree knows nothing."""
        return any(self.unit.get(key) for key in ("RootDirectory", "RootImage"))

    @cached_property
    def views(self) -> list[View]:
        return [
            *self._protected_system(),
            *self._protected_home(),
            *self._private_tmp(),
            *self._listed(),
            *self._mounted("BindPaths", "rw"),
            *self._mounted("BindReadOnlyPaths", "ro"),
            *self._mounted("TemporaryFileSystem", "empty"),
            *(View(path, "rw", None, "Directory", "made by systemd") for path in directories(self.unit)),
        ]

    def _protected_system(self) -> Iterator[View]:
        system = self.protect_system
        why = f"ProtectSystem={system.value}" if system.at else "DynamicUser="
        for prefix in _SYSTEM.get(system.value or "", ()):
            yield View(prefix, "ro", system.at, "ProtectSystem", why)
        if system.value == "strict":
            for prefix in _OPEN_UNDER_STRICT:
                yield View(prefix, "rw", None, "ProtectSystem", "left alone by ProtectSystem=strict")

    def _protected_home(self) -> Iterator[View]:
        home = self.protect_home
        mode = _HOME_MODES.get(home.value or "")
        if mode is not None:
            why = f"ProtectHome={home.value}" if home.at else "DynamicUser="
            yield from (View(prefix, mode, home.at, "ProtectHome", why) for prefix in HOMES)

    def _private_tmp(self) -> Iterator[View]:
        private = _word(self.unit, "PrivateTmp", "disconnected")
        if private.value in ("yes", "disconnected") or self.dynamic:
            yield from (View(prefix, "rw", private.at, "PrivateTmp", "PrivateTmp=") for prefix in ("/tmp", "/var/tmp"))

    def _listed(self) -> Iterator[View]:
        for key, mode in _LISTS.items():
            yield from (View(path, mode, word, key, f"{key}=") for word, path, _ in paths(self.unit, key))

    def _mounted(self, key: str, mode: Mode) -> Iterator[View]:
        for value in self.unit.values(key, self.unit.section):
            for word in split_words(value).words:
                parts = word.lstrip("-").split(":")
                bound = key.startswith("Bind") and len(parts) > 1 and parts[1].startswith("/")
                target = parts[1] if bound else parts[0]
                read_only = key == "TemporaryFileSystem" and "ro" in ":".join(parts[1:]).split(",")
                yield View(target.rstrip("/") or "/", "ro" if read_only else mode, word, key, f"{key}=")

    def view(self, path: str) -> View | None:
        """What decides on a path; None when nothing restricts it."""
        holding = [view for view in self.views if is_below(path, view.prefix)]
        for view in holding:
            if view.mode == "hidden":
                return view
        return max(holding, key=lambda view: len(view.prefix.rstrip("/")), default=None)


def _word(unit: Unit, key: str, *words: str) -> Setting[str]:
    """A boolean setting that takes other words too."""

    def read(text: str) -> str | None:
        if text in words:
            return text
        found = parse_bool(text)
        return None if found is None else "yes" if found else "no"

    return unit.setting(read, key, section=unit.section)


def is_below(path: str, prefix: str) -> bool:
    """Whether a path is a directory, or lies in it."""
    return prefix == "/" or path == prefix or path.startswith(f"{prefix}/")
