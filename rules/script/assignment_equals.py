"""A variable of a script gets a value that begins with an equals sign.

## What it finds
`NAME==VALUE` as an assignment: alone on a line, or before a command. In a Dockerfile, `ENV NAME =VALUE`: without an
equals sign at the name, all after the blank is the value.

## Why it matters on a robot
The shell takes the first `=` for the assignment and the second for the value. `CARD==$(...)` makes `CARD` `=2`, and
`aplay -D hw:$CARD` looks for the device `hw:=2`: nothing is played, and the error goes to a log that nobody reads.

## Bad
```sh
CARD==$(aplay -l | awk '/Speaker/ { print $2 }')
```

## Good
```sh
CARD=$(aplay -l | awk '/Speaker/ { print $2 }')
```

## When to ignore it
When the value is to begin with `=`. Quotes around it say so, and remove the finding.

## References
- bash(1), "PARAMETERS"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import shell_commands

DOUBLED = regex(r"[A-Za-z_]\w*==(?=[\w$`/])")


OF_ENV = regex(r"\w+[ \t]+=")


@rule("error", fix="unsafe", silent="the shell assigns the value without a message")
def assignment_equals(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        if not source.judged or source.template or "==" not in source.said:
            continue
        for command in shell_commands(source):
            for word in command.assignments:
                doubled = DOUBLED.match(word.span.text)
                if doubled is None or command.words:
                    continue
                name = doubled[0].rstrip("=")
                yield finding(
                    word,
                    f"The value of {name} begins with '=': the second equals sign is part of it",
                    advice="write one equals sign",
                    fix=fix("write one equals sign", (source.located(*_place(word.span.start, doubled.end())), "=")),
                )
    for file in robot.dockerfiles:
        for instruction in (each for stage in file.stages for each in stage.all("ENV")):
            if match := OF_ENV.match(instruction.value):
                name = next(instruction.value.words())
                yield finding(
                    instruction.value.part(*match.span()),
                    f"The value of {name} begins with '=': docker takes all after the blank for the value",
                    advice=f"write ENV {name}=VALUE",
                )


def _place(start: int, end: int) -> tuple[int, int]:
    """Where the two equals signs are."""
    return start + end - 2, start + end
