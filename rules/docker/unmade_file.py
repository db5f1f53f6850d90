"""A build step reads a file that no step has made.

## What it finds
`cat`, `source` or `.` of a file below `/tmp` in a RUN, where nothing in the Dockerfile and no script of the tree names
the file otherwise, and nothing is copied to `/tmp`.

## Why it matters on a robot
The file does not exist. A step that ends there stops the build; in `$(cat /tmp/user)` the value is empty and the build
goes on: `chown` and `>>` then change other files than those that were meant.

## Bad
```dockerfile
RUN chown -R $(cat /tmp/container_user) /workspace
```

## Good
```dockerfile
RUN echo rover > /tmp/container_user
RUN chown -R $(cat /tmp/container_user) /workspace
```

## When to ignore it
When the base image brings the file.

## References
- https://docs.docker.com/reference/dockerfile/#run
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
from bringup_lint.api.docker import Stage

READ = regex(r"(?<![\w./-])(?:cat|source|\.)[ \t]+(?P<path>/tmp/[\w.-]+)(?![\w./*?$-])")
FILLED = regex(r"(?:^|[ \"])/tmp/?[\"\]]*$|/tmp/?[ \"]")


@rule("warning", symptoms=["cat: /tmp/"])
def unmade_file(robot: Robot) -> Iterator[Finding]:
    scripts = [source.text for source in robot.of_kind("shell-script")]
    for file in robot.dockerfiles:
        reads: dict[str, list[Located]] = {}
        for stage in file.stages:
            for path in _read(stage):
                reads.setdefault(str(path), []).append(path)
        for name, (first, *others) in reads.items():
            named = sum(len(re.findall(rf"{re.escape(name)}\b", text)) for text in _texts(file.stages))
            if named == len(others) + 1 and not _is_filled(file.stages) and not any(name in text for text in scripts):
                yield finding(
                    first,
                    f"No step makes {name}: what reads it gets nothing",
                    advice="write the file in a step before, or use an ARG",
                    related=[note(other, "read here too") for other in others],
                )


def _read(stage: Stage) -> Iterator[Located]:
    for instruction in stage.all("RUN"):
        for script in instruction.scripts:
            yield from (script.part(*match.span("path")) for match in READ.finditer(script))


def _texts(stages: list[Stage]) -> Iterator[str]:
    """What the steps say, here-documents and the stages of other files below them included."""
    for stage in dict.fromkeys(one for each in stages for one in each.chain):
        for instruction in stage.instructions:
            yield " ".join((*instruction.flags, str(instruction.value), *map(str, instruction.heredocs)))


def _is_filled(stages: list[Stage]) -> bool:
    """Whether files are copied to /tmp, so that names are not known."""
    copies = (instruction for stage in stages for one in stage.chain for instruction in one.all("COPY", "ADD"))
    return any(FILLED.search(str(instruction.value)) for instruction in copies)
