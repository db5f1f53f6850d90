"""A Dockerfile has a line that begins with no instruction.

## What it finds
A word at the start of an instruction that is none of Docker's: `WORKKDIR`, `ENTRYPIONT`, or a command of the shell
below a line that lacks the backslash at its end. Also a here-document that nothing ends. Files for another frontend
(`# syntax=`) and templates are not judged.

## Why it matters on a robot
Docker builds nothing of the file: "unknown instruction". The robot keeps the old image, or a new robot gets none.

## Bad
```dockerfile
FROM ros:jazzy-ros-base
WORKKDIR /ws
```

## Good
```dockerfile
FROM ros:jazzy-ros-base
WORKDIR /ws
```

## When to ignore it
When a tool takes the line out before it builds the image.

## References
- https://docs.docker.com/reference/dockerfile/#overview
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import INSTRUCTIONS
from bringup_lint.api.docker import Dockerfile
from bringup_lint.api.spelling import nearest

WORD = regex(r"[A-Za-z][\w-]*(?=\s|$)")
OTHER_FRONTEND = regex(r"(?im)^[ \t]*#[ \t]*syntax[ \t]*=[ \t]*(?!docker/dockerfile)")
SAID = ("unknown-instruction", "unterminated-heredoc")
MADE_UP = regex(r"(?m)^[ \t]*(?:\{%|@\[|@\{|%\w+%|<%|#(?:include|if|endif)\b|INCLUDE\+?\b)")
"""A line that a tool replaces before the build."""


@rule("error", symptoms=["unknown instruction: *", "dockerfile parse error on line *"])
def unknown_instruction(robot: Robot) -> Iterator[Finding]:
    for file in robot.dockerfiles:
        found = [each for each in file.problems if each.code in SAID]
        if found and _is_for_docker(file):
            first = found[0]
            word = WORD.match(first.where) if isinstance(first.where, Located) else None
            if first.code == "unterminated-heredoc":
                yield finding(
                    first.where,
                    f"Nothing ends the here-document '{first.detail}': docker builds nothing of this file",
                    advice=f"write {first.detail} alone on a line behind it",
                )
            elif word is not None and isinstance(first.where, Located):
                yield finding(
                    first.where.part(*word.span()),
                    f"Docker knows no instruction '{word[0]}': it builds nothing of this file",
                    advice=_advice(word[0]),
                )


def _advice(word: str) -> str:
    near = nearest(word.upper(), sorted(INSTRUCTIONS))
    return f"write {near[0]}" if near else "end the line above with a backslash, if this belongs to it"


def _is_for_docker(file: Dockerfile) -> bool:
    source = file.source
    others = OTHER_FRONTEND.search(source.text) or MADE_UP.search(source.text)
    return source.judged and not source.template and bool(file.stages) and not others
