"""Who could tell systemd that a service is ready or alive: sd_notify(3) in the scripts and packages of the
tree."""

from __future__ import annotations

import os
import re
from collections.abc import Callable
from collections.abc import Iterator
from enum import Enum
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.endings import CPP
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.memo import memo
from bringup_lint.graph.supervision.launched_by_unit import expansion_of
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.commands.ros_command import Ros
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.launch.expansion import Expansion
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.launch.started import Started
    from bringup_lint.graph.systemd.main_process import Main
    from bringup_lint.graph.systemd.process import Process
    from bringup_lint.graph.systemd.supervision import Supervision
    from bringup_lint.graph.workspace import Workspace
    from bringup_lint.source import Located
    from bringup_lint.source import Source

SPEAKS = regex(
    r"\bsd_(?:pid_)?notify|READY=1|WATCHDOG=1|systemd-notify|\bsdnotify\b|NOTIFY_SOCKET|systemd\.daemon|cysystemd"
)
"""What code that talks to systemd contains."""
_WORDS = ("notify", "READY=1", "WATCHDOG=1", "NOTIFY_SOCKET", "systemd.daemon", "cysystemd")
"""One of them is in all such code, which is found out much sooner."""

_CODE = (".py", *CPP, ".c", ".rs", ".sh", ".bash")
_PERHAPS = regex(r"notif|systemd|watchdog|heartbeat|sd_", re.I)
"""Names of packages that are not in the tree and might notify."""
_FILES = 5000


class Silence(Enum):
    """Why nothing reaches systemd."""

    ROS_TOOL = "systemd listens to ros2 launch or ros2 run only"
    SHELL = "systemd listens to a shell only"
    SCRIPT_OUTSIDE_TREE = "systemd listens to a shell script only, which the tree does not hold"
    PYTHON_SCRIPT = "systemd listens to a Python script only, which says nothing"
    NOT_STARTED = "the code that talks to systemd is not started"
    NO_CODE = "no code of the tree talks to systemd"


CERTAIN = frozenset({Silence.ROS_TOOL, Silence.SHELL})
"""What follows from the command line alone."""


class SilentLaunch(NamedTuple):
    """That nothing which a ROS command starts can talk to systemd."""

    why: Silence
    idle: list[Source]
    """The notifiers of the tree that are not started."""


class SilentService(NamedTuple):
    """That no keep-alive of a service reaches systemd."""

    why: Silence
    main: Main
    idle: list[Source]
    """The notifiers of the tree that are not started."""


class _Programs(NamedTuple):
    """What a launch file starts."""

    started: list[tuple[str, str]]
    """(package, executable)"""
    external: set[str]
    """The packages that are not in the tree."""


class _Module(NamedTuple):
    """A Python file that talks to systemd."""

    folder: str
    """That of its package."""
    name: str
    """With ``.py``."""

    @property
    def stem(self) -> str:
        return self.name.rpartition(".")[0]


def _speaks(source: Source) -> bool:
    return any(word in source.text for word in _WORDS) and source.matches(SPEAKS)


@dataclass(eq=False)
class Notify:
    """The notifiers of a tree."""

    files: Files
    launch: Callable[[], Launch]

    @cached_property
    def sources(self) -> list[Source]:
        """The source files of the tree that talk to systemd."""
        tree = self.files.tree
        paths = [path for path in tree.paths if path.endswith(_CODE) or "." not in os.path.basename(path)]
        found = []
        for path in paths[:_FILES]:
            source = tree.read(path, judged=False)
            if source is not None and _speaks(source):
                found.append(source)
        return found

    @property
    def _workspace(self) -> Workspace:
        return self.launch().workspace

    def in_process(self, process: Process) -> bool:
        """Whether the command line itself, or a script that it runs, talks to systemd."""
        return any(SPEAKS.search(text) for text in process.texts)

    def is_heard(self, service: Supervision) -> bool:
        """Whether the command line talks to systemd, and systemd listens to the processes that it starts: with
        NotifyAccess=exec, and to those of root always."""
        process = service.process
        if process is None or not self.in_process(process):
            return False
        return service.access.value == "exec" or service.unit.identity.is_root is not False

    def silence(self, service: Supervision) -> SilentService | None:
        """Why no keep-alive of a service reaches systemd; None when one may."""
        main, process = service.main, service.process
        if main is None or process is None:
            return None
        if service.access.value == "all":
            programs = [found for _, found in process.ros]
            if service.notifies or not main.is_ros_tool or self.in_process(process) or len(programs) != 1:
                return None
            silent = self.silent_launch(programs[0])
            return SilentService(silent.why, main, silent.idle) if silent else None
        why = None if self.is_heard(service) else self._deaf_to(main)
        return SilentService(why, main, []) if why else None

    def _deaf_to(self, main: Main) -> Silence | None:
        """Why systemd hears nothing when it listens to the main process only."""
        if main.is_ros_tool:
            return Silence.ROS_TOOL
        if main.kind == "shell":
            return Silence.SHELL
        if main.kind == "lost":
            return Silence.SCRIPT_OUTSIDE_TREE
        says_nothing = main.kind == "python" and main.script is not None and not self.sources
        return Silence.PYTHON_SCRIPT if says_nothing else None

    def silent_launch(self, ros: Ros) -> SilentLaunch | None:
        """That nothing which ``ros2 launch`` or ``ros2 run`` starts can talk to systemd. None when it may."""
        programs = self._programs(ros)
        if programs is None or any(_PERHAPS.search(name) for name in programs.external):
            return None
        idle = [source for source in self.sources if not self._starts(source, programs.started)]
        if len(idle) < len(self.sources):
            return None
        return SilentLaunch(Silence.NOT_STARTED if idle else Silence.NO_CODE, idle)

    def notifying_nodes(self, ros: Ros) -> Iterator[tuple[Started, Located]]:
        """The nodes of a launch file whose code talks to systemd, with the place where it does."""
        expansion = expansion_of(ros, self.launch())
        if expansion is None:
            return
        for node in expansion.nodes:
            package, executable = literal_text(node.package), literal_text(node.executable)
            if package is not None and executable is not None:
                for where in self._speaking(str(package), str(executable)):
                    yield node, where

    def _speaking(self, package: str, executable: str) -> Iterator[Located]:
        """Where the code of a program talks to systemd."""
        for source in self.sources:
            owner = self._workspace.owner(source)
            is_own = owner is not None and owner.name == package
            found = SPEAKS.search(source.text) if is_own and self._starts(source, [(package, executable)]) else None
            if found is not None:
                yield source.located(*found.span())

    def _programs(self, ros: Ros) -> _Programs | None:
        """What a ROS command of a package of the tree starts; None when that is not known."""
        if ros.package is None or ros.target is None:
            return None
        package = self._workspace.packages.get(str(ros.package))
        if package is None:
            return None
        if ros.kind == "run":
            return _Programs([(package.name, str(ros.target))], set())
        expansion = expansion_of(ros, self.launch())
        return None if expansion is None else self._launched(expansion)

    def _launched(self, expansion: Expansion) -> _Programs | None:
        packages = self._workspace.packages
        started = []
        for node in expansion.nodes:
            package = literal_text(node.package)
            executable = literal_text(node.executable) or literal_text(node.plugin)
            if package is None or executable is None:
                return None
            started.append((str(package), str(executable)))
        external = {package for package, _ in started if package not in packages}
        for include in expansion.includes:
            if include.target is None:
                place = self.launch().place(include.file)
                if place is None or not place.package or place.package in packages:
                    return None
                external.add(place.package)
        return _Programs(started, external)

    def _starts(self, notifier: Source, started: list[tuple[str, str]]) -> bool:
        """Whether a started program may run the code of a notifier."""
        package = self._workspace.owner(notifier)
        if package is None:
            return True
        executables = {executable for name, executable in started if name == package.name}
        if not executables:
            return any(name != package.name and self._depends(name, package.name) for name, _ in started)
        if not notifier.name.endswith(".py"):
            return True
        module = _Module(package.folder, notifier.basename)
        return bool(executables & self._executables(module)) or self._is_imported(module)

    def _depends(self, name: str, other: str) -> bool:
        package = self._workspace.packages.get(name)
        return package is not None and package.depends_on(other)

    @memo
    def _executables(self, module: _Module) -> frozenset[str]:
        """What a module may be called as a program, by its own name and the entry points of its package."""
        names = {module.stem, module.name}
        entry = re.compile(rf"([\w.-]+)\s*=\s*[\w.]*\b{re.escape(module.stem)}\s*:")
        for source in self.files.of_kind("setup-py", "setup-cfg"):
            if os.path.dirname(source.absolute) == module.folder:
                names.update(entry.findall(source.text))
        return frozenset(names)

    @memo
    def _is_imported(self, module: _Module) -> bool:
        """Whether another module of the package imports this one."""
        uses = re.compile(rf"^\s*(?:from|import)\s[^\n]*\b{re.escape(module.stem)}\b", re.M)
        for path in self.files.tree.walked_below(module.folder):
            if path.endswith(".py") and os.path.basename(path) != module.name:
                source = self.files.tree.read(path, judged=False)
                if source is not None and module.stem in source.text and uses.search(source.text):
                    return True
        return False
