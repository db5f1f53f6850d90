"""A build step needs root after USER has given it up.

## What it finds
`apt-get`, `apt`, `dpkg -i`, `useradd` and the like, files that the shell writes below `/etc`, `/usr`, `/opt` or
`/root`, and what `mkdir`, `touch` or `tee` makes below `/root`, in a `RUN` after a `USER` that is not root, and `colcon
build` in a folder that WORKDIR, `mkdir` or a COPY without `--chown` made for root before. A build argument counts as
its default. Commands that run through sudo are not reported.
Where `|| true` hides the failure, the finding is a warning. After `RUN chown`, `chmod` or `setfacl` of a folder, writes
to it are not judged.

## Why it matters on a robot
The build stops with "Permission denied", so the robot keeps the old image. With `|| true` the image is built without
the package, and a node fails on the robot.

## Bad
```dockerfile
USER ros
RUN apt-get update && apt-get install -y ros-jazzy-nav2-bringup
```

## Good
```dockerfile
RUN apt-get update && apt-get install -y ros-jazzy-nav2-bringup
USER ros
```

## When to ignore it
When the user has the id 0 under another name.

## References
- https://docs.docker.com/reference/dockerfile/#user
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import Stage
from bringup_lint.api.docker import builds_of_others
from bringup_lint.api.docker import commands_of
from bringup_lint.api.docker import commands_of_run
from bringup_lint.api.docker import expanded
from bringup_lint.api.docker import last_user
from bringup_lint.api.docker import user_name
from bringup_lint.api.shell import Command

ACCOUNTS = ("useradd", "groupadd", "usermod", "adduser", "addgroup")
SYSTEM = regex(r"/(?:etc|usr|opt|root)/")
OF_ROOT = regex(r"/root/\S")
OF_ROBOT = regex(r"/opt/(?!ros/)[^/]+")
OPENS = ("chown", "chmod", "setfacl")
MAKES = ("mkdir", "touch", "tee")


@rule("error", symptoms=["Could not open lock file /var/lib/dpkg/lock-frontend", "are you root?"])
def build_without_root(robot: Robot) -> Iterator[Finding]:
    for file in robot.dockerfiles:
        for stage in file.stages:
            yield from _judged(stage)


def _judged(stage: Stage) -> Iterator[Finding]:
    user = _without_root(last_user(stage.base)) if stage.base else None
    opened = any(command.name in OPENS for base in list(stage.chain)[1:] for command in commands_of(base))
    unowned = {each.instruction: each for each in builds_of_others(stage)}
    for instruction in stage.all("USER", "RUN", "SHELL"):
        if instruction.name == "SHELL":
            return
        if instruction.name == "USER":
            user = _without_root(expanded(stage, instruction))
            continue
        commands = list(commands_of_run(instruction))
        opened = opened or any(command.name in OPENS for command in commands)
        found = (each for command in commands if (each := _needs_root(command, opened)))
        bad = next((each for each in found if not _is_given(stage, instruction.value, each)), None)
        if user is not None and bad is not None:
            yield _finding(bad, user, hidden=_hidden(commands))
        elif user is not None and not opened and (build := unowned.get(instruction)):
            yield finding(
                build.command,
                f"colcon runs as {user} in {build.folder}, which belongs to root: it cannot make 'build' there, and the"
                " build stops",
                advice="write COPY --chown, or build before USER",
                related=[note(build.made, "root makes the folder"), note(user, "the user of the steps after it")],
                confidence="medium",
            )


def _finding(bad: Located, user: Located, *, hidden: bool) -> Finding:
    consequence = "the failure is hidden and the image lacks its result" if hidden else "the build stops"
    what = f"{user} may not write {bad}" if bad.startswith("/") else f"'{bad}' runs as {user} and needs root"
    return finding(
        bad,
        f"{what}: {consequence}",
        advice="move it before USER, or switch to USER root for it",
        related=[note(user, "the user of the steps after it")],
        severity="warning" if hidden else None,
    )


def _without_root(user: Located | None) -> Located | None:
    """The user of USER, if it is known and not root."""
    return user if user and user_name(user) not in (None, "root") else None


def _needs_root(command: Command, opened: bool) -> Located | None:
    """The program, or the path that is written; nothing in functions, branches and loops, which may not run."""
    if command.depth or not command.words:
        return None
    words = command.words
    if command.name in ("apt", "apt-get") and {"install", "update", "upgrade", "remove", "purge"} & set(words):
        return words[0] if not {"-s", "--simulate", "--dry-run", "download"} & set(words) else None
    if command.name in ACCOUNTS or (command.name == "dpkg" and {"-i", "--install"} & set(words)):
        return words[0]
    if opened:
        return None
    writes = (redirect.target for redirect in command.redirects if redirect.target and redirect.writes)
    made = words[1:] if command.name in MAKES else ()
    found = next((path for path in writes if SYSTEM.match(path)), None)
    return found or next((word for word in made if OF_ROOT.match(word)), None)


def _is_given(stage: Stage, run: str, path: Located) -> bool:
    """Whether a folder below /opt is spoken of before, so that it may belong to the user."""
    folder = OF_ROBOT.match(path)
    others = (each for one in stage.chain for each in one.instructions if each.value is not run)
    return folder is not None and any(folder[0] in str(each.value) for each in others)


def _hidden(commands: list[Command]) -> bool:
    """Whether the failure of the step does not end it."""
    return any(command.ends in ("||", ";", "\n") for command in commands[:-1])
