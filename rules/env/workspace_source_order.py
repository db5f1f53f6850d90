"""The workspace is sourced before the distribution.

## What it finds
A shell that sources `local_setup.*` of a workspace, or a file of `devel/`, first and `/opt/ros/<distro>/setup.*` after
it: in a unit, in the command or entry script of a container, in a script of the tree, or in the `.bashrc` to which a
script or a Dockerfile adds both. `install/setup.*` is not meant: it sources the distribution itself before the
workspace, and a path that is there already is not put first again.

## Why it matters on a robot
Each setup file puts its own paths first. If the distribution is sourced last, it hides every package of which the
workspace has a modified copy: the robot silently runs the released navigation stack instead of the patched one.

## Bad
```bash
source /opt/rover/install/local_setup.bash
source /opt/ros/jazzy/setup.bash
```

## Good
```bash
source /opt/ros/jazzy/setup.bash
source /opt/rover/install/local_setup.bash
```

## When to ignore it
When the workspace has no package that also exists in the distribution. The order is still fragile.

## References
- ROS 2 documentation, "Creating a workspace": overlay and underlay
- colcon-core, `_prepend_unique_value`; ament_package, `ament_prepend_unique_value`
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
from bringup_lint.api.docker import Runner
from bringup_lint.api.systemd import Step

ALONE = regex(r"(?:^|/)(?:local_setup|devel/(?:local_)?setup)\.\w+$")
"""The setup file of a workspace that does not source the distribution below it, or that the next one undoes."""

ADDED = regex(
    r"^(?![ \t]*#)[^\n#]*?\becho[ \t]+(?:-e[ \t]+)?[\"']?(?:source|\.)[ \t]+"
    r"(?P<setup>[^\s\"';&|]{1,200}?setup\.(?:ba|z)?sh)[\"']?[ \t]*>>[ \t]*"
    r"(?P<file>[^\s\"';&|]{0,100}\.(?:bash|zsh)rc)\b",
    re.M,
    hints="setup.",
)
"""A line that a command adds to the file of a login shell."""


@rule(
    "warning",
    silent="the package of the distribution is started instead of the one of the workspace, without a message",
)
def workspace_source_order(robot: Robot) -> Iterator[Finding]:
    if not robot.may_hold("setup."):
        return
    seen = set()
    for runner in robot.runners.all:
        for line in runner.lines:
            workspace = None
            for step, word in line.setup_files:
                if not word.startswith("/opt/ros/"):
                    workspace = workspace or ((step, word) if ALONE.search(word) else None)
                elif workspace and word.span not in seen and _is_last(runner, line.setup_files, workspace[0], step):
                    seen.add(word.span)
                    apart = [note(line.program, f"{runner.name} starts it here")] if _is_apart(runner, step) else []
                    yield finding(
                        word,
                        f"{word} is sourced last and hides the packages of {workspace[1]} that exist in both",
                        advice="source the distribution first, then the workspace",
                        related=[note(workspace[1], "the workspace is sourced here"), *apart],
                    )
                    break
    yield from _login_files(robot)


def _login_files(robot: Robot) -> Iterator[Finding]:
    """The files of login shells to which scripts and build steps add lines."""
    for source in robot.of_kind("shell-script", "dockerfile"):
        if not source.judged or source.template:
            continue
        added: dict[str, list[Located]] = {}
        for line in ADDED.finditer(source.text):
            added.setdefault(line["file"], []).append(source.located(*line.span("setup")))
        for file, words in added.items():
            workspace = next((word for word in words if ALONE.search(word) and not _is_distribution(word)), None)
            if workspace is None or not _is_distribution(words[-1]):
                continue
            yield finding(
                words[-1],
                f"{words[-1]} comes last in {file} and hides the packages of {workspace} that exist in both",
                advice="source the distribution first, then the workspace",
                related=[note(workspace, "the workspace is sourced here")],
            )


def _is_distribution(word: str) -> bool:
    return word.startswith("/opt/ros/")


def _is_last(runner: Runner, found: list[tuple[Step, Located]], workspace: Step, distribution: Step) -> bool:
    """Whether both are sourced in any case, and the workspace is not sourced once more afterwards. What is not a unit
    has to do both in one shell: a shell in it begins anew."""
    if runner.unit is None and (workspace.depth, workspace.script) != (distribution.depth, distribution.script):
        return False
    after = found[[step for step, _ in found].index(distribution) + 1 :]
    certain = workspace.command.depth == 0 and distribution.command.depth == 0
    return certain and all(word.startswith("/opt/ros/") for _, word in after)


def _is_apart(runner: Runner, step: Step) -> bool:
    """Whether the step is in a file that the runner starts, and not in that of the runner."""
    return step.script is not None and step.script is not runner.source
