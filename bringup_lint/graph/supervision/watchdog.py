"""Who opens the hardware watchdog, besides systemd."""

from __future__ import annotations

import re
from collections.abc import Callable
from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.pattern import regex
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.systemd.daemons import Daemon

_SETTING = regex(r"^[ \t]*([\w-]+)[ \t]*=[ \t]*([^\s#]+)", re.M)
_OPENS = regex(
    r"\b(?:open|fopen|os\.open|ofstream|ifstream)\b[^\n]*?[\"'](/dev/watchdog\d*)[\"']|>\s*(/dev/watchdog\d*)\b"
)
_PROGRAM = regex(r"\.(?:py|sh|bash|c|cc|cpp|cxx|hpp|rs)$")
_TEST = regex(r"(?:^|/)(?:tests?|docs?|examples?)/")
_MOST_PROGRAMS = 2000

Owner = tuple[Located, str]


@dataclass(eq=False)
class Watchdog:
    """watchdog.conf(5), and programs of the tree that open the device."""

    files: Files
    system_conf: Callable[[], list[Daemon]]

    @cached_property
    def settings(self) -> list[dict[str, Located]]:
        """The settings of each watchdog.conf; of a key that is set twice the last."""
        return [
            {match[1]: source.located(*match.span(2)) for match in _SETTING.finditer(source.text)}
            for source in self.files.of_kind("watchdog-conf")
            if not source.template
        ]

    @cached_property
    def owners(self) -> list[Owner]:
        """The device as each owner names it, and the owner in words."""
        daemons = [
            (settings["watchdog-device"], "the watchdog daemon")
            for settings in self.settings
            if "watchdog-device" in settings
        ]
        return [*daemons, *self._programs()]

    def _programs(self) -> Iterator[Owner]:
        """The programs of the tree that open the device. They matter only where systemd is configured."""
        if not self.system_conf():
            return
        tree = self.files.tree
        known = {source.name: source for source in tree.sources}
        for path in [path for path in tree.paths if _PROGRAM.search(path)][:_MOST_PROGRAMS]:
            source = known.get(path) or tree.at(path)
            if source is None or "/dev/watchdog" not in source.text or _TEST.search(source.name):
                continue
            match = _OPENS.search(source.text)
            if match:
                group = 1 if match[1] else 2
                yield source.located(*match.span(group)), source.basename
