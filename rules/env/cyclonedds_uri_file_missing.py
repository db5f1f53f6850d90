"""The file that CYCLONEDDS_URI names does not exist.

## What it finds
A path in the CYCLONEDDS_URI of a unit that does not exist in a whole root file system; in a repository, a path that
nothing of it ships or makes, in a folder for which it ships a file of nearly the same name (a warning). Containers are
not checked: a container has its own file system.

## Why it matters on a robot
Cyclone DDS fails when it cannot open its configuration: no domain is created, and no node starts.

## Bad
```sh
CYCLONEDDS_URI=file:///etc/robot/cyclone.xml      (the file is called cyclonedds.xml)
```

## Good
```sh
CYCLONEDDS_URI=file:///etc/robot/cyclonedds.xml
```

## When to ignore it
When a script or unit generates the file before the nodes start.

## References
- tried with Cyclone DDS 0.10.5 and 11.0.1: "can't open configuration file"
- https://github.com/suchetanrs/ORB-SLAM3-ROS2-Docker/issues/32
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["can't open configuration file", "rmw_create_node: failed to create domain"])
def cyclonedds_uri_file_missing(robot: Robot) -> Iterator[Finding]:
    said: set[Span] = set()
    for process in robot.ros.processes:
        uri = process.environment.get("CYCLONEDDS_URI") if process.unit else None
        if uri is None or uri.text is None or "<" in uri.text:
            continue
        rmw = process.environment.text("RMW_IMPLEMENTATION")
        if rmw not in (None, "rmw_cyclonedds_cpp"):
            continue
        for part in uri.text.split(","):
            path = part.strip().removeprefix("file://")
            sibling = robot.filesystem.shipped_sibling(path) if path.startswith("/") else None
            if path.startswith("/") and (sibling or robot.tree.has(path) is False) and uri.value.span not in said:
                said.add(uri.value.span)
                yield finding(
                    uri.value,
                    f"{path} does not exist: Cyclone DDS fails, and {process.name} starts no node",
                    advice=f"install the file, or name {sibling}"
                    if sibling
                    else "install the file, or correct the path",
                    severity="warning" if sibling else None,
                    confidence="medium" if sibling else None,
                    chain=robot.provenance.chain_to_variable(
                        process, uri.value, note(uri.value, f"{path} is named here")
                    ),
                    related=[note(process.where, f"{process.name} gets the variable")],
                )
