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
from bringup_lint.api import finding
from bringup_lint.api import rule

WHAT = {
    "no-argument": "'{text}' has no value",
    "invalid-quotes": "The quotes are not closed",
    "extra-arguments": "'{text}' is one argument too many",
    "bad-match": "sshd cannot parse this Match line",
    "bad-value": "'{text}' is not {expected}",
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
        for file in sshd.files:
            for problem in file.problems:
                if problem.code in WHAT:
                    what = WHAT[problem.code].format(text=problem.where, expected=problem.detail)
                    advice = f"write {problem.detail}" if problem.code == "bad-value" else "correct the line"
                    yield finding(
                        problem.where,
                        f"{what}: sshd refuses to start, and nobody can log in",
                        advice=f"{advice}, and test with sshd -t",
                    )
