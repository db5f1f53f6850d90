"""The file that CYCLONEDDS_URI names does not exist.

## What it finds
A path in the CYCLONEDDS_URI of a unit that does not exist in a whole root file system; in a repository, a path that
nothing of it ships or makes, in a folder for which it ships a file of nearly the same name, or to which a script or
a play copies one (a warning). For containers, a path to which nothing brings a file: neither an instruction of the
Dockerfile of the tree, on an official image, nor a volume.

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

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import docker
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["can't open configuration file", "rmw_create_node: failed to create domain"])
def cyclonedds_uri_file_missing(robot: Robot) -> Iterator[Finding]:
    seen = set()
    for process in robot.ros.processes:
        uri = process.environment.get("CYCLONEDDS_URI") if process.unit else None
        if uri is None or process.environment.text("RMW_IMPLEMENTATION") not in (None, "rmw_cyclonedds_cpp"):
            continue
        for path in _paths(uri.text):
            sibling = robot.filesystem.shipped_sibling(path)
            if (uri.value.span, path) not in seen and (sibling or robot.tree.has(path) is False):
                seen.add((uri.value.span, path))
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
    yield from _of_containers(robot)


def _paths(text: str | None) -> list[str]:
    """The absolute paths of a value; none where it holds the configuration itself."""
    if text is None or "<" in text:
        return []
    paths = (part.strip().removeprefix("file://") for part in text.split(","))
    return [path for path in paths if path.startswith("/")]


def _of_containers(robot: Robot) -> Iterator[Finding]:
    """One finding for each value, at the first container that gets it."""
    seen = set()
    containers = robot.runners.in_containers
    for value, path, runner in docker.missing_settings(robot.files, containers, "CYCLONEDDS_URI", _paths):
        if runner.environment.text("RMW_IMPLEMENTATION") == "rmw_cyclonedds_cpp" and value.span not in seen:
            seen.add(value.span)
            yield finding(
                value,
                f"Nothing brings {path} into {runner.name}: Cyclone DDS fails, and no node starts",
                advice="copy or mount the file there, or correct the path",
                confidence="medium",
                related=[note(runner.where, "has no such file")],
            )
