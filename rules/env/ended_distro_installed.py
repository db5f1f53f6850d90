"""A script, unit or image takes a ROS distribution that no longer gets updates.

## What it finds
A shell script, unit or Dockerfile that installs (`ros-X-...`, `FROM ros:X`) or sources (`/opt/ros/X`) a distribution of
ROS 1, or one of ROS 2 whose end of life is before today, and names no other. Where the whole tree names one
distribution of ROS 2 only, env/ros-distro-eol reports it.

Silent for files that are for that distribution by their name or folder, and for those of tests, simulation and
development. Info where all of the files are in folders for a release of Ubuntu, such as `20.04`, or scripts that start
a container with `docker run --rm`.

## Why it matters on a robot
Security holes stay open, the Ubuntu release that the distribution is built for ends with it, and the package server
removes what it has: a robot that must be installed again cannot be.

## Bad
```sh
source /opt/ros/noetic/setup.bash
```

## Good
```sh
source /opt/ros/jazzy/setup.bash
```

## When to ignore it
When you get security updates from a vendor with extended support, or the robot has no network.

## References
- REP 3 and REP 2000
- https://wiki.ros.org/Distributions
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.ros import distro_end
from bringup_lint.api.ros import distros_since
from bringup_lint.api.ros import named_distros
from bringup_lint.api.ros import ros1

FIRST = ros1()
SECOND = distros_since("foxy")
NAMES = "|".join((*FIRST, *SECOND))
TAKES = regex(
    rf"/opt/ros/(?P<sourced>{NAMES})\b|\bros-(?P<package>{NAMES})-\w"
    rf"|\bFROM[ \t]{{1,8}}\S{{0,80}}?\bros:(?P<image>{NAMES})\b",
    hints=" ".join((*FIRST, *SECOND)),
)
REMARK = regex(r"(?:^|[ \t])#")
KINDS = ("shell-script", "systemd-unit", "dockerfile")
VERSION = regex(r"(?:^|[/._-])(?:1[4-9]|2\d)\.(?:04|10)/")
"""A folder for one release of Ubuntu, kept beside those for others."""

THROWN_AWAY = regex(r"\bdocker[ \t]+run\b[^\n]{0,200}[ \t]--rm\b", hints="docker")


@rule("warning", tags=["CWE-1104"], symptoms=['Skip end-of-life distro "*"'])
def ended_distro_installed(robot: Robot) -> Iterator[Finding]:
    if not robot.may_hold("ros"):
        return
    found: dict[str, list[Located]] = {}
    for source in robot.of_kind(*KINDS):
        if source.judged and source.origin is None and not robot.ros.is_development(source.span(0, 0)):
            taken = _taken(source)
            if taken is not None and taken[0] != robot.target.ros:
                found.setdefault(taken[0], []).append(taken[1])
    for name, (first, *others) in found.items():
        end = distro_end(name)
        if end is not None and end < robot.today:
            yield finding(
                first,
                f"ROS {'' if name in FIRST else '2 '}{name.capitalize()} has had no updates since {end:%B %Y}, "
                "not even security fixes",
                advice="plan the migration to a supported distribution",
                related=[note(other, "here too") for other in others[:20]],
                severity="info" if all(map(_is_apart, (first, *others))) else None,
            )


def _is_apart(place: Located) -> bool:
    """Whether a place is for one release of several, or in a container that a script starts and throws away."""
    source = place.span.source
    if VERSION.search(source.name):
        return True
    runs = THROWN_AWAY.finditer(source.text) if source.kind == "shell-script" else ()
    started = [run.end() for run in runs if run.end() <= place.span.start]
    return bool(started) and _is_one_command(source.text[started[-1] : place.span.start])


def _is_one_command(between: str) -> bool:
    """Whether a command goes on behind a text: on the same line, in quotes, or in a here-document."""
    line = between.replace("\\\n", " ").partition("\n")
    return not line[1] or "<<" in line[0] or any(between.count(sign) % 2 for sign in "\"'")


def _taken(source: Source) -> tuple[str, Located] | None:
    """The only distribution that a file names, where it installs or sources that."""
    matches = (match for match in TAKES.finditer(source.text) if not _is_remark(source, match.start()))
    match = next(matches, None)
    if match is None or named_distros(source.name):
        return None
    name = match["sourced"] or match["package"] or match["image"]
    if named_distros(source.uncommented) != {name}:
        return None
    return name, source.located(*match.span())


def _is_remark(source: Source, start: int) -> bool:
    return REMARK.search(source.line_before(start)) is not None
