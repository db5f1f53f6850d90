"""What a service may see and write: the name space that systemd builds for it, systemd.exec(5), "Sandboxing".

Per the systemd source (``src/core/namespace.c``, and tried with 252): ProtectSystem=strict leaves /home,
/root and /run/user as they are, that is for ProtectHome=; what lies below a hidden directory stays hidden,
whatever ReadWritePaths= says.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING
from typing import NamedTuple

from bringup_lint.graph.commands.environment import Environment
from bringup_lint.graph.systemd.environment import process_environment
from bringup_lint.graph.systemd.filesystem import absolute
from bringup_lint.graph.systemd.filesystem import directories
from bringup_lint.graph.systemd.process import Process
from bringup_lint.graph.systemd.settings import Setting
from bringup_lint.graph.systemd.settings import flag
from bringup_lint.graph.systemd.settings import setting
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.parsers.systemd_values import parse_bool
from bringup_lint.parsers.systemd_values import split_words
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.robot import Robot

HOMES = ("/home", "/root", "/run/user")
_SYSTEM = {"yes": ("/usr", "/boot", "/efi"), "full": ("/usr", "/boot", "/efi", "/etc"), "strict": ("/",)}
_OPEN_UNDER_STRICT = ("/proc", "/sys", "/dev", *HOMES)


class Path(NamedTuple):
    """One entry of a path list."""

    word: Located
    path: str
    optional: bool
    """It has a ``-``: a missing path is ignored."""


class View(NamedTuple):
    """What the service makes of a directory."""

    prefix: str
    mode: str
    """``rw``, ``ro``, ``hidden`` or ``empty`` (a fresh tmpfs)."""
    at: Located | None
    """The value that says so; None when it is implied."""
    why: str


class LogDirectory(NamedTuple):
    """Where rcl writes its logs: ROS_LOG_DIR, else ROS_HOME/log, else ~/.ros/log."""

    path: str | None
    """None: nowhere, there is no home."""
    why: str
    at: Located | None


def _word(unit: Unit, key: str, *words: str) -> Setting:
    def read(text: str) -> str | None:
        if text in words:
            return text
        found = parse_bool(text)
        return None if found is None else "yes" if found else "no"

    return setting(unit, read, (key, unit.section))


def paths(unit: Unit, *keys: str) -> Iterator[Path]:
    """The paths of list settings such as ReadWritePaths=; for bind mounts the source."""
    for key in keys:
        for value in unit.values(key, unit.section):
            for word in split_words(value).words if not unit.is_opaque(value) else ():
                bare = word.lstrip("+-")
                name = word.part(len(word) - len(bare), len(word))
                colon = name.find(":") if key.startswith("Bind") else -1
                path = absolute(name if colon < 0 else name.part(0, colon), unit)
                if path is not None:
                    yield Path(word, path, "-" in word[: len(word) - len(bare)])


@dataclass(eq=False)
class Sandbox:
    """The file system as one service sees it."""

    unit: Unit
    robot: Robot

    @cached_property
    def dynamic(self) -> bool:
        return bool(flag(self.unit, "DynamicUser").value)

    @cached_property
    def protect_system(self) -> Setting:
        found = _word(self.unit, "ProtectSystem", "full", "strict")
        return Setting(found.at, "strict") if self.dynamic else found

    @cached_property
    def protect_home(self) -> Setting:
        found = _word(self.unit, "ProtectHome", "read-only", "tmpfs")
        return Setting(found.at, "read-only") if self.dynamic and found.value in (None, "no") else found

    @cached_property
    def own_root(self) -> bool:
        """Whether the service lives in another root, of which the tree knows nothing."""
        return any(self.unit.get(key) for key in ("RootDirectory", "RootImage"))

    @cached_property
    def views(self) -> list[View]:
        return list(self._views())

    def _views(self) -> Iterator[View]:
        system, home = self.protect_system, self.protect_home
        for prefix in _SYSTEM.get(system.value, ()):
            yield View(prefix, "ro", system.at, f"ProtectSystem={system.value}" if system.at else "DynamicUser=")
        if system.value == "strict":
            yield from (View(prefix, "rw", None, "left alone by ProtectSystem=strict") for prefix in _OPEN_UNDER_STRICT)
        mode = {"yes": "hidden", "read-only": "ro", "tmpfs": "empty"}.get(home.value)
        for prefix in HOMES if mode else ():
            yield View(prefix, mode, home.at, f"ProtectHome={home.value}" if home.at else "DynamicUser=")
        private = flag(self.unit, "PrivateTmp")
        if private.value or self.dynamic:
            yield from (View(prefix, "rw", private.at, "PrivateTmp=") for prefix in ("/tmp", "/var/tmp"))
        for key, kind in (("ReadWritePaths", "rw"), ("ReadOnlyPaths", "ro"), ("InaccessiblePaths", "hidden")):
            yield from (View(path, kind, word, f"{key}=") for word, path, _ in paths(self.unit, key))
        for key, kind in (("BindPaths", "rw"), ("BindReadOnlyPaths", "ro"), ("TemporaryFileSystem", "empty")):
            yield from self._mounted(key, kind)
        yield from (View(path, "rw", None, "made by systemd") for path in directories(self.unit))

    def _mounted(self, key: str, kind: str) -> Iterator[View]:
        for value in self.unit.values(key, self.unit.section):
            for word in split_words(value).words:
                parts = word.lstrip("-").split(":")
                target = (
                    parts[1] if key.startswith("Bind") and len(parts) > 1 and parts[1].startswith("/") else parts[0]
                )
                read_only = key == "TemporaryFileSystem" and "ro" in ":".join(parts[1:]).split(",")
                yield View(target.rstrip("/") or "/", "ro" if read_only else kind, word, f"{key}=")

    def view(self, path: str) -> View | None:
        """What decides on a path; None when nothing restricts it."""
        holding = [view for view in self.views if _below(path, view.prefix)]
        for view in holding:
            if view.mode == "hidden":
                return view
        return max(holding, key=lambda view: len(view.prefix.rstrip("/")), default=None)

    @property
    def user_known(self) -> bool:
        """Whether the user is certain: no specifier, no id without a name, no template's placeholder."""
        user = self.unit.get("User")
        if self.unit.manager != "system":
            return False
        return user is None or not ("%" in user or (user.isdigit() and user != "0") or self.unit.is_opaque(user))

    def home(self) -> tuple[str | None, str]:
        """The home directory of the service's user and who says so; None when there is none."""
        if self.dynamic:
            return None, "DynamicUser= gives no home"
        user = self.unit.get("User")
        if not user or user in ("root", "0"):
            return "/root", "root's"
        source = self.robot.tree.find("/etc/passwd")
        for line in source.text.splitlines() if source else ():
            fields = line.split(":")
            if len(fields) > 5 and user in (fields[0], fields[2]):
                if fields[5] in ("", "/", "/nonexistent"):
                    return None, f"{user} has no home in {source.name}"
                return fields[5].rstrip("/"), f"the home of {user} in {source.name}"
        return f"/home/{user}", f"the home of {user}"

    def log_directory(self, process: Process) -> LogDirectory | None:
        """Where the ROS programs of a command line log; None when that is not known."""
        environment = process_environment(process, self.robot)
        for name, suffix in (("ROS_LOG_DIR", ""), ("ROS_HOME", "/log")):
            variable = environment.get(name)
            if variable is not None:
                path = variable.text
                return (
                    LogDirectory(path.rstrip("/") + suffix, f"{name}=", variable.value)
                    if path and path[0] == "/"
                    else None
                )
            if not environment.complete:
                return None
        return self._default_log(environment)

    def _default_log(self, environment: Environment) -> LogDirectory | None:
        variable = environment.get("HOME")
        if variable is not None:
            return LogDirectory(f"{variable.text}/.ros/log", "HOME=", variable.value) if variable.text else None
        if not self.user_known:
            return None
        home, why = self.home()
        if home == "/root" and not self.unit.get("User"):
            return None
        return LogDirectory(f"{home}/.ros/log" if home else None, why, None)


def _below(path: str, prefix: str) -> bool:
    return prefix == "/" or path == prefix or path.startswith(f"{prefix}/")


def sandbox(unit: Unit, robot: Robot) -> Sandbox:
    return Sandbox(unit, robot)
