"""docker compose does not take a value.

## What it finds
A value that compose or the Docker engine refuses:
- a string, a list or a mapping where another shape is expected, such as `user: 1000` without quotes
- nothing after a key (`environment:` with no entry)
- a word that is not one of those allowed, or a number out of range
- ports, mounts, devices, durations and sizes with a mistake
- a missing key
- `networks` beside `network_mode` in one service
- `mac_address` beside `network_mode: host`, or beside the network of another container (a warning, because only some
  versions of the engine refuse it; silent for a variable, which may be empty)

A mount option that compose does not know is a warning: it is passed over silently, so that `:r` mounts writable. One
that means `rw` is an info, as is a value of nothing but crosses, for somebody to fill in.

## Why it matters on a robot
docker compose refuses the whole file and starts none of the services, or the container is not created.

## Bad
```yaml
services:
  driver:
    image: robot/driver:1.2
    user: 1000
    stop_grace_period: 20
```

## Good
```yaml
services:
  driver:
    image: robot/driver:1.2
    user: "1000"
    stop_grace_period: 20s
```

## When to ignore it
When another program than docker compose reads the file.

## References
- https://github.com/compose-spec/compose-spec/blob/main/spec.md
- https://github.com/compose-spec/compose-go
"""

from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.compose import Service
from bringup_lint.api.schema import Code
from bringup_lint.api.schema import Remark
from bringup_lint.api.yaml import Mapping
from bringup_lint.api.yaml import Sequence

REFUSED = "docker compose refuses the file"
BY_ENGINE = ("container-name", "device", "restart", "mac", "stop-signal")
"""Grammars that the Docker engine checks, not compose."""
UNFILLED = regex(r"[Xx<>:-]{4,40}")
"""A value for somebody to fill in, such as XX:XX:XX:XX:XX:XX."""
MODES = ("rw", "ro", "z", "Z")
REDUNDANT = ("bind", "rbind")
"""Mount options of mount(8) that say what compose does with a path by itself."""
SHARED = ("service:", "container:")
CODES = (Code.SHAPE, Code.UNQUOTED, Code.VALUE, Code.ENUM, Code.RANGE, Code.BOOL, Code.NAME, Code.ADDRESS, Code.MISSING)


@rule(
    "error",
    fix="safe",
    symptoms=[
        "must be a string",
        "contains an invalid type, it should be",
        "must be a list",
        "to appropriate type: * is not a valid boolean value",
        "must be a mapping",
        "services must be a mapping",
        "conflicting options: mac-address and the network mode",
        "declares mutually exclusive `network_mode` and `networks`: invalid compose project",
    ],
)
def invalid_value(robot: Robot) -> Iterator[Finding]:
    for remark in robot.compose.remarks(*CODES):
        yield _refused(remark)
    yield from _ignored(list(robot.compose.remarks(Code.IGNORED)))
    for service in robot.compose.services:
        if (found := _two_networks(service)) is not None:
            yield found
    yield from _foreign_macs(robot.compose.services)


def _two_networks(service: Service) -> Finding | None:
    """A service that shares the network of another owner has none of its own."""
    mode, networks = service.network_mode, service.get("networks")
    if not mode or "$" in mode or not isinstance(networks, (Mapping, Sequence)):
        return None
    named = list(networks.merged) if isinstance(networks, Mapping) else networks.items
    if not named or networks.tag == "!reset":
        return None
    return finding(
        service.place_of("networks"),
        f"'{service.name}' has networks beside network_mode: {mode}: {REFUSED}",
        advice="keep one of the two",
        related=[note(mode, "the other one")],
    )


def _foreign_macs(services: Iterable[Service]) -> Iterator[Finding]:
    """Services without interfaces of their own, which have no address for one; each place once, also where others
    extend its service."""
    found: dict[Span, Service] = {}
    for service in services:
        mode = service.network_mode
        address = service.scalar("mac_address")
        if mode and address and "$" not in address and (mode == "host" or mode.startswith(SHARED)):
            found.setdefault(service.place_of("mac_address").span, service)
    for service in found.values():
        mode = service.place_of("network_mode")
        yield finding(
            service.place_of("mac_address"),
            f"'{service.name}' gets no MAC address of its own with network_mode: {service.network_mode}: Docker "
            "refuses to create the container, or ignores the address",
            advice="remove mac_address",
            related=[note(mode, "the interfaces are not its own")],
            severity="warning",
        )


def _ignored(remarks: list[Remark]) -> Iterator[Finding]:
    """One finding for each file and option: people copy such a mount from line to line."""
    found: dict[tuple[Source, str], list[Remark]] = {}
    for remark in remarks:
        span = remark.where.span if isinstance(remark.where, Located) else remark.where
        found.setdefault((span.source, remark.detail), []).append(remark)
    for (_, option), (first, *others) in found.items():
        redundant = option in REDUNDANT
        wanted = redundant or "".join(filter(str.isalpha, option)) == "rw"
        yield finding(
            first.where,
            f"Compose ignores the unknown mount option '{option}': "
            + ("a mount of a path is a bind mount anyway" if redundant else "the mount is writable"),
            advice="remove the option" if redundant else _mount_option(str(option)),
            severity="info" if wanted else "warning",
            related=[note(other.where, "here, too") for other in others],
        )


def _mount_option(written: str) -> str:
    """What to write instead: the mode that is left without stray signs, else both."""
    letters = "".join(filter(str.isalpha, written))
    if letters in MODES:
        return f"write {letters}"
    return "write ro for a mount that the container only reads, else nothing"


def _refused(remark: Remark) -> Finding:
    where = remark.where
    name = remark.item.name if remark.item else ""
    if remark.code == Code.MISSING:
        return finding(where, f"'{name}' is missing here: {REFUSED}", advice=f"add {name}:")
    if remark.code == Code.NAME:
        return finding(where, f"'{where}' is not a name: {REFUSED}", advice="use letters, digits, dots, dashes and _")
    if remark.code not in (Code.SHAPE, Code.UNQUOTED):
        by_engine = remark.item is not None and remark.item.row["grammar"] in BY_ENGINE
        consequence = "the container is not created" if by_engine else REFUSED
        to_fill = isinstance(where, Located) and UNFILLED.fullmatch(where)
        severity = "info" if to_fill else None
        text = f"'{where}' {remark.detail}: {consequence}"
        advice = "write the address of this robot" if to_fill else "correct the value"
        return finding(where, text, advice=advice, severity=severity)
    written = isinstance(where, Located) and str(where) != name
    message = f"{name} takes {remark.detail}, not '{where}'" if written else f"{name} takes {remark.detail}"
    quoted = written and remark.code == Code.UNQUOTED
    return finding(
        where,
        f"{message}: {REFUSED}",
        advice="put it in quotes" if quoted else f"write {remark.detail}",
        fix=fix("put it in quotes", (where, f'"{where}"')) if quoted else None,
    )
