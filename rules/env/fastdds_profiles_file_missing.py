"""The Fast DDS profile file that the environment names does not exist.

## What it finds
A path in the FASTRTPS_DEFAULT_PROFILES_FILE or FASTDDS_DEFAULT_PROFILES_FILE of a unit that does not exist in a
whole root file system; in a repository, a path that nothing of it ships or makes, in a folder for which it ships a file
of nearly the same name.

## Why it matters on a robot
Fast DDS logs one line and runs with its defaults: multicast discovery, no peers. The robot seems to work until it
joins another network.

## Bad
```sh
FASTRTPS_DEFAULT_PROFILES_FILE=/etc/robot/fast.xml      (the file is called fastdds.xml)
```

## Good
```sh
FASTRTPS_DEFAULT_PROFILES_FILE=/etc/robot/fastdds.xml
```

## When to ignore it
When a script or unit generates the file before the nodes start.

## References
- tried with Fast DDS 2.14.5: "realpath failed"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule

VARIABLES = ("FASTRTPS_DEFAULT_PROFILES_FILE", "FASTDDS_DEFAULT_PROFILES_FILE")


@rule("warning", symptoms=["realpath failed"])
def fastdds_profiles_file_missing(robot: Robot) -> Iterator[Finding]:
    said: set[Span] = set()
    for process in robot.ros.processes:
        if not process.unit:
            continue
        for name in VARIABLES:
            found = process.environment.get(name)
            if not found or not found.text or not found.text.startswith("/") or found.value.span in said:
                continue
            sibling = robot.filesystem.shipped_sibling(found.text)
            if sibling or robot.tree.has(found.text) is False:
                said.add(found.value.span)
                yield finding(
                    found.value,
                    f"{found.text} does not exist: {process.name} runs Fast DDS with its defaults "
                    "(multicast, no peers)",
                    advice=f"install the file, or name {sibling}"
                    if sibling
                    else "install the file, or correct the path",
                    confidence="medium" if sibling else None,
                    chain=robot.provenance.chain_to_variable(
                        process, found.value, note(found.value, "the file is named here")
                    ),
                    related=[note(process.where, f"{process.name} gets the variable")],
                )
