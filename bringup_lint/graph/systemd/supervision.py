"""How systemd supervises a service: readiness, watchdog, timeouts, signals. systemd.service(5),
systemd.kill(5)."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cached_property

from bringup_lint.dataclass import dataclass
from bringup_lint.graph.files import Files
from bringup_lint.graph.systemd.main_process import Main
from bringup_lint.graph.systemd.main_process import main_process
from bringup_lint.graph.systemd.manager import manager_setting
from bringup_lint.graph.systemd.process import Process
from bringup_lint.graph.systemd.settings import Setting
from bringup_lint.graph.systemd.settings import one_of
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.parsers.systemd_values import parse_timespan
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.systemd.daemons import Daemon

TYPES = frozenset("simple exec forking oneshot dbus notify notify-reload idle".split())
ACCESS = frozenset(["none", "main", "exec", "all"])
KILL_MODES = frozenset(["control-group", "process", "mixed", "none"])
DEFAULT_TIMEOUT = 90.0
"""systemd-system.conf(5): DefaultTimeoutStartSec=, DefaultTimeoutStopSec=."""

_NUMBERED = {
    "1": "HUP",
    "2": "INT",
    "3": "QUIT",
    "6": "ABRT",
    "9": "KILL",
    "10": "USR1",
    "12": "USR2",
    "15": "TERM",
}
_NAMED = frozenset(
    (
        "HUP INT QUIT ILL TRAP ABRT BUS FPE KILL USR1 SEGV USR2 PIPE ALRM TERM STKFLT CHLD CONT STOP TSTP "
        "TTIN TTOU URG XCPU XFSZ VTALRM PROF WINCH IO PWR SYS"
    ).split()
)


def signal_name(text: str) -> str | None:
    """``SIGINT`` for ``SIGINT``, ``INT`` and ``2``; None when it is no signal."""
    name = _NUMBERED.get(text, text.removeprefix("SIG"))
    if name in _NAMED:
        return f"SIG{name}"
    return text if text.removeprefix("SIG").startswith("RT") else None


@dataclass(eq=False)
class Supervision:
    """The settings of one service; ``value`` None in a setting that has a place means: not known."""

    unit: Unit
    files: Files
    system_conf: Callable[[], list[Daemon]]
    process: Process | None
    """The one command line of ExecStart=; None when there are none or several."""

    @cached_property
    def type(self) -> Setting[str]:
        """Type=, its default filled in."""
        known = TYPES if self.files.target.systemd >= 253 else TYPES - {"notify-reload"}
        found = self.unit.setting(one_of(known), "Type")
        if self.unit.get("BusName"):
            return found.otherwise("dbus")
        return found.otherwise("simple" if self.unit.has("ExecStart") else "oneshot")

    @property
    def notifies(self) -> bool:
        """Whether the service counts as started only when it says so."""
        return self.type.value in ("notify", "notify-reload")

    @cached_property
    def access(self) -> Setting[str]:
        """NotifyAccess=, with what systemd makes of ``none`` when it needs the socket (``service_add_extras()``)."""
        found = self.unit.setting(one_of(ACCESS), "NotifyAccess")
        if found.unknown or found.value in ("main", "exec", "all"):
            return found
        return Setting(found.at, "main" if self.notifies or self.watchdog_on else "none")

    @cached_property
    def watchdog(self) -> Setting[float]:
        return self.unit.seconds("WatchdogSec")

    @property
    def watchdog_on(self) -> bool:
        return bool(self.watchdog) and self.watchdog.value != math.inf

    @cached_property
    def start_timeout(self) -> Setting[float]:
        """TimeoutStartSec= in seconds. systemd starts the clock anew for every command of the unit."""
        otherwise = math.inf if self.type.value == "oneshot" else self._default("DefaultTimeoutStartSec")
        return self._timeout("TimeoutStartSec", otherwise)

    @cached_property
    def stop_timeout(self) -> Setting[float]:
        return self._timeout("TimeoutStopSec", self._default("DefaultTimeoutStopSec"))

    def _timeout(self, key: str, otherwise: float) -> Setting[float]:
        found = self.unit.seconds(key, "TimeoutSec")
        if found.at is None:
            return Setting(None, otherwise)
        return Setting(found.at, math.inf if found.value == 0 else found.value)

    def _default(self, key: str) -> float:
        configured = manager_setting(self.system_conf(), key, parse_timespan)
        return configured[1] or math.inf if configured else DEFAULT_TIMEOUT

    @cached_property
    def kill_signal(self) -> Setting[str]:
        return self.unit.setting(signal_name, "KillSignal").otherwise("SIGTERM")

    @cached_property
    def kill_mode(self) -> Setting[str]:
        return self.unit.setting(one_of(KILL_MODES), "KillMode").otherwise("control-group")

    @cached_property
    def final_signal(self) -> Setting[str]:
        return self.unit.setting(signal_name, "FinalKillSignal").otherwise("SIGKILL")

    @cached_property
    def sends_kill(self) -> Setting[bool]:
        return self.unit.flag("SendSIGKILL").otherwise(True)

    @cached_property
    def main(self) -> Main | None:
        """The main process; None when it is not known which command line starts it."""
        if self.process is None or self.type.value in ("forking", "oneshot") or self.type.unknown:
            return None
        return main_process(self.process, self.files)

    @property
    def main_line(self) -> Process:
        """The command line that starts the main process, when it is known."""
        if self.process is None:
            raise LookupError(f"{self.unit.name} has several command lines, or none")
        return self.process

    @property
    def in_container(self) -> bool:
        """Whether the service runs in a container, whose processes are not the unit's."""
        return self.main is not None and self.main.kind == "container"
