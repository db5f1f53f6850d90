"""A value that systemd cannot parse: it ignores the line, or refuses the unit.

## What it finds
A value that does not follow the grammar of its key: sizes, time spans, percentages, signals, words from a
fixed set, paths, addresses, users, environment assignments and so on. Values with placeholders or unknown
specifiers are not checked. An empty value resets the key and is valid.

## Why it matters on a robot
systemd ignores the line, and the default applies: no memory limit, a restart after 100 ms, Type=simple. Only
a message in the journal says so. For some keys, such as User= and WorkingDirectory=, the whole unit does not
load.

## Bad
```ini
[Service]
ExecStart=/usr/bin/robot-drivers
MemoryMax=2GB
RestartSec=5sek
KillSignal=sigint
```

## Good
```ini
[Service]
ExecStart=/usr/bin/robot-drivers
MemoryMax=2G
RestartSec=5s
KillSignal=SIGINT
```

## When to ignore it
Only if the robot's systemd is newer than this tool and accepts the value: `systemd-analyze verify` on the
robot shows it.

## References
- systemd.syntax(7), systemd.time(7), systemd.service(5), systemd.exec(5), systemd.resource-control(5)
- journal: "Failed to parse", "Invalid memory limit", "path is not absolute, ignoring"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import Line
from bringup_lint.api.systemd import ValueProblem


@rule(
    "error",
    fix="unsafe",
    symptoms=[
        "Failed to parse",
        "Invalid memory limit",
        "is not absolute",
        "ignoring:",
        "Failed to parse service type, ignoring:",
        "Invalid user/group name or numeric ID",
        "Unit configuration has fatal error, unit will not be started.",
    ],
)
def invalid_value(robot: Robot) -> Iterator[Finding]:
    for line in robot.units.wrong_lines:
        problems = [problem for problem in line.problems if _is_reported(line, problem)]
        if problems:
            yield _finding(line, *problems)


def _is_reported(line: Line, problem: ValueProblem) -> bool:
    if line.directive.type in ELSEWHERE or problem.code not in CODES:
        return False
    return problem.code != "odd-name" or bool({",", " "} & set(problem.where))


ELSEWHERE = frozenset({"command", "units", "install-units", "aliases", "socket-units", "documentation"})
"""Types that have rules of their own."""
CODES = frozenset(
    {"invalid", "out-of-range", "not-absolute", "not-relative", "not-normalized", "bad-unit-name", "odd-name"}
)


def _finding(line: Line, problem: ValueProblem, *others: ValueProblem) -> Finding:
    """The first problem of a line; the rest often follows from it, such as the words of a value without quotes."""
    where = problem.where
    related = [note(other.where, "not valid either") for other in others]
    shown = where if line.directive.type != "environment" else where.partition("=")[0]
    shown = shown if len(shown) <= 60 else f"{shown[:57]}..."
    message = f"{line.key}= takes {problem.expected}, not '{shown}': {line.consequence(problem)}"
    if problem.code == "odd-name":
        message = f"{line.key}= takes '{shown}' as one name, and the service fails to start"
        advice = "separate the names of a list with blanks; a single name has none"
        return finding(where, message, advice=advice, related=related)
    if problem.suggestion is None:
        return finding(where, message, advice=f"write {problem.expected}", related=related)
    meant = [(each.where, each.suggestion) for each in (problem, *others) if each.suggestion is not None]
    change = fix(f"write {problem.suggestion}", *meant)
    return finding(where, message, advice=f"write {problem.suggestion}", related=related, fix=change)
