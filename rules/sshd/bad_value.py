"""A value that sshd cannot read: it refuses to start.

## What it finds
A value outside the set of its keyword, a keyword without a value, a quote that is left open, words too
many, a Match line that sshd cannot read.

## Why it matters on a robot
sshd ends with an error at its next start, and after the reboot nobody gets in.

## Bad
```
LoginGraceTime 30sec
```

## Good
```
LoginGraceTime 30s
```

## References
- sshd_config(5)
- sshd: "unsupported option", "extra arguments at end of line"
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

WHAT = {
    "no-argument": "'{text}' has no value",
    "invalid-quotes": "The quotes are not closed",
    "extra-arguments": "'{text}' is a word too many",
    "bad-match": "sshd cannot read this Match line",
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
def bad_value(robot: Robot):
    for sshd in robot.sshd:
        for file in sshd.files:
            for problem in file.problems:
                if problem.code in WHAT:
                    what = WHAT[problem.code].format(text=problem.where, expected=problem.detail)
                    advice = f"write {problem.detail}" if problem.code == "bad-value" else "correct the line"
                    yield finding(
                        problem.where,
                        f"{what}: sshd refuses to start, and nobody gets in any more",
                        advice=f"{advice}; try with sshd -t",
                    )
