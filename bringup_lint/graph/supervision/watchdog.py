"""Who opens the hardware watchdog, besides systemd."""

from __future__ import annotations

import re
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.robot import Robot

_SETTING = re.compile(r"^[ \t]*([\w-]+)[ \t]*=[ \t]*([^\s#]+)", re.M)
_OPENS = re.compile(
    r"\b(?:open|fopen|os\.open|ofstream|ifstream)\b[^\n]*?[\"'](/dev/watchdog\d*)[\"']|>\s*(/dev/watchdog\d*)\b"
)
_PROGRAM = re.compile(r"\.(?:py|sh|bash|c|cc|cpp|cxx|hpp|rs)$")
_TEST = re.compile(r"(?:^|/)(?:tests?|docs?|examples?)/")
_MOST_PROGRAMS = 2000

Owner = tuple[Located, str]


class Watchdog:
    """watchdog.conf(5), and programs of the tree that open the device."""

    def __init__(self, robot: Robot) -> None:
        self.robot = robot

    @cached_property
    def files(self) -> list[dict[str, Located]]:
        """The settings of each watchdog.conf; of a key that is set twice the last."""
        return [
            {match[1]: source.located(*match.span(2)) for match in _SETTING.finditer(source.text)}
            for source in self.robot.of_kind("watchdog-conf")
            if not source.template
        ]

    @cached_property
    def owners(self) -> list[Owner]:
        """The device as each owner names it, and the owner in words."""
        found = [
            (settings["watchdog-device"], "the watchdog daemon")
            for settings in self.files
            if "watchdog-device" in settings
        ]
        tree = self.robot.tree
        paths = [path for path in tree.paths if _PROGRAM.search(path)] if self.robot.system_conf else []
        for path in paths[:_MOST_PROGRAMS]:
            source = next((each for each in self.robot.sources if each.name == path), None) or tree.read(path)
            if source is None or "/dev/watchdog" not in source.text or _TEST.search(source.name):
                continue
            match = _OPENS.search(source.text)
            if match:
                group = 1 if match[1] else 2
                found.append((source.located(*match.span(group)), source.basename))
        return found
