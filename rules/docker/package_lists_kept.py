"""A step removes the lists of apt at a path that does not exist.

## What it finds
`rm` in a Dockerfile of a folder below `/var/lib/apt` that is called nearly like `lists`, such as `/var/lib/apt/list/*`.

## Why it matters on a robot
`rm -f` says nothing about what is not there. The lists stay in the layer: some 40 MB more for each robot to pull over
its radio, and packages of last month for an `apt-get install` that a later image runs without an update.

## Bad
```dockerfile
RUN apt-get update && apt-get install -y ros-jazzy-joy && rm -rf /var/lib/apt/list/*
```

## Good
```dockerfile
RUN apt-get update && apt-get install -y ros-jazzy-joy && rm -rf /var/lib/apt/lists/*
```

## When to ignore it
Never: write the path, or remove the command.

## References
- https://docs.docker.com/build/building/best-practices/#apt-get
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import regex
from bringup_lint.api import rule

REMOVED = regex(
    r"\brm[ \t]{1,4}(?:-[a-zA-Z-]{1,20}[ \t]{1,4}){1,4}/var/lib/apt/"
    r"(?P<name>list|lits|lsits|lisst|listss|listes|litss|listst|lsit|Lists)(?![\w-])"
)


@rule("warning", fix="safe", silent="rm -f says nothing of files that do not exist")
def package_lists_kept(robot: Robot) -> Iterator[Finding]:
    for source in (each for each in robot.of_kind("dockerfile") if each.judged):
        yield from _finding(source)


def _finding(source: Source) -> Iterator[Finding]:
    for match in REMOVED.finditer(source.text):
        name = source.located(*match.span("name"))
        if not source.line_before(match.start()).lstrip().startswith("#"):
            yield finding(
                name,
                f"rm removes nothing: there is no /var/lib/apt/{name}, and the package lists stay in the image",
                advice="write /var/lib/apt/lists",
                fix=fix("write lists", (name, "lists")),
            )
