"""A container executes a script that is not executable.

## What it finds
A script of the tree that a container starts by its path, and that is not executable in the repository. COPY keeps the
mode, and a bind mount shows it. Scripts that a `chmod` of the tree names, or that `COPY --chmod` copies, folders with
a documentation that names `chmod`, and checkouts without executable scripts are not reported.

## Why it matters on a robot
The container ends at once with "permission denied" (exit code 126). With a restart policy it does so forever.

## Bad
```yaml
volumes:
  - ./entrypoint.sh:/entrypoint.sh
entrypoint: /entrypoint.sh
```
where git has `entrypoint.sh` with mode 100644.

## Good
```sh
git update-index --chmod=+x entrypoint.sh
```

## When to ignore it
When a step outside of the repository makes the script executable.

## References
- https://docs.docker.com/reference/dockerfile/#copy---chown---chmod
- git-update-index(1), --chmod
"""

import os
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import Runner

CHMOD = regex(r"\b(?:chmod|--chmod)\b")


@rule(
    "warning",
    confidence="medium",
    symptoms=[
        "exec *: permission denied",
        "exited with code 126",
        "exec: *: permission denied",
        "OCI runtime create failed: *: permission denied",
    ],
)
def script_not_executable(robot: Robot) -> Iterator[Finding]:
    tree = robot.files.tree
    if not tree.keeps_modes:
        return
    found: dict[Source, tuple[Located, list[Runner]]] = {}
    for runner, program, script in _started(robot):
        if not tree.is_executable(script.name) and not _is_changed(robot, runner, script):
            found.setdefault(script, (program, []))[1].append(runner)
    for script, (program, runners) in found.items():
        first, *others = runners
        yield finding(
            program,
            f"{script.name} is not executable: {first.name} ends with 'permission denied'",
            advice=f"make it executable: git update-index --chmod=+x {script.name}",
            related=[note(other.where, f"{other.name} too") for other in others],
        )


def _started(robot: Robot) -> Iterator[tuple[Runner, Located, Source]]:
    """The containers whose first process is a script of the tree."""
    for runner in robot.runners.in_containers:
        for line in runner.main:
            script = runner.reads(str(line.program))
            if script is not None and script.text.startswith("#!"):
                yield runner, line.program, script


def _is_changed(robot: Robot, runner: Runner, script: Source) -> bool:
    """Whether the image, or a script of the tree, changes the mode."""
    stages = runner.stage.chain if runner.stage is not None else ()
    built = (instruction for stage in stages for instruction in stage.instructions)
    if any(CHMOD.search(f"{' '.join(each.flags)} {each.value}") for each in built):
        return True
    if any(script.basename in word for _, run in robot.scripts.run("chmod", "install") for word in run.words):
        return True
    return any("chmod" in text for text in _instructions(robot, script))


def _instructions(robot: Robot, script: Source) -> Iterator[str]:
    """What the documentation beside the script says."""
    tree = robot.files.tree
    for path in tree.walked_in(os.path.dirname(script.absolute)):
        page = tree.read(path, judged=False) if path.endswith((".md", ".rst", ".txt")) else None
        yield page.text if page is not None else ""
