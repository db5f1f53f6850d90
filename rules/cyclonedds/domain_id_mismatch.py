"""A Cyclone DDS file is for a different domain than the robot's.

## What it finds
A process reads a file whose `Domain` blocks all have an `Id` other than `any`, and none of them is the
ROS_DOMAIN_ID of the process (0 if its environment is completely known and does not set it).

## Why it matters on a robot
The library skips blocks for other domains without a message: nothing in the file applies, and the robot runs
with multicast and default settings.

## Bad
```xml
# robot.env: ROS_DOMAIN_ID=42
<Domain Id="0">
```

## Good
```xml
<Domain Id="any">
```

## When to ignore it
If the file is shared by several processes, and this one should run with the defaults.

## References
- Cyclone DDS 0.10.5 and 11.0.1, tested with the real library: an unknown element below Id 42 is accepted
  in domain 0
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.cyclonedds import domain_number


@rule("error", fix="unsafe", silent="Cyclone DDS skips the settings of another domain without a message")
def domain_id_mismatch(robot: Robot) -> Iterator[Finding]:
    for configuration in robot.dds.configurations:
        ids = [domain.id for domain in configuration.domains if domain.id is not None]
        numbers = [domain_number(each) for each in ids]
        if not ids or len(ids) < len(configuration.domains) or None in numbers:
            continue
        for selection in robot.dds.readers(configuration):
            if selection.domain is None or selection.domain in numbers:
                continue
            related = [note(selection.uri, f"{selection.process.name} reads the file")]
            if selection.domain_where is not None:
                related.append(note(selection.domain_where, f"{selection.process.name} runs in this domain"))
            yield finding(
                ids[0],
                f"The file configures domain {numbers[0]}, but {selection.process.name} runs in domain "
                f"{selection.domain}: it has no effect",
                advice="write any",
                related=related,
                chain=robot.provenance.chain_to(ids[0], f"the block is for domain {numbers[0]}"),
                fix=fix("write any", (ids[0], "any")) if len(ids) == 1 else None,
            )
