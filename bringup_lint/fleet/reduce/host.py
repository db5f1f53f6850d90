"""How the robot is set up: units, kernel parameters, versions, time, addresses."""

from __future__ import annotations

import re

from bringup_lint.fleet.reduce.statements import Statements
from bringup_lint.parsers.certificate import parse as certificate_of
from bringup_lint.pattern import regex
from bringup_lint.source import Source

_RELEASE = regex(r"^(?P<key>ID|VERSION_ID|IMAGE_VERSION|BUILD_ID)=\"?(?P<value>[^\"\n]+)", re.M)
_CHRONY = regex(r"^[ \t]*(?:server|pool|peer)[ \t]+(?P<host>\S+)", re.M)
_TIMESYNCD = regex(r"^[ \t]*NTP=(?P<host>[^\n]*\S)", re.M)
_CHRONY_FILES = ("/etc/chrony/chrony.conf", "/etc/chrony.conf")
_TIMESYNCD_FILES = ("/etc/systemd/timesyncd.conf",)
_TUNNEL = regex(r"-R[ \t]?(?:[\w.*]{1,60}:)?(?P<port>\d{2,5}):[\w.-]{1,100}:\d{1,5}")
_SERVER = regex(r"[\w.-]@(?P<host>[\w.-]+)")
_WRITTEN_BY_ROBOT = frozenset(("Environment", "Description"))
"""Settings that name the robot, or may hold what no summary may."""


def units(said: Statements) -> None:
    """Every setting of the units that the robot has of its own, by its effective values."""
    for unit in said.robot.units.judged:
        if unit.masked or unit.uncertain:
            continue
        said.state("unit", unit.name, "there", unit.where)
        keys = {(str(each.section), str(each.key)) for file in unit.files for each in file.assignments}
        for section, key in sorted(keys):
            values = unit.values(key, section) if key not in _WRITTEN_BY_ROBOT else []
            if values:
                said.state("setting", f"{unit.name} {key}", " ; ".join(values), values[0])


def kernel(said: Statements) -> None:
    sysctl = said.robot.sysctl
    if sysctl.certain:
        last = {setting.name: setting for setting in sysctl.settings}
        for name, setting in last.items():
            said.state("kernel-parameter", name, setting.value, setting.value)


def versions(said: Statements) -> None:
    """The release of the system and of ROS."""
    release = said.file("/etc/os-release") or said.file("/usr/lib/os-release")
    if release is None:
        return
    for match in _RELEASE.finditer(release.text):
        said.state("version", f"os-release {match['key']}", match["value"], release.located(*match.span("value")))


def time_sources(said: Statements) -> None:
    """The servers of chrony and systemd-timesyncd, all together."""
    for places, pattern in ((_CHRONY_FILES, _CHRONY), (_TIMESYNCD_FILES, _TIMESYNCD)):
        for source in filter(None, map(said.file, places)):
            _time_servers(said, source, pattern)


def _time_servers(said: Statements, source: Source, pattern: re.Pattern[str]) -> None:
    found = list(pattern.finditer(source.text))
    if found:
        hosts = sorted({host for match in found for host in match["host"].split()})
        said.state("time-source", "", " ".join(hosts), source.located(*found[0].span("host")))


def addresses(said: Statements) -> None:
    """Static addresses of interfaces that lead out of the robot, and addresses of interfaces set by hand. The network
    inside of a robot is the same in all of them, and meant to be."""
    for plan in said.robot.netplan.plans:
        for interface in plan.interfaces.values():
            mac = interface.value("macaddress")
            if mac is not None and re.fullmatch(r"(?:[0-9a-fA-F]{2}:){5}[0-9a-fA-F]{2}", mac):
                said.state("mac", "", mac.lower(), mac)
            leads_out = interface.kind == "wifis" or any(route.is_default for route in interface.routes)
            if not leads_out and interface.value("gateway4") is None:
                continue
            for address in interface.addresses:
                if address.ip is not None:
                    said.state("address", "", str(address.ip).partition("/")[0], address.text)


def certificates(said: Statements) -> None:
    """The last days of the certificates that the robot shows to others."""
    for place, source in said.files(".pem", ".crt"):
        if "BEGIN CERTIFICATE" not in source.text or place.startswith(("/etc/ssl/certs/", "/usr/share/")):
            continue
        found = certificate_of(source.text)
        if found is not None and "ca." not in place.rpartition("/")[2]:
            said.state("certificate", place, found.last_day.isoformat(), source.span(0, 1))


def tunnels(said: Statements) -> None:
    """The ports that the robot opens on another machine with ``ssh -R``."""
    for source in said.robot.of_kind("shell-script", "systemd-unit", "systemd-dropin"):
        for match in _TUNNEL.finditer(source.text):
            where = source.located(*match.span("port"))
            line = source.line_text(where.line)
            server = _SERVER.search(line)
            if server is not None and "ssh" in line and not line.lstrip().startswith("#"):
                said.state("tunnel", server["host"], match["port"], where)
