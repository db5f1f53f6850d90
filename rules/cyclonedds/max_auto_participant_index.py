"""Cyclone DDS has fewer participant indices than the robot has processes.

## What it finds
Three problems with participant indices:
- **error**: `ParticipantIndex` is `auto`, and `MaxAutoParticipantIndex` is too low for the processes that
  read the file and start at boot together. They are counted from the launch files of their units. The
  components of a container count as one process; conditional ones are not counted.
- **error** or **warning**: `ParticipantIndex` is a number. The ports of a process follow from its index, so the
  second process of the domain cannot open them. It is an error where at least two processes are known to read the
  file; a command such as `ros2 topic` is a second one too.
- **info**: an index above 119, whose ports belong to the next domain.

## Why it matters on a robot
The library assigns the indices from 0 to the maximum. The next process exits with `Failed to find a free
participant index`. Which process that is changes with every boot. With a fixed index it exits with `failed to
create unicast sockets`.

## Bad
```xml
<MaxAutoParticipantIndex>9</MaxAutoParticipantIndex>   <!-- 12 nodes -->
```

## Good
```xml
<MaxAutoParticipantIndex>30</MaxAutoParticipantIndex>
```

## When to ignore it
If some of the processes are alternatives that never run at the same time, so that the count is too high.

## References
- Cyclone DDS 0.10.5 and 11.0.1, tested with the real library
- DDSI-RTPS 2.5, section 9.6.2.3: port 7400 + 250 x domain + 2 x participant + 10
- https://github.com/ros2/rmw_cyclonedds/issues/458
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Related
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.cyclonedds import Domain
from bringup_lint.api.cyclonedds import Setting
from bringup_lint.api.dds import Selection


@rule(
    "error",
    symptoms=[
        "Failed to find a free participant index for domain",
        "failed to create unicast sockets for domain",
    ],
)
def max_auto_participant_index(robot: Robot) -> Iterator[Finding]:
    for configuration, domain in robot.dds.domains:
        yield from _in_the_next_domain(domain)
        index = domain.get("Discovery/ParticipantIndex")
        text = (index.effective or "").lower() if index is not None else ""
        if index is None or not robot.dds.in_use(configuration):
            continue
        readers = robot.dds.largest_coexisting_group(configuration)
        if text.isdecimal():
            yield _fixed(index, _in_one_domain(readers))
        elif text == "auto" and readers:
            yield from _too_few(robot, domain, index, readers)


def _in_the_next_domain(domain: Domain) -> Iterator[Finding]:
    for path in ("Discovery/MaxAutoParticipantIndex", "Discovery/ParticipantIndex"):
        setting = domain.get(path)
        text = setting.effective if setting else None
        if setting is None or not text or not text.isdecimal() or domain.found("Discovery/Ports"):
            continue
        if 119 < int(text) < 100000:
            port = 7400 + 10 + 2 * int(text)
            yield finding(
                setting.value,
                f"Index {text} means port {port} + 250 x domain, which belongs to the next domain (from 7650)",
                advice="stay at or below 119",
                severity="info",
            )


def _in_one_domain(readers: list[Selection]) -> list[Selection]:
    domains: dict[int | None, list[Selection]] = {}
    for each in readers:
        domains.setdefault(each.domain, []).append(each)
    return max(domains.values(), key=lambda group: sum(each.processes for each in group), default=[])


def _fixed(index: Setting, readers: list[Selection]) -> Finding:
    count = sum(each.processes for each in readers)
    message = f"With the fixed index {index.value} only one process of a domain starts on this computer"
    return finding(
        index.value,
        f"{message}, but at least {count} read the file" if count > 1 else f"{message}: the second one exits",
        advice="write auto, with MaxAutoParticipantIndex as large as the number of processes",
        related=_counted(readers),
        severity=None if count > 1 else "warning",
    )


def _too_few(robot: Robot, domain: Domain, index: Setting, readers: list[Selection]) -> Iterator[Finding]:
    count = sum(each.processes for each in readers)
    limit = domain.get("Discovery/MaxAutoParticipantIndex")
    text = "9" if limit is None else limit.effective or ""
    highest = int(text) if text.isdecimal() else None
    if highest is None or (limit is None and not robot.dds.old_discovery) or count <= highest + 1:
        return
    yield finding(
        limit.value if limit else index.value,
        f"Only {highest + 1} participants fit, but at least {count} processes start: the rest exit at once",
        advice=f"write MaxAutoParticipantIndex {max(30, count + 10)}, the same on all hosts",
        related=_counted(readers),
    )


def _counted(readers: list[Selection]) -> list[Related]:
    return [note(each.process.place, f"{each.process.name}: {each.processes}") for each in readers]
