"""An image gets the links of a workspace, and not what they lead to.

## What it finds
- `COPY --from=STAGE .../install` where the stage builds the workspace with `colcon build --symlink-install`, and
  nothing brings the folder `build` of the workspace to the same place;
- `rm -r` of the folder `src` or `build` of a workspace that a step of the image has built in this way, while `install`
  stays.

Silent where the stage replaces the links by files; info where a step makes the folder again, as a place at which
sources are mounted, no image that is built on it names a program to start, and each service that runs one has a mount
there.

## Why it matters on a robot
`--symlink-install` fills `install/` with links into `build/` and `src/` of the workspace. COPY keeps them as links: in
the image they lead nowhere, and ros2 finds neither the programs nor the launch files. The same happens when an image
that has been built removes the sources to become smaller.

## Bad
```dockerfile
FROM ros:jazzy AS build
RUN . /opt/ros/jazzy/setup.sh && colcon build --symlink-install
FROM ros:jazzy-ros-core
COPY --from=build /ws/install /ws/install
```

## Good
```dockerfile
FROM ros:jazzy AS build
RUN . /opt/ros/jazzy/setup.sh && colcon build
FROM ros:jazzy-ros-core
COPY --from=build /ws/install /ws/install
```

## When to ignore it
When the workspace is mounted at the same path in each container.

## References
- https://colcon.readthedocs.io/en/released/reference/verb/build.html, "--symlink-install"
- https://docs.docker.com/reference/dockerfile/, "COPY"
"""

import posixpath
from collections.abc import Iterator
from collections.abc import Sequence

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.compose import Volume
from bringup_lint.api.docker import Dockerfile
from bringup_lint.api.docker import Instruction
from bringup_lint.api.docker import Stage
from bringup_lint.api.docker import commands_of_run
from bringup_lint.api.docker import expanded
from bringup_lint.api.shell import Command

LINKS = "--symlink-install"
REPLACED = regex(
    r"\bcp[ \t]+(?:-\w+[ \t]+){0,3}-\w{0,6}L|--dereference|--copy-links|\breadlink\b|-type l\b",
    hints="cp dereference copy-links readlink type",
)
"""What puts files in the place of links."""
MOST_DIGITS = 4
RECURSIVE = regex(r"-\w*[rR]\w*|--recursive")
REMOVES = regex(r"\brm\b(?:(?!\brm\b)[^\n;&|])*\b(?:src|build)\b", hints="rm")
AGAIN = ("colcon", "git", "vcs")
"""What builds once more, or brings sources once more: only what is removed after it is missing at the end."""


@rule("error", silent="the copy succeeds, and what looks for a file later only says that it is not there")
def links_left_behind(robot: Robot) -> Iterator[Finding]:
    for file in robot.dockerfiles:
        links: dict[Stage, Located | None] = {}
        for stage in file.stages:
            copies = [(copy, origin) for copy in stage.all("COPY") if (origin := _origin(file, copy)) is not None]
            for _, origin in copies:
                if origin not in links:
                    links[origin] = _link(origin)
            brought = {word for one in stage.chain for each in one.all("COPY") for word in _brought(each)}
            for copy, origin in copies:
                link = links[origin]
                if link is not None and origin not in stage.chain:
                    yield from _of_copy(copy, link, brought)
            yield from _of_removal(robot, file, stage)


def _origin(file: Dockerfile, copy: Instruction) -> Stage | None:
    """The stage that files are copied from."""
    name = next((flag.partition("=")[2] for flag in copy.flags if flag.startswith("--from=")), "")
    if name.isdecimal():
        return file.stages[int(name)] if len(name) <= MOST_DIGITS and int(name) < len(file.stages) else None
    return file.stage(name)


def _of_copy(copy: Instruction, link: Located, brought: set[str]) -> Iterator[Finding]:
    word = next(
        (word for word in list(copy.value.words())[:-1] if posixpath.basename(word.rstrip("/")) == "install"), None
    )
    if word is None:
        return
    workspace = posixpath.dirname(word.rstrip("/")) or "/"
    if not brought.isdisjoint((workspace, posixpath.join(workspace, "build"), posixpath.dirname(workspace))):
        return
    yield finding(
        word,
        f"The links in install/ lead to {posixpath.join(workspace, 'build')} and src, which this image does not have",
        advice="build without --symlink-install, or copy the whole workspace to the same path",
        related=[note(link, "makes links instead of files")],
    )


def _link(stage: Stage) -> Located | None:
    """The option by which every build of a workspace in a stage makes links."""
    steps = [step for one in stage.chain for step in one.all("RUN")]
    if any(REPLACED.search(text) for step in steps for text in step.scripts):
        return None
    builds = [each.words for step in steps for each in commands_of_run(step) if each.words[:2] == ("colcon", "build")]
    options = [next((word for word in words if word == LINKS), None) for words in builds]
    return options[0] if options and None not in options else None


def _brought(copy: Instruction) -> list[str]:
    """What an instruction brings from another stage."""
    words = [word.rstrip("/") or "/" for word in list(copy.value.words())[:-1]]
    return words if any(flag.startswith("--from=") for flag in copy.flags) else []


def _of_removal(robot: Robot, file: Dockerfile, stage: Stage) -> Iterator[Finding]:
    """The first removal of what the links of a workspace of the stage lead to."""
    may_remove = any(REMOVES.search(text) for each in stage.all("RUN") for text in each.scripts)
    link = _link(stage) if may_remove else None
    if link is None:
        return
    steps = list(_steps(stage))
    built = {folder for command, folder in steps if command.words[:2] == ("colcon", "build")}
    last = max((at for at, (command, _) in enumerate(steps) if command.name in AGAIN), default=0)
    removed = [(word, path) for command, folder in steps[last:] for word, path in _removed(command, folder)]
    gone = {path for _, path in removed}
    made = {_entered(folder, word) for command, folder in steps[last:] for word in _made(command)}
    broken = [(word, path) for word, path in removed if _is_linked_to(path, built, gone)]
    for word, path in sorted(broken, key=lambda each: each[1] in made)[:1]:
        yield finding(
            word,
            f"The links in install/ lead to {path}, which this step removes",
            advice="build without --symlink-install, or keep the folder",
            related=[note(link, "makes links instead of files")],
            severity="info" if path in made and _waits_for_mount(robot, file, stage, path) else None,
        )


def _waits_for_mount(robot: Robot, file: Dockerfile, stage: Stage, path: str) -> bool:
    """Whether nothing that the tree says of an image starts it without a mount on a folder or around it."""
    above = [each for each in file.stages if stage in each.chain]
    if any(each.last(name) is not None for each in above for name in ("CMD", "ENTRYPOINT")):
        return False
    services = (service for each in above for service in robot.compose.users(each))
    return all(any(_brings(volume, path) for volume in service.volumes) for service in services)


def _brings(volume: Volume, path: str) -> bool:
    """Whether a volume is a folder of the host at a path, or around it."""
    target = str(volume.target or "").rstrip("/")
    return str(volume.source or "").startswith((".", "/", "~", "$")) and f"{path}/".startswith(f"{target}/")


def _is_linked_to(path: str, built: set[str], gone: set[str]) -> bool:
    """Whether links of a workspace that stays lead to a folder."""
    workspace, name = posixpath.split(path)
    return name in ("src", "build") and workspace in built and posixpath.join(workspace, "install") not in gone


def _made(command: Command) -> Sequence[str]:
    return command.words[1:] if command.name == "mkdir" else ()


def _steps(stage: Stage) -> Iterator[tuple[Command, str]]:
    """The commands of a stage and of those that it builds on, each with the folder in which it runs, as written."""
    folder = "/"
    for one in reversed(list(stage.chain)):
        for each in one.instructions:
            if each.name == "WORKDIR":
                folder = _entered(folder, expanded(one, each).strip("\"'"))
            elif each.name == "RUN":
                here = folder
                for command in commands_of_run(each):
                    if command.name == "cd" and len(command.words) > 1:
                        here = _entered(here, command.words[1])
                    yield command, here


def _entered(folder: str, path: str) -> str:
    return posixpath.normpath(path if path.startswith(("$", "~")) else posixpath.join(folder, path))


def _removed(command: Command, folder: str) -> Iterator[tuple[Located, str]]:
    words = command.words[1:]
    if command.name == "rm" and any(RECURSIVE.fullmatch(word) for word in words):
        yield from ((word, _entered(folder, word)) for word in words if not word.startswith("-"))
