"""Who could tell systemd that a service is ready or alive: sd_notify(3) in the scripts and packages of the
tree."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.graph.commands.ros_command import Ros
from bringup_lint.graph.supervision.launched_by_unit import launched
from bringup_lint.graph.systemd.process import Process
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.launch.started import Started
    from bringup_lint.robot import Robot

SPEAKS = re.compile(
    r"\bsd_(?:pid_)?notify|READY=1|WATCHDOG=1|systemd-notify|\bsdnotify\b|NOTIFY_SOCKET|systemd\.daemon|cysystemd"
)
"""What code that talks to systemd contains."""

_CODE = (".py", ".cpp", ".cc", ".cxx", ".c", ".hpp", ".hxx", ".h", ".rs", ".sh", ".bash")
_PERHAPS = re.compile(r"notif|systemd|watchdog|heartbeat|sd_", re.I)
"""Names of packages that are not in the tree and might notify."""
_FILES = 5000


@dataclass(eq=False)
class Notify:
    """The notifiers of a tree."""

    robot: Robot

    @cached_property
    def sources(self) -> list[Source]:
        """The source files of the tree that talk to systemd."""
        tree = self.robot.tree
        paths = [path for path in tree.paths if path.endswith(_CODE) or "." not in os.path.basename(path)]
        found = []
        for path in paths[:_FILES]:
            source = tree.read(path, judged=False)
            if source is not None and SPEAKS.search(source.text):
                found.append(source)
        return found

    def within(self, process: Process) -> bool:
        """Whether the command line itself, or a script that it runs, talks to systemd."""
        return any(SPEAKS.search(text) for text in process.texts)

    def nobody(self, ros: Ros) -> tuple[str, list[Source]] | None:
        """That nothing which ``ros2 launch`` or ``ros2 run`` starts can talk to systemd: the reason in words,
        and the notifiers of the tree that are not started. None when it may."""
        if ros.package is None or ros.target is None:
            return None
        workspace = self.robot.launch.workspace
        package = workspace.packages.get(str(ros.package))
        if package is None:
            return None
        if ros.kind == "run":
            started, external = [(package.name, str(ros.target))], set()
        else:
            found = self._launched(ros)
            if found is None:
                return None
            started, external = found
        if any(_PERHAPS.search(name) for name in external):
            return None
        idle = [source for source in self.sources if not self._starts(source, started)]
        if len(idle) < len(self.sources):
            return None
        named = os.path.basename(idle[0].name) if idle else ""
        return (f"the launch file does not start {named}" if named else "no code in the tree notifies systemd"), idle

    def speakers(self, ros: Ros) -> Iterator[tuple[Started, Located]]:
        """The nodes of a launch file whose code talks to systemd, with the place where it does."""
        from bringup_lint.graph.launch.started import literal_text

        expansion = launched(ros, self.robot)
        for node in expansion.nodes if expansion is not None else ():
            package, executable = literal_text(node.package), literal_text(node.executable)
            if package is None or executable is None:
                continue
            for source in self.sources:
                owner = self.robot.launch.workspace.owner(source)
                said = SPEAKS.search(source.text)
                if owner is not None and owner.name == package and said:
                    if self._starts(source, [(str(package), str(executable))]):
                        yield node, source.located(*said.span())

    def _launched(self, ros: Ros) -> tuple[list[tuple[str, str]], set[str]] | None:
        """(package, executable) of what the launch file starts, and the packages that are not in the tree."""
        expansion = launched(ros, self.robot)
        if expansion is None:
            return None
        from bringup_lint.graph.launch.started import literal_text

        workspace = self.robot.launch.workspace
        started, external = [], set()
        for node in expansion.nodes:
            package, executable = (
                literal_text(node.package),
                literal_text(node.executable) or literal_text(node.plugin),
            )
            if package is None or executable is None:
                return None
            started.append((str(package), str(executable)))
        external |= {package for package, _ in started if package not in workspace.packages}
        for include in expansion.includes:
            if include.target is None:
                place = self.robot.launch.place(include.file)
                if place is None or not place.package or place.package in workspace.packages:
                    return None
                external.add(place.package)
        return started, external

    def _starts(self, notifier: Source, started: list[tuple[str, str]]) -> bool:
        """Whether a started program may run the code of a notifier."""
        package = self.robot.launch.workspace.owner(notifier)
        if package is None:
            return True
        executables = {executable for name, executable in started if name == package.name}
        if not executables:
            return any(name != package.name and self._depends(name, package.name) for name, _ in started)
        stem = os.path.basename(notifier.name).rpartition(".")[0]
        if not notifier.name.endswith(".py"):
            return True
        return bool(executables & {stem, f"{stem}.py", *self._entry_points(package.folder, stem)}) or self._imported(
            package.folder, stem, notifier
        )

    def _depends(self, name: str, other: str) -> bool:
        package = self.robot.launch.workspace.packages.get(name)
        return package is not None and package.depends_on(other)

    def _entry_points(self, folder: str, stem: str) -> Iterator[str]:
        for source in self.robot.of_kind("setup-py", "setup-cfg"):
            if os.path.dirname(os.path.abspath(source.name)) == folder:
                yield from re.findall(rf"([\w.-]+)\s*=\s*[\w.]*\b{re.escape(stem)}\s*:", source.text)

    def _imported(self, folder: str, stem: str, notifier: Source) -> bool:
        """Whether another module of the package imports the notifier."""
        uses = re.compile(rf"^\s*(?:from|import)\s[^\n]*\b{re.escape(stem)}\b", re.M)
        for path in self.robot.tree.paths:
            if path.startswith(folder + "/") and path.endswith(".py") and os.path.basename(path) != notifier.basename:
                source = self.robot.tree.read(path, judged=False)
                if source is not None and uses.search(source.text):
                    return True
        return False
