"""A value that sshd cannot parse: it refuses to start.

## What it finds
A line that sshd rejects: a value that its keyword does not accept, a keyword without a value, a quote that is
not closed, too many arguments, or a Match line that sshd cannot parse.

## Why it matters on a robot
sshd exits with an error at its next start. After the reboot nobody can log in.

## Bad
```
LoginGraceTime 30sec
```

## Good
```
LoginGraceTime 30s
```

## When to ignore it
Only if the robot's OpenSSH is newer than this tool and accepts the value: `sshd -t` on the robot shows it.

## References
- sshd_config(5)
- sshd: "unsupported option", "extra arguments at end of line"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import rule
from bringup_lint.api.schema import explained

REFUSED = "sshd refuses to start, and nobody can log in"
CORRECT = "correct the line, and test with sshd -t"
TEXTS = {
    "no-argument": (f"'{{where}}' has no value: {REFUSED}", CORRECT),
    "invalid-quotes": (f"The quotes are not closed: {REFUSED}", CORRECT),
    "extra-arguments": (f"'{{where}}' is one argument too many: {REFUSED}", CORRECT),
    "bad-match": (f"sshd cannot parse this Match line: {REFUSED}", CORRECT),
    "bad-value": (f"'{{where}}' is not {{detail}}: {REFUSED}", "write {detail}, and test with sshd -t"),
}


@rule(
    "error",
    symptoms=[
        "unsupported option",
        "extra arguments at end of line",
        "no argument after keyword",
        "Bad Match condition",
    ],
)
def bad_value(robot: Robot) -> Iterator[Finding]:
    for sshd in robot.sshd:
        yield from explained(sshd.problems, TEXTS)
