"""A script, unit or image takes a ROS distribution that no longer gets updates.

## What it finds
A shell script, unit or Dockerfile that installs (`ros-X-...`, `FROM ros:X`) or sources (`/opt/ros/X`) a distribution of
ROS 1, or one of ROS 2 whose end of life is before today, and names no other. Where the whole tree names one
distribution of ROS 2 only, env/ros-distro-eol reports it.

Silent for files that are for that distribution by their name or folder, for those of tests, simulation and development,
and for packages that are removed, held or marked. Info where all of the files are in folders for a release of Ubuntu,
such as `20.04`, are scripts that start a container with `docker run --rm` or write the Dockerfile for it, or are
Dockerfiles that nothing builds, and that start no node, in a tree that names a supported distribution as well.

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
from re import Match

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import docker
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

KEPT = regex(
    r"\b(?:apt-mark|(?:apt|apt-get|aptitude)\b[^\n;&|]{0,100}\b(?:purge|remove|autoremove|hold))\b[^\n;&|]{0,900}$",
    hints="apt",
)
"""A command that takes packages away, or marks those that are there."""
WRITTEN = regex(r"<<-?[ \t]*[\"']?(?P<end>\w{1,40})[^\n]{0,200}", hints="<<")
LONGEST = 1000
STARTS = regex(r"\bros2[\s\"',]{1,9}(?:launch|run)\b|\broslaunch\b|\brosrun\b", hints="ros")
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
                advice=_advice(robot),
                related=[note(other, "here too") for other in others[:20]],
                severity="info" if all(_is_apart(robot, each) for each in (first, *others)) else None,
            )


def _supported(robot: Robot) -> list[str]:
    """The distributions with updates that the tree names, the oldest first."""
    ends = {name: distro_end(name) for name in SECOND if name in robot.target.named}
    return [name for name, end in ends.items() if end is None or end >= robot.today]


def _advice(robot: Robot) -> str:
    newer = _supported(robot)
    if newer:
        return f"remove what is left over, or move it to {newer[-1].capitalize()}, which the tree names as well"
    return "plan the migration to a supported distribution"


def _is_apart(robot: Robot, place: Located) -> bool:
    """Whether a place is for one release of several, in a container that a script starts and throws away, or in a
    Dockerfile that nothing builds any more."""
    source = place.span.source
    if VERSION.search(source.name) or _is_written_for_tool(source, place.span.start):
        return True
    if source.kind == "dockerfile" and _supported(robot):
        files = [file for file in robot.dockerfiles if file.source is source]
        return not any(docker.is_used(robot.compose, file) or _starts_ros(robot, file) for file in files)
    runs = THROWN_AWAY.finditer(source.text) if source.kind == "shell-script" else ()
    started = [run.end() for run in runs if run.end() <= place.span.start]
    return bool(started) and _is_one_command(source.text[started[-1] : place.span.start])


def _starts_ros(robot: Robot, file: docker.Dockerfile) -> bool:
    """Whether the image runs nodes by itself: it may be for the robot, whoever builds it."""
    stages = file.stages[-1:]
    steps = (stage.last(name) for stage in stages for name in ("ENTRYPOINT", "CMD"))
    texts = [str(step.value) for step in steps if step is not None]
    runners = (runner for stage in stages for runner in robot.runners.of_stage(stage))
    texts += [text for runner in runners for line in runner.lines for text in line.texts]
    return any(STARTS.search(text) for text in texts)


def _is_written_for_tool(source: Source, start: int) -> bool:
    """Whether a place is in a Dockerfile that a script writes and builds, to start it with ``--rm``."""
    at = source.text.rfind("<<", 0, start) if source.kind == "shell-script" else -1
    written = WRITTEN.match(source.text, at) if at >= 0 else None
    if written is None or "Dockerfile" not in source.line_text(source.located(at, at).span.line):
        return False
    is_open = f"\n{written['end']}\n" not in source.text[at:start]
    return is_open and THROWN_AWAY.search(source.text) is not None


def _is_one_command(between: str) -> bool:
    """Whether a command goes on behind a text: on the same line, in quotes, or in a here-document."""
    line = between.replace("\\\n", " ").partition("\n")
    return not line[1] or "<<" in line[0] or any(between.count(sign) % 2 for sign in "\"'")


def _taken(source: Source) -> tuple[str, Located] | None:
    """The only distribution that a file names, where it installs or sources that."""
    found = TAKES.finditer(source.text)
    matches = (match for match in found if not _is_remark(source, match.start()) and not _is_kept(source, match))
    match = next(matches, None)
    if match is None or named_distros(source.name):
        return None
    name = match["sourced"] or match["package"] or match["image"]
    if named_distros(source.uncommented) != {name}:
        return None
    return name, source.located(*match.span())


def _is_kept(source: Source, match: Match[str]) -> bool:
    """Whether a command that installs nothing names a package."""
    if match["package"] is None:
        return False
    before = source.text[max(match.start() - LONGEST, 0) : match.start()].replace("\\\n", " ")
    return KEPT.search(before.rpartition("\n")[2]) is not None


def _is_remark(source: Source, start: int) -> bool:
    return REMARK.search(source.line_before(start)) is not None
