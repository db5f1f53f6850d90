r"""An escape sequence that systemd does not know.

## What it finds
A backslash with a character behind it that is no escape of systemd, such as \d, \. or \$: in Exec lines it
is kept as it is and a warning logged, also within single quotes; in Environment= the whole line is dropped.

## Why it matters on a robot
The regular expression or dollar sign that the shell should see arrives by luck, and stops doing so when
systemd gives the sequence a meaning. In Environment= none of the variables of the line is set.

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
    for line in robot.units.lines:
        bad = [problem for problem in line.problems if problem.code == "unknown-escape"]
        if not bad:
            continue
        first = bad[0]
        dropped = first.effect != "nothing"
        edits = [(problem.where, problem.suggestion) for problem in bad if problem.suggestion]
        yield finding(
            first.where,
            f"systemd knows no escape {first.where} and "
            + ("ignores the line" if dropped else "passes it on as it stands, with a warning"),
            advice="write two backslashes for a literal one",
            severity="error" if dropped else None,
            fix=fix("double the backslash", *edits, safe=False) if edits else None,
        )
