"""Cyclone DDS has fewer participant indices than the robot has processes.

## What it finds
Two problems with participant indices:
- **error**: `ParticipantIndex` is `auto`, and `MaxAutoParticipantIndex` is too low for the processes that
  read the file and start at boot together. They are counted from the launch files of their units. The
  components of a container count as one process; conditional ones are not counted.
- **info**: an index above 119, whose ports belong to the next domain.

## Why it matters on a robot
The library assigns the indices from 0 to the maximum. The next process exits with `Failed to find a free
participant index`. Which process that is changes with every boot.

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
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["Failed to find a free participant index for domain"])
def max_auto_participant_index(robot: Robot) -> Iterator[Finding]:
    for configuration, domain in robot.dds.domains:
        for path in ("Discovery/MaxAutoParticipantIndex", "Discovery/ParticipantIndex"):
            setting = domain.get(path)
            text = setting.effective if setting else None
            if text and text.isdigit() and 119 < int(text) < 100000 and not domain.found("Discovery/Ports"):
                port = 7400 + 10 + 2 * int(text)
                yield finding(
                    setting.value,
                    f"Index {text} means port {port} + 250 x domain, which belongs to the next domain (from 7650)",
                    advice="stay at or below 119",
                    severity="info",
                )
        index = domain.get("Discovery/ParticipantIndex")
        limit = domain.get("Discovery/MaxAutoParticipantIndex")
        readers = robot.dds.largest_coexisting_group(configuration)
        count = sum(selection.processes for selection in readers)
        if index is None or (index.effective or "").lower() != "auto" or not readers:
            continue
        highest = int(limit.effective) if limit and (limit.effective or "").isdigit() else 9 if not limit else None
        if highest is None or (limit is None and not robot.dds.old_discovery) or count <= highest + 1:
            continue
        yield finding(
            limit.value if limit else index.value,
            f"Only {highest + 1} participants fit, but at least {count} processes start: the rest exit at once",
            advice=f"write MaxAutoParticipantIndex {max(30, count + 10)}, the same on all hosts",
            related=[note(each.where, f"{each.who}: {each.processes}") for each in readers],
        )
