"""What limits.conf grants to the user of a service, although PAM never sees a service."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.graph.systemd.units import Units
from bringup_lint.parsers.limits import Grant
from bringup_lint.parsers.limits import parse

LIMIT_OF = {"rtprio": "LimitRTPRIO", "memlock": "LimitMEMLOCK", "nice": "LimitNICE"}
"""Items that real-time programs need, and the setting that grants them to a service."""
_SCHEDULING = (
    "Nice",
    "CPUSchedulingPolicy",
    "CPUSchedulingPriority",
    "LimitRTPRIO",
    "LimitMEMLOCK",
    "LimitNICE",
    "IOSchedulingClass",
)
_UNLIMITED = ("unlimited", "-1", "infinity")


def granted_limits(unit: Unit, units: Units) -> Iterator[tuple[str, Grant]]:
    """The real-time items that the limits files grant to the user of a service, with the line that says so."""
    identity = unit.identity
    if not identity.is_other:
        return
    groups = identity.groups(units.users)
    files = units.files
    own = [source for source in files.of_kind("limits-conf") if source.origin is None]
    for grants in files.parsed(parse, own):
        for grant in grants:
            of_group = grant.domain.startswith("@") and grant.domain[1:] in groups
            if grant.item in LIMIT_OF and (of_group or grant.domain == identity.name):
                yield grant.item, grant


def missing_limits(unit: Unit, units: Units) -> dict[str, list[Grant]]:
    """The items that logins of the service's user get and that the service itself goes without, with their lines."""
    missing: dict[str, list[Grant]] = {}
    for item, grant in granted_limits(unit, units):
        if not unit.get(LIMIT_OF[item]) and not _given_otherwise(unit, item):
            missing.setdefault(item, []).append(grant)
    return missing


def sets_priority(unit: Unit) -> bool:
    """Whether the unit sets any priority or real-time limit."""
    return any(unit.get(key) for key in _SCHEDULING)


def limit_line(item: str, grant: Grant) -> str:
    """The line that grants the same to a service: limits.conf counts memory in KiB."""
    value = str(grant.value)
    if item == "memlock":
        value = "infinity" if value in _UNLIMITED else f"{value}K"
    return f"{LIMIT_OF[item]}={value}"


def _given_otherwise(unit: Unit, item: str) -> bool:
    capabilities = {str(word) for word in unit.words("AmbientCapabilities")}
    if item == "memlock":
        return "CAP_IPC_LOCK" in capabilities
    realtime = item == "rtprio" and unit.get("CPUSchedulingPolicy") in ("fifo", "rr")
    return realtime or "CAP_SYS_NICE" in capabilities
