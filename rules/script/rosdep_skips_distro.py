"""rosdep update leaves out the distribution of the robot.

## What it finds
`rosdep update` without `--include-eol-distros` and without `--rosdistro`, followed by `rosdep install`, in a script or
Dockerfile for a distribution that gets no more updates: it installs (`ros-X-...`, `FROM ros:X`) or sources
(`/opt/ros/X`) it, and names no other one. Silent where ROSDISTRO_INDEX_URL names another list of distributions.

## Why it matters on a robot
rosdep downloads nothing for a distribution whose end of life is over ("Skip end-of-life distro"), also where
ROS_DISTRO is set, and forgets what it had. `rosdep install` then finds none of the packages of ROS that are not
installed yet: it ends with an error, or goes on without them with `-r`, and the build or the node fails later.

## Bad
```dockerfile
FROM ros:foxy
RUN rosdep update && rosdep install --from-paths src --ignore-src -y
```

## Good
```dockerfile
FROM ros:foxy
RUN rosdep update --rosdistro foxy && rosdep install --from-paths src --ignore-src -y
```

## When to ignore it
When all packages of ROS that the workspace needs are installed before.

## References
- rosdep, src/rosdep2/sources_list.py, `update_sources_list()`
- https://github.com/ros-infrastructure/rosdep/issues/816
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
from bringup_lint.api.docker import Dockerfile
from bringup_lint.api.docker import commands_of
from bringup_lint.api.ros import distro_end
from bringup_lint.api.ros import distro_names
from bringup_lint.api.ros import named_distros
from bringup_lint.api.shell import program_name
from bringup_lint.api.shell import unwrapped

NAMES = "|".join(distro_names())
TAKES = regex(rf"/opt/ros/(?:{NAMES})\b|\bros-(?:{NAMES})-\w|\bros:(?:{NAMES})\b|\bROS_DISTRO[=:][\"']?(?:{NAMES})\b")
CHOOSES = ("--include-eol", "--rosdistro")


@rule("warning", symptoms=['Skip end-of-life distro "*"', "Cannot locate rosdep definition for [*]"])
def rosdep_skips_distro(robot: Robot) -> Iterator[Finding]:
    calls: dict[Source, list[tuple[Located, ...]]] = {}
    for file in robot.dockerfiles:
        chosen = any(robot.compose.images.is_chosen(stage, tag=True) for stage in file.stages)
        if file.source.judged and not chosen:
            calls[file.source] = list(_calls(file))
    for source, run in robot.scripts.run("rosdep"):
        calls.setdefault(source, []).append(run.words)
    for source, found in calls.items():
        updates = [words for words in found if "update" in words]
        installs = [words for words in found if "install" in words]
        if not updates or not installs or any(word.startswith(CHOOSES) for words in updates for word in words):
            continue
        name = _distro(source)
        end = distro_end(name)
        first, last = updates[0][0], installs[-1][0]
        if end is not None and end < robot.today and first.span.start < last.span.start:
            yield finding(
                first,
                f"rosdep update leaves out {name}, which has had no updates since {end:%B %Y}: rosdep does not find "
                "its packages",
                advice=f"write rosdep update --rosdistro {name}",
                related=[note(last, "needs them")],
            )


def _calls(file: Dockerfile) -> Iterator[tuple[Located, ...]]:
    for stage in file.stages:
        for command in commands_of(stage):
            words = unwrapped(command.words)
            if words and program_name(words[0]) == "rosdep":
                yield words


def _distro(source: Source) -> str:
    """The only distribution that a file names, where it installs or sources that."""
    names = named_distros(f"{source.name} {source.uncommented}")
    is_known = TAKES.search(source.uncommented) and "ROSDISTRO_INDEX_URL" not in source.uncommented
    return names.pop() if len(names) == 1 and is_known else ""
