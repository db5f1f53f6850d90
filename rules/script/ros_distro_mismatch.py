"""A script sets up one distribution of ROS and takes the setup file of another.

## What it finds
In a script that installs packages of one distribution only (`apt install ros-jazzy-...`) or assigns only one to
`ROS_DISTRO`: `source /opt/ros/OTHER/setup.bash`, also in a line that it adds to a file, such as `~/.bashrc`.

Silent where the script names the other distribution anywhere else, where it looks whether the file is there, where the
two are in different branches of an `if` or `case`, and where it takes the setup files of both one after the other.
ROS 1 beside ROS 2 is meant, for a bridge.

## Why it matters on a robot
After an upgrade half of the lines still name the old release. The file does not exist on a new robot: no shell finds
`ros2`, and what the script builds afterwards fails. On an old one, nodes start with the libraries of both releases.

## Bad
```sh
sudo apt-get install -y ros-jazzy-ros-base
echo "source /opt/ros/humble/setup.bash" >> ~/.bashrc
```

## Good
```sh
sudo apt-get install -y ros-jazzy-ros-base
echo "source /opt/ros/jazzy/setup.bash" >> ~/.bashrc
```

## When to ignore it
When another step installs the second distribution.

## References
- REP 2000, releases and target platforms
"""

import re
from bisect import bisect_right
from collections.abc import Iterable
from collections.abc import Iterator
from collections.abc import Sequence
from operator import itemgetter

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.ros import distros_since
from bringup_lint.api.shell import Block
from bringup_lint.api.shell import shell_blocks

ROS_1 = ("noetic", "melodic")
DISTROS = "|".join((*distros_since("foxy"), *ROS_1))
SET = regex(
    rf"^[ \t]*(?:(?:export|readonly|local)[ \t]+)?ROS2?_DISTRO=[\"']?(?P<distro>{DISTROS})[\"']?[ \t]*(?:#.*)?$", re.M
)
APT = regex(r"^[^#\n]{0,200}?\bapt(?:-get)?[ \t](?P<words>(?:[^\\\n]|\\\n){0,2000})", re.M)
"""A line of apt with those that continue it, taken once."""
PACKAGE = regex(rf"\bros-(?P<distro>{DISTROS})-")
SOURCED = regex(
    r"^(?P<before>[^#\n]{0,200}?)(?:\bsource|(?<![\w.])\.)[ \t]+[\"']?"
    rf"/opt/ros/(?P<distro>{DISTROS})/[\w/]{{0,80}}setup\.\w+",
    re.M,
)
TESTED = regex(r"\bif\b|\[|&&|\|\||\bcase\b|\btest\b|\)[ \t]")


@rule("warning", symptoms=["/opt/ros/*/setup.bash: No such file or directory"])
def ros_distro_mismatch(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        if source.judged and "/opt/ros/" in source.text and not source.template:
            yield from _in_script(source)


def _in_script(source: Source) -> Iterator[Finding]:
    found = _set_up(source.text)
    if len(found) != 1:
        return
    ((distro, setup),) = found.items()
    sourced = list(SOURCED.finditer(source.text))
    others = [match for match in sourced if match["distro"] != distro]
    if not others or any(TESTED.search(match["before"]) for match in others) or _has_both(sourced):
        return
    places = sorted(_places(shell_blocks(source)))
    if {_branch(places, match.start("distro")) for match in others} != {_branch(places, setup[0])}:
        return
    names = {match["distro"] for match in others}
    if any((name in ROS_1) != (distro in ROS_1) for name in names):
        return
    said = sum(len(re.findall(rf"\b{re.escape(name)}\b", source.uncommented)) for name in names)
    if said == len(others):
        first, *rest = (source.located(*match.span("distro")) for match in others)
        yield finding(
            first,
            f"The script sets up {distro}, and takes the setup file of {first}: it does not exist on a new robot",
            advice=f"write {distro}",
            related=[
                note(source.located(*setup), f"{distro} is set up here"),
                *(note(each, "here too") for each in rest),
            ],
        )


def _set_up(text: str) -> dict[str, tuple[int, int]]:
    """The distributions that a script sets up, each with the last place that says so."""
    spans = [match.span("distro") for match in SET.finditer(text)]
    for apt in APT.finditer(text):
        spans += [match.span("distro") for match in PACKAGE.finditer(text, *apt.span("words"))]
    return {text[start:end]: (start, end) for start, end in sorted(spans)}


def _has_both(sourced: Iterable[re.Match[str]]) -> bool:
    """Whether the script itself takes the setup files of several distributions."""
    return len({match["distro"] for match in sourced if not match["before"].strip()}) > 1


def _places(blocks: Iterable[Block], branch: tuple[int, ...] = ()) -> Iterator[tuple[int, tuple[int, ...]]]:
    """Where each command begins, with the branches that it is in."""
    for block in blocks:
        if block.command is not None:
            words = (*block.command.assignments, *block.command.words)
            yield from ((word.span.start, branch) for word in words[:1])
        yield from _places(block.condition, branch)
        for body in block.bodies:
            yield from _places(body, (*branch, id(body)) if block.kind == "branches" else branch)


def _branch(places: Sequence[tuple[int, tuple[int, ...]]], at: int) -> tuple[int, ...]:
    """The branches that a place in the script is in: those of the last command that begins before it."""
    before = bisect_right(places, at, key=itemgetter(0))
    return places[before - 1][1] if before else ()
