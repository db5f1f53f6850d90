"""The Fast DDS profile file that the environment names does not exist.

## What it finds
A path in the FASTRTPS_DEFAULT_PROFILES_FILE or FASTDDS_DEFAULT_PROFILES_FILE of a unit that does not exist in a
whole root file system; in a repository, a path that nothing of it ships or makes, in a folder for which it ships a file
of nearly the same name. For containers, a path to which nothing brings a file: neither an instruction of the
Dockerfile of the tree, on an official image, nor a volume.

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

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import docker
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.ros import at_least

VARIABLES = ("FASTRTPS_DEFAULT_PROFILES_FILE", "FASTDDS_DEFAULT_PROFILES_FILE")


@rule("warning", symptoms=["realpath failed"])
def fastdds_profiles_file_missing(robot: Robot) -> Iterator[Finding]:
    if not robot.may_hold("DEFAULT_PROFILES_FILE"):
        return
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
    yield from _of_containers(robot)


def _paths(text: str | None) -> list[str]:
    return [text] if text is not None and text.startswith("/") else []


def _of_containers(robot: Robot) -> Iterator[Finding]:
    """One finding for each value, at the first container that gets it."""
    seen: set[Span] = set()
    containers = robot.runners.in_containers
    missing = (docker.missing_settings(robot.files, containers, name, _paths) for name in _read(robot))
    for value, path, runner in (each for found in missing for each in found):
        if _is_fast(runner) and value.span not in seen:
            seen.add(value.span)
            yield finding(
                value,
                f"Nothing brings {path} into {runner.name}: Fast DDS runs with its defaults (multicast, no peers)",
                advice="copy or mount the file there, or correct the path",
                confidence="medium",
                related=[note(runner.where, "has no such file")],
            )


def _read(robot: Robot) -> tuple[str, ...]:
    """The variables that Fast DDS reads: Fast DDS 3, of Kilted, knows the new name alone."""
    newer = at_least(robot.target.ros, "kilted")
    return VARIABLES if newer is None else (VARIABLES[newer],)


def _is_fast(runner: docker.Runner) -> bool:
    """Whether the nodes of a container certainly run on Fast DDS, which they do by default."""
    name = "RMW_IMPLEMENTATION"
    chosen = runner.environment.text(name)
    return chosen.startswith("rmw_fastrtps") if chosen else runner.environment.defines(name) is False
