"""A command line names a file that is called otherwise, or that lies elsewhere.

## What it finds
- A path of a settings file (`.yaml`, `.json`, `.xml`, `.conf` and the like) among the arguments of an Exec line, for
  which the tree ships no file and makes none, in a folder of the robot for which it ships a file of nearly the same
  name.
- A path of any file below /usr, /opt, /etc or /srv that a script of the tree installs in another folder there, and
  nowhere else.

## Why it matters on a robot
The program exits when it cannot open the file, or runs with its defaults: a bridge without its allow list, a driver
with the speed of another motor. The unit file and the installation script both look right by themselves.

## Bad
```ini
# the installation script copies bridge.json5 to /etc/rover/
ExecStart=/usr/bin/zenoh-bridge-ros2dds -c /etc/rover/bridge.json
```

## Good
```ini
ExecStart=/usr/bin/zenoh-bridge-ros2dds -c /etc/rover/bridge.json5
```

## When to ignore it
When another repository installs the file, or a program makes it at its first start.

## References
- systemd.service(5), "Command lines"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule

SETTINGS = regex(
    r"(?:[\w.-]+:?=|file:)?(?P<path>/(?:etc|opt|srv|home|usr/local|var/lib)/[\w./@-]+"
    r"\.(?:ya?ml|json5?|xml|conf|cfg|ini|toml|rviz|urdf|lua))"
)

FILE = regex(r"/[\w./@-]+\.\w+")


@rule(
    "warning",
    confidence="medium",
    symptoms=["Failed to open configuration file"],
)
def exec_file_missing(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.services:
        for process in robot.units.processes(unit):
            for word in (word for step in process.steps for word in step.command.words[1:]):
                found = SETTINGS.fullmatch(word)
                path = word.part(found.start("path"), found.end("path")) if found else word
                sibling = _other(robot, path, is_setting=found is not None)
                if sibling and word.span.source in (file.source for file in unit.files):
                    yield finding(
                        path,
                        f"The tree has {sibling} but not {path}: {process.key}= of {unit.name} names a file "
                        "that is missing unless something else installs it",
                        advice=f"name {sibling}, or ship the file",
                    )


def _other(robot: Robot, path: str, *, is_setting: bool) -> str | None:
    """The file that the tree has instead of the one that is named."""
    if is_setting:
        return robot.filesystem.shipped_sibling(path)
    return robot.filesystem.installed_elsewhere(path) if FILE.fullmatch(path) else None
