r"""An escape sequence that systemd does not know.

## What it finds
A backslash before a character with which it forms no escape of systemd, such as \d, \. or \$. In Exec lines,
also within single quotes, systemd keeps it and logs a warning. In Environment= it ignores the whole line,
which is an error.

## Why it matters on a robot
The regular expression or dollar sign reaches the shell only by luck: systemd may give the sequence a meaning
one day. In Environment=, systemd sets none of the variables of the line.

## Bad
```ini
[Service]
ExecStart=/bin/bash -c 'ls /dev | grep "ttyUSB\d"'
```

## Good
```ini
[Service]
ExecStart=/bin/bash -c 'ls /dev | grep "ttyUSB\\d"'
```

## When to ignore it
In Exec lines, when the warning in the journal does no harm. Never in Environment=.

## References
- systemd.service(5), "Command lines"; systemd.syntax(7), "Quoting"
- journal: "Ignoring unknown escape sequences"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("warning", fix="unsafe", symptoms=["Ignoring unknown escape sequences"])
def unknown_escape(robot: Robot) -> Iterator[Finding]:
    for line in robot.units.wrong_lines:
        bad = [problem for problem in line.problems if problem.code == "unknown-escape"]
        if not bad:
            continue
        first = bad[0]
        dropped = first.effect != "nothing"
        edits = [(problem.where, problem.suggestion) for problem in bad if problem.suggestion]
        yield finding(
            first.where,
            f"systemd does not know the escape {first.where} and "
            + ("ignores the line" if dropped else "passes it on unchanged, with a warning"),
            advice="write two backslashes for a literal one",
            severity="error" if dropped else None,
            fix=fix("double the backslash", *edits, safe=False) if edits else None,
        )
