"""The selected middleware does not read the given configuration.

## What it finds
A process whose environment selects one middleware but configures only the other. CYCLONEDDS_URI with Fast DDS,
which also runs on Humble to Kilted when RMW_IMPLEMENTATION is not set. A Fast DDS profile with Cyclone DDS. Also lines
of a script, one after the other, that export both, where it chooses a middleware nowhere else. Not
reported: an image without RMW_IMPLEMENTATION that nothing of the tree runs; whoever runs it may set the variable. What
an image sets for the middleware that a compose file replaces is an info.

## Why it matters on a robot
The file is never read. The robot runs with the defaults: multicast discovery on every interface, no peers, no
limits.

## Bad
```sh
RMW_IMPLEMENTATION=rmw_fastrtps_cpp
CYCLONEDDS_URI=file:///etc/robot/cyclonedds.xml
```

## Good
```sh
RMW_IMPLEMENTATION=rmw_cyclonedds_cpp
CYCLONEDDS_URI=file:///etc/robot/cyclonedds.xml
```

## When to ignore it
When the variable is set for other processes that inherit this environment and select the other middleware
themselves.

## References
- https://docs.ros.org/en/rolling/How-To-Guides/Working-with-multiple-RMW-implementations.html
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.ros import at_least

NAMES = r"RMW_IMPLEMENTATION|CYCLONEDDS_URI|FAST(?:RTPS|DDS)_DEFAULT_PROFILES_FILE"
EXPORTS = regex(rf"(?:^[ \t]*(?:#|(?:export[ \t]+)?(?:{NAMES})=)[^\n]*\n){{2,8}}", re.M)
SETTING = regex(r"^[ \t]*(?:export[ \t]+)?(?P<name>\w+)=[\"']?(?P<value>[^\"'\s;]+)", re.M)
FASTDDS = ("FASTRTPS_DEFAULT_PROFILES_FILE", "FASTDDS_DEFAULT_PROFILES_FILE")


@rule("warning", silent="a middleware does not look at the variables of another one")
def rmw_config_mismatch(robot: Robot) -> Iterator[Finding]:
    if not robot.may_hold("CYCLONEDDS_URI", "DEFAULT_PROFILES_FILE"):
        return
    said = set()
    for process in robot.ros.processes:
        environment = process.environment
        if not environment.complete:
            continue
        rmw = environment.get("RMW_IMPLEMENTATION")
        cyclone = environment.get("CYCLONEDDS_URI")
        fast = next((found for name in FASTDDS if (found := environment.get(name))), None)
        if bool(cyclone) == bool(fast) or (rmw and rmw.text is None):
            continue
        if rmw is None and process.runner is not None and process.runner.kind.name == "IMAGE":
            continue
        name = rmw.text if rmw and rmw.text else _default(robot)
        unread = (
            cyclone
            if cyclone and name and "fastrtps" in name
            else fast
            if fast and name and "cyclone" in name
            else None
        )
        if unread is not None:
            said.add(unread.value.span)
            yield finding(
                unread.value,
                f"{process.name} runs {name}, which does not read {unread.name}: it runs with the defaults",
                advice="set RMW_IMPLEMENTATION to the middleware that the file is for",
                related=[note(rmw.value, "the middleware is selected here")]
                if rmw
                else [note(process.where, "sets no RMW_IMPLEMENTATION")],
                severity="info" if rmw and _is_left_over(rmw.value, unread.value) else None,
            )
    yield from (each for each in _in_scripts(robot) if each.span not in said)


def _in_scripts(robot: Robot) -> Iterator[Finding]:
    """What lines of a script that belong together set for another middleware than the one that they choose."""
    for source in robot.of_kind("shell-script"):
        if not source.judged or source.text.count("RMW_IMPLEMENTATION=") != 1:
            continue
        for lines in EXPORTS.finditer(source.text):
            found = {each["name"]: each for each in SETTING.finditer(lines[0])}
            place = {
                name: source.located(*(lines.start() + at for at in each.span("value"))) for name, each in found.items()
            }
            rmw = place.get("RMW_IMPLEMENTATION")
            fast = next((place[name] for name in FASTDDS if name in place), None)
            cyclone = place.get("CYCLONEDDS_URI")
            other = {"rmw_fastrtps_cpp": cyclone, "rmw_cyclonedds_cpp": fast}.get(str(rmw))
            read = FASTDDS if other is cyclone else ("CYCLONEDDS_URI",)
            if rmw is not None and other is not None and not any(name in source.text for name in read):
                yield finding(
                    other,
                    f"{rmw} does not read {'CYCLONEDDS_URI' if other is cyclone else 'this profile'}: it runs with the "
                    "defaults",
                    advice="set RMW_IMPLEMENTATION to the middleware that the file is for",
                    related=[note(rmw, "the middleware is selected here")],
                )


def _is_left_over(chosen: Located, unread: Located) -> bool:
    """Whether an image configures the middleware that it has by default, and a compose file chooses another one."""
    return chosen.span.source.kind == "compose" and unread.span.source.kind == "dockerfile"


def _default(robot: Robot) -> str | None:
    """The middleware of the distribution when none is selected."""
    usual = at_least(robot.target.ros, "humble") and not at_least(robot.target.ros, "lyrical")
    return "rmw_fastrtps_cpp" if usual else None
