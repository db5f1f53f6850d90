"""The settings of systemd's daemons: which key journald.conf, system.conf and logind.conf know, since when, with what
value."""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

from bringup_lint import facts


class DaemonSetting(NamedTuple):
    section: str
    key: str
    type: str
    """A grammar of ``parsers.systemd_values``, or ``watchdog``, ``count``, ``bool-or-size``, ``ignored``."""
    since: int


@cache
def daemon_settings(name: str) -> dict[str, DaemonSetting]:
    """Key to setting, for ``journald``, ``system`` or ``logind``."""
    return {
        key: DaemonSetting(section, key, kind, int(since))
        for file, section, key, kind, since in facts.rows("systemd/daemon_settings")[1]
        if file == name
    }


SECTIONS = {"journald": "Journal", "system": "Manager", "logind": "Login"}
"""The only section of each daemon's files."""
